#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_path.h"

namespace g31::evaluate {
namespace {

constexpr double kUsualLength = 300.0;  // mm, what limits of squareness are given on

/// How far the way lies to the left of the straight one from the origin to the target.
Curve across(const RecordedPath& path, const Request& request) {
  const auto [x, y] = *request.target;
  const double length = std::max(std::hypot(x, y), 1e-300);
  Curve curve{"across", {}};
  for (std::size_t i = 0; i < path.x.size(); ++i) {
    curve.points.push_back(
        {(path.x[i] * x + path.y[i] * y) / length, (path.y[i] * x - path.x[i] * y) / length});
  }
  return curve;
}

}  // namespace

PathEvaluation evaluate_diagonal(const RecordedPath& path, const Request& request) {
  G31_EXPECTS(request.target && !path.x.empty());
  Evaluation evaluation;
  evaluation.kind = Kind::Diagonal;
  evaluation.samples = path.x.size();
  std::vector<Quantity> scaled;
  for (std::size_t i : {0U, 1U}) {
    const std::string& axis = request.plane.at(i);
    const double target = request.target->at(i);
    const double error = (i == 0 ? path.x : path.y).back() - target;
    const double factor = request.on.value_or(kUsualLength) / std::abs(target);
    evaluation.results.push_back({"error_" + axis, um(error), "um"});
    scaled.push_back(
        {"error_" + axis + "_on", target != 0.0 ? um(error * factor) : std::nullopt, "um"});
  }
  evaluation.results.insert(evaluation.results.end(), scaled.begin(), scaled.end());
  evaluation.curves = {across(path, request)};
  if (request.wants_drawing) {
    evaluation.svg =
        deviation_chart(evaluation, {plot::Word::TitleDiagonal, plot::Word::WayToTarget}, request);
  }
  return evaluation;
}

}  // namespace g31::evaluate
