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

/// The corners of which the path is not known between two samples, and what that may come to; as
/// `sign` says, those taken as sharp (-1) or those taken as straight (+1).
struct UnseenCorners {
  std::string names;
  double furthest_um = 0.0;
};

UnseenCorners unseen_corners(const metrology::SquareEvaluation& found, double sign) {
  constexpr double kWorthSaying = 1.0;  // um
  constexpr double kOfTheError = 0.01;
  UnseenCorners unseen;
  for (std::size_t corner = 0; corner < found.corner_unseen.size(); ++corner) {
    const double by = kUmPerMm * sign * found.corner_unseen.at(corner);
    const double error = kUmPerMm * found.corner_error.at(corner).value_or(0.0);
    if (by > std::max(kWorthSaying, kOfTheError * std::abs(error))) {
      unseen.names +=
          fmt::format("{}corner_error_{}", unseen.names.empty() ? "" : ", ", corner + 1);
      unseen.furthest_um = std::max(unseen.furthest_um, by);
    }
  }
  return unseen;
}

std::vector<std::string> notes_of(const metrology::SquareEvaluation& found, std::size_t samples) {
  std::vector<std::string> notes;
  const std::size_t on_square = found.on_square.end - found.on_square.begin;
  // Standstill at the ends is nothing to speak of.
  if (on_square + samples / 50 < samples) {
    notes.push_back(fmt::format("{} of {} samples lie on the square, the others do not count",
                                on_square, samples));
  }
  if (const UnseenCorners sharp = unseen_corners(found, -1.0); !sharp.names.empty()) {
    notes.push_back(fmt::format(
        "{}: the path turns between two samples and is taken to be sharp there; were it rounded, "
        "by up to {:.1f} um further inside, no sample would show it",
        sharp.names, sharp.furthest_um));
  }
  if (const UnseenCorners straight = unseen_corners(found, 1.0); !straight.names.empty()) {
    notes.push_back(fmt::format(
        "{}: the path is rounded there and too few samples show how; it is taken to be straight "
        "between them and may cross the diagonal up to {:.1f} um further out",
        straight.names, straight.furthest_um));
  }
  return notes;
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
  const auto square = metrology::evaluate_square(
      samples, {request.side, point_of(request.centre), path.resolution});
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
  evaluation.notes = notes_of(square.value(), samples.size());
  if (request.wants_drawing) {
    evaluation.svg = drawing_of(square.value(), samples, request, evaluation);
  }
  return evaluation;
}

}  // namespace g31::evaluate
