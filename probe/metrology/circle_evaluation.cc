#include "probe/metrology/circle_evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "probe/metrology/circle_leads.h"
#include "probe/metrology/circle_ranges.h"
#include "probe/metrology/circle_search.h"
#include "probe/metrology/circle_uncertainty.h"
#include "probe/metrology/least_squares_circle.h"
#include "probe/metrology/minimum_zone_circle.h"

namespace g31::metrology {
namespace {

constexpr double kLeastAngle = std::numbers::pi;

/// The radial errors of the turns, gathered.
class RadialErrors {
 public:
  explicit RadialErrors(CircleEvaluation& evaluation) : evaluation_(evaluation) {}

  void add(const PlaneSamples& samples, const CircleTurn& turn) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Extremes extremes{kInfinity, -kInfinity};
    double area = 0.0;
    double before = 0.0;
    double angle_before = 0.0;
    for (std::size_t i = turn.begin; i < turn.end; ++i) {
      const Eigen::Vector2d q = samples.at(i) - evaluation_.reference.centre;
      const double error = q.norm() - evaluation_.reference.radius;
      const double angle = std::atan2(q.y(), q.x());
      extremes = {std::min(extremes.least, error), std::max(extremes.greatest, error)};
      if (i > turn.begin) {
        const double step = shorter_way(angle - angle_before);
        area += 0.5 * (error + before) * std::abs(step);
        angle_ += std::abs(step);
      }
      before = error;
      angle_before = angle;
    }
    area_ += area;
    join(turn.direction > 0 ? evaluation_.ccw : evaluation_.cw, extremes);
  }

  void finish() {
    evaluation_.mean_radial_error = area_ / angle_;
    std::optional<Extremes> all;
    for (const auto& one : {evaluation_.ccw, evaluation_.cw}) {
      if (one) {
        join(all, *one);
      }
    }
    evaluation_.radial_error = *all;
  }

 private:
  static void join(std::optional<Extremes>& all, const Extremes& more) {
    all = all ? Extremes{std::min(all->least, more.least), std::max(all->greatest, more.greatest)}
              : more;
  }

  CircleEvaluation& evaluation_;
  double area_ = 0.0;
  double angle_ = 0.0;
};

/// Of least squares, as a whole turn makes it.  Of less than that it would go with the form of the
/// arc, and what the model says counts.
Circle reference_of(const PlaneSamples& samples, const CircleEvaluation& evaluation) {
  const Circle of_model{evaluation.fit.errors.centre, evaluation.fit.errors.radius};
  const bool is_whole =
      pass_whole_turn(evaluation.turns, 1) || pass_whole_turn(evaluation.turns, -1);
  return is_whole ? least_squares_circle(samples, evaluation.turns, of_model) : of_model;
}

void add_minimum_zones(const PlaneSamples& samples, CircleEvaluation& evaluation) {
  const auto zone_of = [&](int direction) -> std::optional<double> {
    std::vector<CircleTurn> turns;
    std::ranges::copy_if(evaluation.turns, std::back_inserter(turns), [&](const CircleTurn& turn) {
      return direction == 0 || turn.direction == direction;
    });
    return turns.empty() ? std::nullopt : minimum_zone_of(samples, turns, evaluation.reference);
  };
  evaluation.minimum_zone = zone_of(0);
  evaluation.minimum_zone_ccw = zone_of(1);
  evaluation.minimum_zone_cw = zone_of(-1);
}

}  // namespace

Result<CircleEvaluation, std::string> evaluate_circle(const PlaneSamples& samples,
                                                      const CircleRequest& request) {
  const auto found = find_circle(samples);
  if (!found) {
    return std::string("the path is not a circle");
  }
  const Circle& circle = found->circle;
  CircleEvaluation evaluation;
  // The windows are found with a part of a long record, the errors with all of it.
  constexpr std::size_t kEnough = 50'000;
  CircleTask task{request.radius,
                  {circle.centre, circle.radius},
                  request.resolution,
                  samples.size() / kEnough + 1};
  task.start.pitches = request.pitches;
  evaluation.turns = without_leads(samples, *found, task);
  if (angle_of(evaluation.turns, 1) + angle_of(evaluation.turns, -1) < kLeastAngle) {
    return std::string("less than half a circle was recorded");
  }
  ReversalWindows windows = first_windows(circle.radius);
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const auto ranges =
        described_ranges(samples, evaluation.turns, task.start.centre, windows, Ends::LeftOut);
    const auto fit = fit_circle(samples, evaluation.turns, ranges, task);
    if (!fit) {
      return std::string("too few samples of the circle lie away from its ends and the reversals");
    }
    evaluation.fit = *fit;
    task.start = fit->errors;
    if (round + 1 < kRounds) {
      refine_speeds(samples, ranges, fit->errors, evaluation.turns);
    }
    if (round + 2 < kRounds) {
      windows = reversal_windows(samples, evaluation.turns, *fit);
    } else {
      task.stride = 1;
    }
  }
  add_systematic({samples, evaluation.turns, windows, task}, evaluation.fit);
  evaluation.spike = reversal_spikes(samples, evaluation.turns, evaluation.fit, windows);
  const Circle fitted = reference_of(samples, evaluation);
  evaluation.reference.centre = request.centre.value_or(fitted.centre);
  evaluation.reference.radius = request.radius.value_or(fitted.radius);
  evaluation.directions = compare_directions(samples, evaluation.turns, evaluation.reference);
  RadialErrors errors(evaluation);
  for (const CircleTurn& turn : evaluation.turns) {
    errors.add(samples, turn);
  }
  errors.finish();
  add_minimum_zones(samples, evaluation);
  return evaluation;
}

}  // namespace g31::metrology
