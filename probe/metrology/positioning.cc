#include "probe/metrology/positioning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace g31::metrology {
namespace {

/// The least and the greatest of numbers that come one by one.
class Span {
 public:
  void take(double value) {
    low_ = is_empty_ ? value : std::min(low_, value);
    high_ = is_empty_ ? value : std::max(high_, value);
    is_empty_ = false;
  }
  [[nodiscard]] double width() const { return high_ - low_; }

 private:
  double low_ = 0.0;
  double high_ = 0.0;
  bool is_empty_ = true;
};

DirectionStatistics statistics_of(const std::vector<double>& deviations) {
  double sum = 0.0;
  for (const double x : deviations) {
    sum += x;
  }
  const double mean = sum / static_cast<double>(deviations.size());
  double square = 0.0;
  for (const double x : deviations) {
    square += (x - mean) * (x - mean);
  }
  return {mean, std::sqrt(square / static_cast<double>(deviations.size() - 1)), deviations.size()};
}

using Direction = std::optional<DirectionStatistics> TargetStatistics::*;

bool all_have(const std::vector<TargetStatistics>& targets, Direction direction) {
  return std::ranges::all_of(
      targets, [&](const TargetStatistics& target) { return (target.*direction).has_value(); });
}

/// A, E and R of what is given, one direction or both.
struct Figures {
  Span means;
  Span limits;
  double repeatability = 0.0;

  void take(const DirectionStatistics& one) {
    means.take(one.mean);
    limits.take(one.mean + 2.0 * one.s);
    limits.take(one.mean - 2.0 * one.s);
    repeatability = std::max(repeatability, 4.0 * one.s);
  }
};

Figures figures_of(const std::vector<TargetStatistics>& targets, Direction direction) {
  Figures figures;
  for (const TargetStatistics& target : targets) {
    figures.take(*(target.*direction));
  }
  return figures;
}

void add_both(PositioningEvaluation& evaluation) {
  Figures both;
  Span middles;
  double reversal = 0.0;
  for (const TargetStatistics& target : evaluation.targets) {
    both.take(*target.up);
    both.take(*target.down);
    middles.take(0.5 * (target.up->mean + target.down->mean));
    const double b = std::abs(target.up->mean - target.down->mean);
    reversal = std::max(reversal, b);
    both.repeatability =
        std::max(both.repeatability, 2.0 * target.up->s + 2.0 * target.down->s + b);
  }
  evaluation.A = both.limits.width();
  evaluation.E = both.means.width();
  evaluation.R = both.repeatability;
  evaluation.B = reversal;
  evaluation.M = middles.width();
}

}  // namespace

Result<PositioningEvaluation, std::string> evaluate_positioning(
    std::span<const Approach> approaches) {
  std::map<double, std::array<std::vector<double>, 2>> deviations;
  for (const Approach& approach : approaches) {
    deviations[approach.target]
        .at(approach.is_up ? 1 : 0)
        .push_back(approach.position - approach.target);
  }
  PositioningEvaluation evaluation;
  for (const auto& [target, both] : deviations) {
    TargetStatistics statistics{target, {}, {}};
    for (const bool is_up : {false, true}) {
      const std::vector<double>& one = both.at(is_up ? 1 : 0);
      if (one.size() == 1) {
        return fmt::format(
            "target {} mm was approached only once in the {} direction: at least two approaches "
            "are needed, five by the standard",
            target, is_up ? "positive" : "negative");
      }
      if (!one.empty()) {
        (is_up ? statistics.up : statistics.down) = statistics_of(one);
      }
    }
    evaluation.targets.push_back(statistics);
  }
  if (all_have(evaluation.targets, &TargetStatistics::up)) {
    const Figures up = figures_of(evaluation.targets, &TargetStatistics::up);
    evaluation.A_up = up.limits.width();
    evaluation.E_up = up.means.width();
    evaluation.R_up = up.repeatability;
  }
  if (all_have(evaluation.targets, &TargetStatistics::down)) {
    const Figures down = figures_of(evaluation.targets, &TargetStatistics::down);
    evaluation.A_down = down.limits.width();
    evaluation.E_down = down.means.width();
    evaluation.R_down = down.repeatability;
  }
  if (evaluation.A_up && evaluation.A_down) {
    add_both(evaluation);
  }
  return evaluation;
}

}  // namespace g31::metrology
