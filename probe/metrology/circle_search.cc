#include "probe/metrology/circle_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "machine/base/random.h"
#include "probe/metrology/least_squares_circle.h"

namespace g31::metrology {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr std::size_t kMostPoints = 4000;
constexpr int kTrials = 500;
constexpr int kRefinements = 10;
/// Shares of the radius: within `on` a point counts as on a circle that is sought, within `near` a
/// sample belongs to the one that was found.
struct Band {
  double on;
  double near;
};
constexpr std::array<Band, 3> kBands = {{{0.005, 0.02}, {0.015, 0.04}, {0.05, 0.10}}};

double extent_of(const PlaneSamples& samples) {
  const auto [x_low, x_high] = std::ranges::minmax_element(samples.x);
  const auto [y_low, y_high] = std::ranges::minmax_element(samples.y);
  return std::hypot(*x_high - *x_low, *y_high - *y_low);
}

/// Points about evenly spread along the way, so that standing still counts for nothing.
Points evenly_spread(const PlaneSamples& samples, double extent) {
  const double step = extent / 1000.0;
  Points points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples.look();
    const Eigen::Vector2d p = samples.at(i);
    if (points.empty() || (p - points.back()).squaredNorm() >= step * step) {
      points.push_back(p);
    }
  }
  const std::size_t stride = points.size() / kMostPoints + 1;
  Points kept;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    kept.push_back(points[i]);
  }
  return kept;
}

std::optional<Circle> through(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                              const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double cross = 2.0 * (u.x() * v.y() - u.y() * v.x());
  if (std::abs(cross) < 1e-12 * u.norm() * v.norm()) {
    return std::nullopt;
  }
  const Eigen::Vector2d from_a((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / cross,
                               (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / cross);
  return Circle{a + from_a, from_a.norm()};
}

bool is_on(const Circle& circle, double band, const Eigen::Vector2d& p) {
  return std::abs((p - circle.centre).norm() - circle.radius) <= band * circle.radius;
}

std::size_t count_on(const Circle& circle, double band, const Points& points) {
  return static_cast<std::size_t>(std::ranges::count_if(
      points, [&](const Eigen::Vector2d& p) { return is_on(circle, band, p); }));
}

/// A step towards the points on the circle.
Circle refined(const Circle& circle, double band, const Points& points) {
  CircleStep step(circle);
  for (const Eigen::Vector2d& p : points) {
    if (is_on(circle, band, p)) {
      step.add(p);
    }
  }
  return step.taken();
}

std::optional<Circle> search_circle(const Points& points, double extent, const Band& band) {
  const auto any_point = [&](int trial, int which) {
    const double number = uniform(Stream{}, static_cast<std::uint64_t>(3 * trial + which));
    return points[static_cast<std::size_t>(number * static_cast<double>(points.size()))];
  };
  std::optional<Circle> best;
  std::size_t most = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto circle = through(any_point(trial, 0), any_point(trial, 1), any_point(trial, 2));
    if (!circle || circle->radius > 2.0 * extent) {
      continue;
    }
    const std::size_t on = count_on(*circle, band.on, points);
    if (on > most) {
      best = circle;
      most = on;
    }
  }
  if (!best || most < 8 || 4 * most < points.size()) {
    return std::nullopt;
  }
  for (int round = 0; round < kRefinements; ++round) {
    best = refined(*best, band.near, points);
  }
  return best;
}

/// Whether pieces are all that another band has, or whole turns.
bool hold_all(const FoundCircle& found, const FoundCircle& widest) {
  constexpr double kMostOfAll = 0.75;
  constexpr double kCounts = 90.0 * kDegree;  // less may be a straight way
  return std::ranges::all_of(std::array{1, -1}, [&](int direction) {
    const double all = angle_of(widest.turns, direction);
    return all < kCounts || angle_of(found.turns, direction) >= kMostOfAll * all ||
           pass_whole_turn(found.turns, direction);
  });
}

}  // namespace

std::optional<FoundCircle> find_circle(const PlaneSamples& samples) {
  const double extent = samples.size() == 0 ? 0.0 : extent_of(samples);
  if (!(extent > 0.0)) {
    return std::nullopt;
  }
  const Points points = evenly_spread(samples, extent);
  const auto found_in = [&](const Band& band) -> std::optional<FoundCircle> {
    const auto circle = search_circle(points, extent, band);
    if (!circle) {
      return std::nullopt;
    }
    const auto turns = circle_turns(samples, *circle, band.near);
    return FoundCircle{*circle, turns, turns};
  };
  const auto has_half = [](const std::optional<FoundCircle>& found) {
    return found && std::ranges::any_of(found->turns, [](const CircleTurn& turn) {
             return turn.angle >= std::numbers::pi;
           });
  };
  auto found = found_in(kBands.front());
  const auto widest = found_in(kBands.back());
  if (!has_half(widest)) {
    return found;
  }
  if (!found || !hold_all(*found, *widest)) {
    found = found_in(kBands[1]);
  }
  if (!has_half(found) || !hold_all(*found, *widest)) {
    return widest;
  }
  found->reach = widest->turns;
  return found;
}

}  // namespace g31::metrology
