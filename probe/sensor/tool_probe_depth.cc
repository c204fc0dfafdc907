// The part of ToolProbe that says how deep a tool is in.

#include <cmath>
#include <limits>
#include <numbers>

#include "probe/sensor/tool_probe.h"

namespace g31::probe {
namespace {

/// The direction that gives the least of a smooth function of an angle with few minima.
template <typename Function>
double least_angle(const Function& of_angle) {
  constexpr int kSamples = 48;
  constexpr double kStep = 2.0 * std::numbers::pi / kSamples;
  double best = 0.0;
  double least = of_angle(best);
  for (int i = 1; i < kSamples; ++i) {
    if (const double value = of_angle(i * kStep); value < least) {
      best = i * kStep;
      least = value;
    }
  }
  constexpr int kThirds = 60;
  double low = best - kStep;
  double high = best + kStep;
  for (int i = 0; i < kThirds; ++i) {
    const double a = low + (high - low) / 3.0;
    const double b = high - (high - low) / 3.0;
    const bool is_below_b = of_angle(a) < of_angle(b);
    (is_below_b ? high : low) = is_below_b ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

ToolProbe::Depth ToolProbe::depth_of(const Pieces& pieces, const machine::Waypoint& at) const {
  Depth deepest{-std::numeric_limits<double>::infinity(), Point::Zero()};
  if (pieces.empty()) {
    return deepest;
  }
  PlacedShape there = placed(pieces.front(), at);
  for (const ConvexShape& piece : pieces) {
    there.shape = &piece;
    Depth depth = depth_by_sides(there, deepest.mm);
    if (depth.mm <= deepest.mm) {
      continue;
    }
    if (depth.mm >= -kCastErrorMm) {
      depth.mm = depth_along(depth, there);
    }
    deepest = depth.mm > deepest.mm ? depth : deepest;
  }
  return deepest;
}

/// Along the side out of which the way is shortest.  None of them tells a corner from what passes
/// it by.  What is not deeper than `known_mm` may come out as any depth that is not.
ToolProbe::Depth ToolProbe::depth_by_sides(const PlacedShape& tool, double known_mm) const {
  const PlacedShape plate = target();
  const auto along = [&](const Point& n) { return n.dot(plate.furthest(n) - tool.furthest(-n)); };
  Depth least{std::numeric_limits<double>::infinity(), Point::Zero()};
  const auto consider = [&](const Point& n) {
    if (const double mm = along(n); mm < least.mm) {
      least = {mm, n};
    }
  };
  for (const Point& n : normals_M_) {
    consider(n);
    if (least.mm <= known_mm) {
      return least;
    }
  }
  if (is_round_ && least.mm >= -kCastErrorMm) {
    const bool is_beam = setup_.shape == ToolProbeShape::Laser;
    const Point a = R_MT_.col(is_beam ? 1 : 0);
    const Point b = R_MT_.col(is_beam ? 2 : 1);
    const auto direction = [&](double angle) {
      return Point(std::cos(angle) * a + std::sin(angle) * b);
    };
    consider(direction(least_angle([&](double angle) { return along(direction(angle)); })));
    if (is_beam) {
      consider(R_MT_.col(0));
      consider(-R_MT_.col(0));
    }
  }
  return least;
}

/// How far back the tool touches that is drawn out along a side, and put in again.
double ToolProbe::depth_along(const Depth& side, const PlacedShape& tool) const {
  constexpr double kClearMm = 1.0;
  const double out = side.mm + kClearMm;
  const double back = out + kCastErrorMm;
  PlacedShape drawn = tool;
  drawn.p += out * side.n_M;
  const CastHit hit = convex_cast(target(), drawn, -back * side.n_M);
  return hit.status == CastStatus::Contact ? out - hit.fraction * back
                                           : -std::numeric_limits<double>::infinity();
}

}  // namespace g31::probe
