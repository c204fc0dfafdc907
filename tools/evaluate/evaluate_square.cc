#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "probe/metrology/square_path.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_path.h"
#include "tools/evaluate/recorded_path.h"
#include "tools/plot/path_plot.h"
#include "tools/plot/words.h"

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

bool is_near(const metrology::Square& square, const Eigen::Vector2d& p) {
  const double widest = (p - square.centre).cwiseAbs().maxCoeff();
  return std::abs(widest - square.half_side) <= kNearTheSquare * square.half_side;
}

/// Errors along the ray from the centre, by the way round the square.
Curve ray_errors(const metrology::SquareEvaluation& found, const metrology::PlaneSamples& samples) {
  const metrology::Square& square = found.square;
  Curve curve{"path", {}};
  for (std::size_t i = found.on_square.begin; i < found.on_square.end; ++i) {
    if (is_near(square, samples.at(i))) {
      curve.points.push_back({square.place_of(samples.at(i)), square.ray_error(samples.at(i))});
    }
  }
  return curve;
}

std::string drawing_of(const metrology::SquareEvaluation& found,
                       const metrology::PlaneSamples& samples, const Request& request,
                       const Evaluation& evaluation) {
  const metrology::Square& square = found.square;
  plot::PathPlot chart;
  chart.language = request.language;
  chart.growth = request.growth;
  chart.title = said(request.language, plot::Word::TitleSquare,
                     fmt::arg("side", fmt::format("{:.6g}", 2.0 * square.half_side)));
  chart.axes = request.plane;
  chart.centre = {square.centre.x(), square.centre.y()};
  chart.nominal_radius = [&](double angle) {
    return square.half_side / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
  };
  chart.magnification = request.magnify;
  chart.detail = request.detail;
  chart.facts = facts_of(evaluation);
  plot::PathTrace trace{std::string(text_of(plot::Word::Path, request.language)), {}, {}};
  for (std::size_t i = found.on_square.begin; i < found.on_square.end; ++i) {
    if (is_near(square, samples.at(i))) {
      trace.points.push_back(samples.at(i) - square.centre);
      trace.deviations.push_back(square.ray_error(samples.at(i)));
    }
  }
  chart.traces = {std::move(trace)};
  return plot::draw(chart);
}

}  // namespace

PathEvaluation evaluate_square(const RecordedPath& path, const Request& request) {
  const metrology::PlaneSamples samples = path.samples();
  const auto square = metrology::evaluate_square(samples, {request.side, point_of(request.centre)});
  if (!square) {
    return square.error();
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Square;
  evaluation.samples = samples.size();
  evaluation.results = results_of(square.value(), request);
  if (request.wants_curves) {
    evaluation.curves = {ray_errors(square.value(), samples)};
  }
  if (request.wants_drawing) {
    evaluation.svg = drawing_of(square.value(), samples, request, evaluation);
  }
  return evaluation;
}

}  // namespace g31::evaluate
