#include "machine/sim/led_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

constexpr int kMostPieces = 20'000;

}  // namespace

LedPath::LedPath(const BasePath& base, const AxisPositions& q_M_from, const AxisPositions& q_M_to,
                 AxisTransformPtr transform)
    : base_(base), q_M_from_(q_M_from), q_M_to_(q_M_to), transform_(std::move(transform)) {
  G31_EXPECTS(transform_ != nullptr);
  cubic_ = as_cubic();
}

double LedPath::length() const {
  return std::visit([](const auto& path) { return path.length(); }, base_);
}

AxisPositions LedPath::base_at(double fraction) const {
  return std::visit([&](const auto& path) { return path.at(fraction); }, base_);
}

AxisPositions LedPath::at(double fraction) const {
  G31_EXPECTS(fraction >= 0.0);
  if (fraction == 0.0) {
    return q_M_from_;
  }
  if (fraction >= 1.0) {
    return q_M_to_;
  }
  if (cubic_) {
    const Cubic& a = *cubic_;
    return a[0] + fraction * (a[1] + fraction * (a[2] + fraction * a[3]));
  }
  return led_to(fraction);
}

AxisPositions LedPath::led_to(double fraction) const {
  return transform_->axes_at(base_at(fraction)).value_or(q_M_to_);
}

std::optional<LedPath::Cubic> LedPath::as_cubic() const {
  if (piece_count() > 1) {
    return std::nullopt;
  }
  const Cubic a = cubic_through({q_M_from_, led_to(1.0 / 3.0), led_to(2.0 / 3.0), q_M_to_});
  for (const double f : kFurthestFromQuartic) {
    const AxisPositions off = a[0] + f * (a[1] + f * (a[2] + f * a[3])) - led_to(f);
    if (!(off.cwiseAbs().maxCoeff() <= kLedErrorMm)) {
      return std::nullopt;
    }
  }
  return a;
}

std::array<AxisPositions, 4> cubic_through(const std::array<AxisPositions, 4>& q) {
  return {q[0], -5.5 * q[0] + 9.0 * q[1] - 4.5 * q[2] + q[3],
          9.0 * q[0] - 22.5 * q[1] + 18.0 * q[2] - 4.5 * q[3],
          -4.5 * q[0] + 13.5 * q[1] - 13.5 * q[2] + 4.5 * q[3]};
}

AxisPositions LedPath::slope_at(double fraction) const {
  if (cubic_) {
    const Cubic& a = *cubic_;
    return a[1] + fraction * (2.0 * a[2] + 3.0 * fraction * a[3]);
  }
  constexpr double kStep = 1e-4;
  const double before = std::max(0.0, fraction - kStep);
  const double behind = std::min(1.0, fraction + kStep);
  return (at(behind) - at(before)) / (behind - before);
}

int LedPath::piece_count() const {
  const double turned_deg = rotary_axes(q_M_to_ - q_M_from_).cwiseAbs().maxCoeff();
  double pieces = 1.0 + std::floor(turned_deg / kLedPieceDeg);
  if (const auto* const arc = std::get_if<ArcPath>(&base_)) {
    const double arc_deg = std::abs(arc->turned_rad()) * 180.0 / std::numbers::pi;
    pieces = std::max(pieces, std::ceil(arc_deg / kArcPieceDeg - 1e-9));
  }
  return static_cast<int>(std::min(pieces, double{kMostPieces}));
}

bool LedPath::leads() const {
  if (cubic_) {
    return true;
  }
  const int pieces = piece_count();
  for (int i = 1; i < pieces; ++i) {
    if (!transform_->axes_at(base_at(static_cast<double>(i) / pieces))) {
      return false;
    }
  }
  return true;
}

std::optional<LedPath> led_path(const AxisPositions& q_M_from, const LinearMove& move) {
  if (!move.transform || rotary_axes(q_M_from) == rotary_axes(move.q_M_end)) {
    return std::nullopt;
  }
  const StraightPath base(move.transform->base_at(q_M_from), move.transform->base_at(move.q_M_end),
                          move.mm_per_degree);
  return LedPath(base, q_M_from, move.q_M_end, move.transform);
}

std::optional<LedPath> led_path(const AxisPositions& q_M_from, const ArcMove& arc) {
  if (!arc.transform) {
    return std::nullopt;
  }
  ArcMove base = arc;
  base.q_M_end = arc.transform->base_at(arc.q_M_end);
  return LedPath(ArcPath(arc.transform->base_at(q_M_from), base), q_M_from, arc.q_M_end,
                 arc.transform);
}

}  // namespace g31::machine
