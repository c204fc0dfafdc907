#include "tools/plot/scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "machine/base/contract.h"

namespace g31::plot {
namespace {

constexpr std::size_t kStretches = 1000;

}  // namespace

double round_down(double value) {
  G31_EXPECTS(value > 0.0 && std::isfinite(value));
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  // A value a rounding below 5 is 5.
  const double share = value / power * (1.0 + 1e-12);
  return (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0) * power;
}

Ticks ticks_between(double low, double high, int pieces) {
  Ticks ticks;
  ticks.step = round_down((high - low) / pieces * 1.5);
  const double first = std::ceil(low / ticks.step - 1e-9);
  const double last = std::floor(high / ticks.step + 1e-9);
  for (double k = first; k <= last; k += 1.0) {
    ticks.places.push_back(k * ticks.step);
  }
  return ticks;
}

std::string label_of(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 12);
  const double rounded = std::abs(value) < 1e-6 * step ? 0.0 : value;
  return fmt::format("{:.{}f}", rounded, decimals);
}

Scale::Scale(double low, double high, double from, double to)
    : low_(low), high_(high), from_(from), to_(to) {
  // Whatever has no extent is shown with one.
  if (!(high_ - low_ > 1e-12 * (1.0 + std::abs(low_) + std::abs(high_)))) {
    const double room = 1e-6 * (1.0 + std::abs(low_));
    low_ -= room;
    high_ += room;
  }
}

std::vector<std::size_t> shown_points(const std::vector<double>& heights) {
  const std::size_t count = heights.size();
  std::vector<std::size_t> shown;
  const std::size_t length = count / kStretches + 1;
  for (std::size_t begin = 0; begin < count; begin += length) {
    const std::size_t end = std::min(begin + length, count);
    const auto from = heights.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = heights.begin() + static_cast<std::ptrdiff_t>(end);
    const auto [low, high] = std::minmax_element(from, to);
    std::array<std::size_t, 4> four = {begin, static_cast<std::size_t>(low - heights.begin()),
                                       static_cast<std::size_t>(high - heights.begin()), end - 1};
    std::ranges::sort(four);
    const auto behind = std::unique(four.begin(), four.end());
    shown.insert(shown.end(), four.begin(), behind);
  }
  return shown;
}

}  // namespace g31::plot
