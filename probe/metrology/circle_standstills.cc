#include "probe/metrology/circle_standstills.h"

#include <algorithm>

#include "probe/metrology/circle_turns.h"

namespace g31::metrology {
namespace {

constexpr double kStep = 0.25 * kDegree;
/// A step holds so many samples at least, else their number would tell nothing.
constexpr double kFewestSamples = 4.0;
constexpr double kMuchLonger = 3.0;
constexpr std::size_t kMostSteps = 4;
constexpr double kLeastPart = 45.0 * kDegree;

/// The first sample of each step along the way, and the last sample of all.
std::vector<std::size_t> steps_of(std::span<const double> way) {
  const double whole = way.back() - way.front();
  const double step = std::max(kStep, kFewestSamples * whole / static_cast<double>(way.size()));
  std::vector<std::size_t> firsts = {0};
  double next = way.front() + step;
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    if (way[i] >= next) {
      firsts.push_back(i);
      next += step;
    }
  }
  firsts.push_back(way.size() - 1);
  return firsts;
}

/// The sample at half the time between two.
std::size_t middle_of(std::span<const double> t, std::size_t first, std::size_t last) {
  const double half = 0.5 * (t[first] + t[last]);
  const auto from = t.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = t.begin() + static_cast<std::ptrdiff_t>(last);
  return static_cast<std::size_t>(std::lower_bound(from, to, half) - t.begin());
}

}  // namespace

std::vector<std::size_t> standstills(std::span<const double> t, std::span<const double> way) {
  std::vector<std::size_t> found;
  if (way.size() < 2 || way.back() - way.front() < 2.0 * kLeastPart) {
    return found;
  }
  const std::vector<std::size_t> firsts = steps_of(way);
  const std::size_t steps = firsts.size() - 1;
  std::vector<double> times(steps);
  for (std::size_t k = 0; k < steps; ++k) {
    times[k] = t[firsts[k + 1]] - t[firsts[k]];
  }
  std::vector<double> sorted = times;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(steps / 2);
  std::ranges::nth_element(sorted, middle);
  const double limit = kMuchLonger * *middle;
  double before = way.front();
  for (std::size_t k = 0; k < steps; ++k) {
    std::size_t end = k;
    std::size_t slowest = k;
    for (; end < steps && times[end] > limit; ++end) {
      slowest = times[end] > times[slowest] ? end : slowest;
    }
    if (end > k && end - k <= kMostSteps) {
      const std::size_t at = middle_of(t, firsts[slowest], firsts[slowest + 1]);
      if (way[at] - before >= kLeastPart && way.back() - way[at] >= kLeastPart) {
        found.push_back(at);
        before = way[at];
      }
    }
    k = std::max(k, end);
  }
  return found;
}

}  // namespace g31::metrology
