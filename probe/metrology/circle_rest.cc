#include "probe/metrology/circle_rest.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace g31::metrology {
namespace {

/// A loop has its speed so long behind a start, and is slow to lose so much, s.
constexpr double kLosing = 0.3;
constexpr double kMostLost = 0.1;
/// Of the radius: a path that is further off cuts a corner on its way in or out.
constexpr double kMostOff = 0.01;
/// A path has left its place of rest when it is so far from there, rad.
constexpr double kMoved = 1e-4;
constexpr double kLosingShare = 0.25;
constexpr double kLosingAngle = 60.0 * kDegree;

/// When the path left the standstill before sample `at`, or came to rest behind it: ends of a piece
/// are a little off that.
/// @param step  -1 before, +1 behind
double rest_time(const PlaneSamples& samples, const Eigen::Vector2d& centre, std::size_t at,
                 int step) {
  const auto angle = [&](std::size_t i) { return angle_about(centre, samples.at(i)); };
  const auto next = [&](std::size_t i) { return i + static_cast<std::size_t>(step); };
  const std::size_t out = step < 0 ? static_cast<std::size_t>(-1) : samples.size();
  const double here = angle(at);
  const double most_way = 1.5 * kStandstill * (samples.at(at) - centre).norm();
  const auto is_near = [&](std::size_t i) {
    return (samples.at(i) - samples.at(at)).norm() < most_way;
  };
  const auto off = [&](std::size_t i) { return shorter_way(angle(i) - here); };
  double most = 0.0;
  for (std::size_t i = next(at); i != out && is_near(i); i = next(i)) {
    most = std::abs(off(i)) > std::abs(most) ? off(i) : most;
  }
  std::size_t i = at;
  for (; next(i) != out && std::abs(off(i) - most) > kMoved; i = next(i)) {
  }
  return samples.t[i];
}

}  // namespace

RestAllowances rest_allowances(const PlaneSamples& samples, const CircleTurn& turn,
                               std::span<const double> way, const Circle& circle) {
  const double omega = std::abs(turn.omega);
  const double step = std::min({omega * kLosing, kLosingAngle, kLosingShare * way.back()});
  const auto time_at = [&](double angle) {
    const auto place = std::ranges::find_if(way, [&](double at) { return at >= angle; });
    const auto i = std::min<std::ptrdiff_t>(place - way.begin(), std::ssize(way) - 1);
    return samples.t[turn.begin + static_cast<std::size_t>(i)];
  };
  const auto allowance = [&](double whole, double at_speed) {
    const double lost = std::clamp(whole - at_speed, 0.0, kMostLost);
    return circle.radius * std::min(omega * omega * lost * lost, kMostOff);
  };
  const double from = rest_time(samples, circle.centre, turn.begin, -1);
  const double to = rest_time(samples, circle.centre, turn.end - 1, 1);
  const double first = time_at(step);
  const double last = time_at(way.back() - step);
  return {allowance(first - from, time_at(2.0 * step) - first),
          allowance(to - last, last - time_at(way.back() - 2.0 * step))};
}

}  // namespace g31::metrology
