#include <cmath>

#include <fmt/format.h>

#include "probe/metrology/square_path.h"
#include "tools/evaluate/evaluate_path.h"
#include "tools/evaluate/recorded_path.h"

namespace g31::evaluate {
namespace {

/// So near the square a sample is of it, in half sides.
constexpr double kNearTheSquare = 0.2;

std::vector<Quantity> results_of(const metrology::SquareEvaluation& evaluation,
                                 const Request& request) {
  std::vector<Quantity> results;
  std::optional<double> largest;
  for (std::size_t corner = 0; corner < evaluation.corner_error.size(); ++corner) {
    const auto error = um(evaluation.corner_error.at(corner));
    results.push_back({fmt::format("corner_error_{}", corner + 1), error, "um"});
    if (error && (!largest || std::abs(*error) > std::abs(*largest))) {
      largest = error;
    }
  }
  const metrology::Square& square = evaluation.square;
  results.push_back({"corner_error_max", largest, "um"});
  results.push_back({"side", 2.0 * square.half_side, "mm"});
  results.push_back({"centre_" + lower(request.plane[0]), square.centre.x(), "mm"});
  results.push_back({"centre_" + lower(request.plane[1]), square.centre.y(), "mm"});
  return results;
}

/// Errors along the ray from the centre, by the way round the square.
Curve ray_errors(const metrology::Square& square, const metrology::PlaneSamples& samples) {
  Curve curve{"path", {}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d q = samples.at(i) - square.centre;
    if (std::abs(q.cwiseAbs().maxCoeff() - square.half_side) <= kNearTheSquare * square.half_side) {
      curve.points.push_back({square.place_of(samples.at(i)), square.ray_error(samples.at(i))});
    }
  }
  return curve;
}

}  // namespace

Result<Evaluation, DataError> evaluate_square(const DataFile& file, const Request& request) {
  const auto path = read_path(file, request);
  if (!path) {
    return path.error();
  }
  const metrology::PlaneSamples samples = path.value().samples();
  const auto square = metrology::evaluate_square(samples, {request.side, point_of(request.centre)});
  if (!square) {
    return data_error(DataErrorId::CannotEvaluate, file, {}, {square.error()});
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Square;
  evaluation.samples = samples.size();
  evaluation.results = results_of(square.value(), request);
  evaluation.curves = {ray_errors(square.value().square, samples)};
  return evaluation;
}

}  // namespace g31::evaluate
