#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "probe/metrology/circle_evaluation.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_path.h"
#include "tools/evaluate/recorded_path.h"
#include "tools/plot/path_plot.h"
#include "tools/plot/words.h"

namespace g31::evaluate {
namespace {

constexpr double kMicro = 1e6;
constexpr double kMsPerS = 1e3;

std::optional<double> um_wide(const std::optional<metrology::Extremes>& extremes) {
  return extremes ? std::optional(kUmPerMm * extremes->width()) : std::nullopt;
}

using Axes = std::array<std::string, 2>;

void add_estimates(const metrology::CircleFit& fit, const Axes& axes,
                   std::vector<Quantity>& results) {
  const metrology::CircleErrors& errors = fit.errors;
  for (std::size_t i : {0U, 1U}) {
    results.push_back({"backlash_" + axes.at(i), kUmPerMm * errors.backlash.at(i), "um",
                       kUmPerMm * fit.u.backlash.at(i)});
  }
  for (std::size_t i : {0U, 1U}) {
    results.push_back(
        {"scale_" + axes.at(i), kMicro * errors.scale.at(i), "um/m", kMicro * fit.u.scale.at(i)});
  }
  results.push_back({"squareness", kMicro * errors.squareness, "um/m", kMicro * fit.u.squareness});
  if (fit.has_mismatch) {
    results.push_back(
        {"servo_mismatch", kMsPerS * errors.mismatch, "ms", kMsPerS * fit.u.mismatch});
  } else {
    results.push_back({"servo_mismatch", std::nullopt, "ms"});
  }
}

/// a sin(2 pi x / p) + b cos(2 pi x / p) is an amplitude and a phase.
void add_cyclic(const metrology::CircleFit& fit, const Axes& axes, std::vector<Quantity>& results) {
  for (const std::size_t i : {0U, 1U}) {
    if (!fit.errors.pitches.at(i)) {
      continue;
    }
    const auto [sine, cosine] = fit.errors.cyclic.at(i);
    const auto [u_sine, u_cosine] = fit.u.cyclic.at(i);
    const double amplitude = std::hypot(sine, cosine);
    const bool has_phase = amplitude > 0.0;
    // Of nothing either part is as uncertain as the other.
    const double along = has_phase ? std::hypot(sine * u_sine, cosine * u_cosine) / amplitude
                                   : std::max(u_sine, u_cosine);
    results.push_back({"cyclic_" + axes.at(i), kUmPerMm * amplitude, "um", kUmPerMm * along});
    Quantity phase{"cyclic_phase_" + axes.at(i), std::nullopt, "deg"};
    if (has_phase) {
      const double across = std::hypot(cosine * u_sine, sine * u_cosine) / amplitude;
      // The screw stands half the backlash beside the middle of both ways.
      const double by_backlash =
          std::numbers::pi * fit.u.backlash.at(i) / *fit.errors.pitches.at(i);
      phase.value = std::atan2(cosine, sine) / metrology::kDegree;
      phase.u = std::hypot(across / amplitude, by_backlash) / metrology::kDegree;
    }
    results.push_back(std::move(phase));
  }
}

std::vector<Quantity> results_of(const metrology::CircleEvaluation& circle, const Axes& axes) {
  const metrology::CircleErrors& errors = circle.fit.errors;
  const metrology::CircleErrors& u = circle.fit.u;
  std::optional<double> hysteresis;
  std::optional<double> both_ways;
  if (circle.directions) {
    hysteresis = circle.directions->hysteresis;
    both_ways = circle.directions->mean;
  }
  std::vector<Quantity> results = {
      {"radial_error_max", um(circle.radial_error.greatest), "um"},
      {"radial_error_min", um(circle.radial_error.least), "um"},
      {"circular_error", um(circle.radial_error.width()), "um"},
      {"circular_error_cw", um_wide(circle.cw), "um"},
      {"circular_error_ccw", um_wide(circle.ccw), "um"},
      {"minimum_zone", um(circle.minimum_zone), "um"},
      {"minimum_zone_cw", um(circle.minimum_zone_cw), "um"},
      {"minimum_zone_ccw", um(circle.minimum_zone_ccw), "um"},
      {"hysteresis", um(hysteresis), "um"},
      {"mean_radial_error", um(circle.mean_radial_error), "um"},
      {"mean_bidirectional_error", um(both_ways), "um"},
      {"radius", errors.radius * (1.0 + 0.5 * (errors.scale[0] + errors.scale[1])), "mm"},
      {"centre_" + lower(axes[0]), errors.centre.x(), "mm", u.centre.x()},
      {"centre_" + lower(axes[1]), errors.centre.y(), "mm", u.centre.y()},
      {"reference_centre_" + lower(axes[0]), circle.reference.centre.x(), "mm"},
      {"reference_centre_" + lower(axes[1]), circle.reference.centre.y(), "mm"},
      {"spike_" + axes[0], um(circle.spike[0]), "um"},
      {"spike_" + axes[1], um(circle.spike[1]), "um"}};
  add_estimates(circle.fit, axes, results);
  add_cyclic(circle.fit, axes, results);
  return results;
}

/// Radial errors along the circle, the place counted counter-clockwise from the first axis.
std::vector<Curve> curves_of(const metrology::CircleEvaluation& circle,
                             const metrology::PlaneSamples& samples) {
  Curve ccw{"ccw", {}};
  Curve cw{"cw", {}};
  for (const metrology::CircleTurn& turn : circle.turns) {
    Curve& curve = turn.direction > 0 ? ccw : cw;
    for (std::size_t i = turn.begin; i < turn.end; ++i) {
      const Eigen::Vector2d q = samples.at(i) - circle.reference.centre;
      curve.points.push_back(
          {circle.reference.radius * std::atan2(q.y(), q.x()), q.norm() - circle.reference.radius});
    }
  }
  return {std::move(ccw), std::move(cw)};
}

/// Whether the path stood still between two pieces.
bool stands_still(const metrology::PlaneSamples& samples, const metrology::CircleTurn& before,
                  const metrology::CircleTurn& behind, double radius) {
  const double most = 3.0 * metrology::kStandstill * radius;
  const Eigen::Vector2d from = samples.at(before.end - 1);
  for (std::size_t i = before.end; i <= behind.begin; ++i) {
    if ((samples.at(i) - from).norm() > most) {
      return false;
    }
  }
  return true;
}

/// What lies between two turns the same way round and off the circle: a jump of the record, or a
/// way to the middle and back.
std::optional<std::string> note_of_strays(const metrology::CircleEvaluation& circle,
                                          const metrology::PlaneSamples& samples) {
  std::size_t strays = 0;
  double furthest = 0.0;
  for (std::size_t turn = 1; turn < circle.turns.size(); ++turn) {
    const metrology::CircleTurn& before = circle.turns[turn - 1];
    const metrology::CircleTurn& behind = circle.turns[turn];
    if (before.direction != behind.direction ||
        stands_still(samples, before, behind, circle.reference.radius)) {
      continue;
    }
    strays += behind.begin - before.end;
    for (std::size_t i = before.end; i < behind.begin; ++i) {
      const Eigen::Vector2d q = samples.at(i) - circle.reference.centre;
      furthest = std::max(furthest, std::abs(q.norm() - circle.reference.radius));
    }
  }
  return strays > 0 ? std::optional(fmt::format(
                          "{} of {} samples lie between pieces of the circle, up to {:.3f} mm off "
                          "it, and do not count",
                          strays, samples.size(), furthest))
                    : std::nullopt;
}

std::vector<std::string> notes_of(const metrology::CircleEvaluation& circle, const Request& request,
                                  const metrology::PlaneSamples& plane_samples) {
  const std::size_t samples = plane_samples.size();
  std::vector<std::string> notes;
  std::size_t on_circle = 0;
  for (const metrology::CircleTurn& turn : circle.turns) {
    on_circle += turn.end - turn.begin;
  }
  // Standstill at the ends is nothing to speak of.
  if (on_circle + samples / 50 < samples) {
    notes.push_back(fmt::format("{} of {} samples lie on the circle, the others do not count",
                                on_circle, samples));
  }
  if (auto strays = note_of_strays(circle, plane_samples)) {
    notes.push_back(*std::move(strays));
  }
  if (!circle.fit.has_mismatch) {
    notes.emplace_back(
        "only one direction: servo_mismatch, which cannot be separated from squareness, is "
        "taken as 0");
  }
  constexpr double kMuchMore = 1.1;
  if (circle.minimum_zone && circle.radial_error.width() > kMuchMore * *circle.minimum_zone) {
    notes.emplace_back(
        "circular_error counts from reference_centre; about the best centre it is minimum_zone");
  }
  notes.emplace_back(request.radius
                         ? "scale includes what the feed takes from the radius"
                         : "without --radius the scales are half their difference, up and down");
  return notes;
}

std::string drawing_of(const metrology::CircleEvaluation& circle,
                       const metrology::PlaneSamples& samples, const Request& request,
                       const Evaluation& evaluation) {
  const metrology::Circle& reference = circle.reference;
  plot::PathPlot chart;
  chart.language = request.language;
  chart.growth = request.growth;
  chart.title = said(request.language, plot::Word::TitleCircle,
                     fmt::arg("radius", fmt::format("{:.6g}", reference.radius)));
  chart.axes = request.plane;
  chart.centre = {reference.centre.x(), reference.centre.y()};
  chart.nominal_radius = [&](double) { return reference.radius; };
  chart.has_rings = true;
  chart.magnification = request.magnify;
  chart.detail = request.detail;
  chart.facts = facts_of(evaluation);
  std::array<bool, 2> is_named = {};
  for (const metrology::CircleTurn& turn : circle.turns) {
    const std::size_t colour = turn.direction > 0 ? 0 : 1;
    plot::PathTrace trace;
    if (!std::exchange(is_named.at(colour), true)) {
      trace.name =
          text_of(turn.direction > 0 ? plot::Word::CounterClockwise : plot::Word::Clockwise,
                  request.language);
    }
    trace.colour = colour;
    for (std::size_t i = turn.begin; i < turn.end; ++i) {
      trace.points.push_back(samples.at(i) - reference.centre);
      trace.deviations.push_back(trace.points.back().norm() - reference.radius);
    }
    chart.traces.push_back(std::move(trace));
  }
  return plot::draw(chart);
}

}  // namespace

PathEvaluation evaluate_circle(const RecordedPath& path, const Request& request) {
  const metrology::PlaneSamples samples = path.samples();
  const auto circle = metrology::evaluate_circle(
      samples, {request.radius, point_of(request.centre), path.resolution, request.pitches});
  if (!circle) {
    return circle.error();
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Circle;
  evaluation.samples = samples.size();
  evaluation.results = results_of(circle.value(), request.plane);
  if (request.wants_curves) {
    evaluation.curves = curves_of(circle.value(), samples);
  }
  evaluation.notes = notes_of(circle.value(), request, samples);
  if (request.wants_drawing) {
    evaluation.svg = drawing_of(circle.value(), samples, request, evaluation);
  }
  return evaluation;
}

}  // namespace g31::evaluate
