#include <algorithm>
#include <cmath>

#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_path.h"

namespace g31::evaluate {
namespace {

constexpr double kUsualLength = 300.0;  // mm, what limits of squareness are given on

/// How far the way lies to the left of the straight one from the origin to the target.
Curve across(const DataTable& table, const Request& request) {
  const auto [x, y] = *request.target;
  const double length = std::max(std::hypot(x, y), 1e-300);
  const std::vector<double>& at_x = table.numbers(request.plane[0]);
  const std::vector<double>& at_y = table.numbers(request.plane[1]);
  Curve curve{"across", {}};
  for (std::size_t i = 0; i < at_x.size(); ++i) {
    curve.points.push_back(
        {(at_x[i] * x + at_y[i] * y) / length, (at_y[i] * x - at_x[i] * y) / length});
  }
  return curve;
}

}  // namespace

Result<Evaluation, DataError> evaluate_diagonal(const DataFile& file, const Request& request) {
  std::vector<WantedColumn> wanted;
  for (const std::string& axis : request.plane) {
    wanted.push_back({axis, ColumnKind::Length, axis + "_true"});
  }
  const auto table = read_table(file, wanted, request.columns);
  if (!table) {
    return table.error();
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Diagonal;
  evaluation.samples = table.value().size();
  std::vector<Quantity> scaled;
  for (std::size_t i : {0U, 1U}) {
    const std::string& axis = request.plane.at(i);
    const double target = request.target->at(i);
    const double error = table.value().numbers(axis).back() - target;
    const double factor = request.on.value_or(kUsualLength) / std::abs(target);
    evaluation.results.push_back({"error_" + axis, um(error), "um"});
    scaled.push_back(
        {"error_" + axis + "_on", target != 0.0 ? um(error * factor) : std::nullopt, "um"});
  }
  evaluation.results.insert(evaluation.results.end(), scaled.begin(), scaled.end());
  evaluation.curves = {across(table.value(), request)};
  if (request.wants_drawing) {
    evaluation.svg = deviation_chart(evaluation, "Straight move in two axes",
                                     "way from the origin towards the target mm");
  }
  return evaluation;
}

}  // namespace g31::evaluate
