#include "probe/metrology/circle_evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "probe/metrology/circle_ranges.h"
#include "probe/metrology/circle_search.h"
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

double angle_of(const std::vector<CircleTurn>& turns) {
  double angle = 0.0;
  for (const CircleTurn& turn : turns) {
    angle += turn.angle;
  }
  return angle;
}

/// Adds to each uncertainty what its error changes by between two fits, as far as noise does not
/// account for it: the second one, of part of the samples, is off the first by the difference of
/// their variances.
void add_change(CircleFit& fit, const CircleFit& other) {
  const auto join = [](double& u, double change, double u_other) {
    const double by_noise = std::max(0.0, u_other * u_other - u * u);
    u = std::sqrt(u * u + std::max(0.0, change * change - by_noise));
  };
  CircleErrors& u = fit.u;
  const CircleErrors& was = fit.errors;
  const CircleErrors& is = other.errors;
  for (const Eigen::Index i : {0, 1}) {
    join(u.centre[i], was.centre[i] - is.centre[i], other.u.centre[i]);
  }
  for (const std::size_t i : {0U, 1U}) {
    join(u.scale.at(i), was.scale.at(i) - is.scale.at(i), other.u.scale.at(i));
    join(u.backlash.at(i), was.backlash.at(i) - is.backlash.at(i), other.u.backlash.at(i));
  }
  join(u.radius, was.radius - is.radius, other.u.radius);
  join(u.squareness, was.squareness - is.squareness, other.u.squareness);
  join(u.mismatch, was.mismatch - is.mismatch, other.u.mismatch);
}

/// The same with more of the way behind the reversals left out, as far as enough of it remains.
void add_change_of_windows(const PlaneSamples& samples, const ReversalWindows& windows,
                           const CircleTask& task, CircleEvaluation& evaluation) {
  constexpr double kFurther = 10.0 * kDegree;
  ReversalWindows wider = windows;
  for (double& window : wider) {
    window += kFurther;
  }
  const auto ranges = described_ranges(samples, evaluation.turns, task.start.centre, wider);
  if (const auto fit = fit_circle(samples, evaluation.turns, ranges, task)) {
    add_change(evaluation.fit, *fit);
  }
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
  const auto found = search_circle(samples);
  if (!found) {
    return std::string("the path is not a circle");
  }
  CircleEvaluation evaluation;
  evaluation.turns = circle_turns(samples, *found);
  if (angle_of(evaluation.turns) < kLeastAngle) {
    return std::string("less than half a circle was recorded");
  }
  // The windows are found with a part of a long record, the errors with all of it.
  constexpr std::size_t kEnough = 50'000;
  CircleTask task{request.radius,
                  {found->centre, found->radius},
                  request.resolution,
                  samples.size() / kEnough + 1};
  ReversalWindows windows = first_windows(found->radius);
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const auto ranges = described_ranges(samples, evaluation.turns, task.start.centre, windows);
    const auto fit = fit_circle(samples, evaluation.turns, ranges, task);
    if (!fit) {
      return std::string("too few samples of the circle lie away from its ends and the reversals");
    }
    evaluation.fit = *fit;
    task.start = fit->errors;
    if (round + 2 < kRounds) {
      windows = reversal_windows(samples, evaluation.turns, *fit);
    } else {
      task.stride = 1;
    }
  }
  add_change_of_windows(samples, windows, task, evaluation);
  evaluation.spike = reversal_spikes(samples, evaluation.turns, evaluation.fit, windows);
  evaluation.reference.centre = request.centre.value_or(evaluation.fit.errors.centre);
  evaluation.reference.radius = request.radius.value_or(evaluation.fit.errors.radius);
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
