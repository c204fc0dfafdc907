#include "probe/metrology/path_speed.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace g31::metrology {
namespace {

constexpr double kScatter = 0.01;
constexpr std::size_t kLongestInterval = 64;
constexpr double kBelow = 0.9;
constexpr double kAgain = 0.95;

double part_of(std::vector<double> values, double part) {
  const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + rank);
  return values[static_cast<std::size_t>(rank)];
}

/// The median of the speeds above a hundredth of the high ones.
double speed_under_way(std::span<const double> speed) {
  const double floor = 0.01 * part_of({speed.begin(), speed.end()}, 0.99);
  std::vector<double> moving;
  std::ranges::copy_if(speed, std::back_inserter(moving),
                       [&](double value) { return value > floor; });
  return moving.empty() ? 0.0 : part_of(std::move(moving), 0.5);
}

SpeedRecord speed_over(const PlaneSamples& samples, std::size_t interval) {
  SpeedRecord record;
  record.interval = interval;
  record.t.reserve(samples.size() - interval);
  record.speed.reserve(samples.size() - interval);
  for (std::size_t i = interval; i < samples.size(); ++i) {
    samples.look();
    const double time = samples.t[i] - samples.t[i - interval];
    record.t.push_back(0.5 * (samples.t[i] + samples.t[i - interval]));
    record.speed.push_back((samples.at(i) - samples.at(i - interval)).norm() / time);
  }
  return record;
}

/// How much the speed differs from one value to the next, as a share of the usual.
double scatter_of_speed(const SpeedRecord& record) {
  std::vector<double> steps;
  for (std::size_t i = record.interval; i < record.speed.size(); i += record.interval) {
    steps.push_back(std::abs(record.speed[i] - record.speed[i - record.interval]));
  }
  const double usual = speed_under_way(record.speed);
  return steps.empty() || usual == 0.0 ? 0.0 : part_of(std::move(steps), 0.5) / usual;
}

/// When the speed passes a level between two values.
double passing(const SpeedRecord& record, std::size_t i, double level) {
  const double share = (level - record.speed[i - 1]) / (record.speed[i] - record.speed[i - 1]);
  return record.t[i - 1] + share * (record.t[i] - record.t[i - 1]);
}

/// @param first, last  the first and last value at 90 percent of the usual speed
std::vector<SpeedDip> dips_of(const SpeedRecord& record, std::size_t first, std::size_t last,
                              double usual) {
  std::vector<SpeedDip> dips;
  bool is_open = false;
  double began = 0.0;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double speed = record.speed[i];
    const bool falls = record.speed[i - 1] >= kBelow * usual && speed < kBelow * usual;
    const bool rises = record.speed[i - 1] < kBelow * usual && speed >= kBelow * usual;
    if (falls && !is_open) {
      is_open = true;
      began = passing(record, i, kBelow * usual);
      dips.push_back({record.t[i], speed, 0.0});
    }
    if (is_open && speed < dips.back().speed) {
      dips.back().time = record.t[i];
      dips.back().speed = speed;
    }
    if (is_open && rises) {
      dips.back().width = passing(record, i, kBelow * usual) - began;
    }
    is_open = is_open && speed < kAgain * usual;
  }
  return dips;
}

}  // namespace

SpeedRecord speed_of(const PlaneSamples& samples) {
  SpeedRecord record = speed_over(samples, 1);
  for (std::size_t interval = 2; interval <= kLongestInterval && samples.size() > 8 * interval &&
                                 scatter_of_speed(record) > kScatter;
       interval *= 2) {
    record = speed_over(samples, interval);
  }
  return record;
}

std::optional<SpeedEvaluation> evaluate_speed(const SpeedRecord& record) {
  SpeedEvaluation evaluation;
  evaluation.usual = speed_under_way(record.speed);
  if (!(evaluation.usual > 0.0)) {
    return std::nullopt;
  }
  const auto is_up = [&](double speed) { return speed >= kBelow * evaluation.usual; };
  const auto first = std::ranges::find_if(record.speed, is_up);
  const auto behind_last = std::find_if(record.speed.rbegin(), record.speed.rend(), is_up).base();
  evaluation.most = *std::ranges::max_element(record.speed);
  evaluation.least = *std::min_element(first, behind_last);
  evaluation.dips =
      dips_of(record, static_cast<std::size_t>(first - record.speed.begin()),
              static_cast<std::size_t>(behind_last - record.speed.begin()) - 1, evaluation.usual);
  return evaluation;
}

}  // namespace g31::metrology
