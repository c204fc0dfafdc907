#include "probe/contact/sweep_curve.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::probe {
namespace {

class CurveWalker {
 public:
  CurveWalker(const MeshSweeper& sweeper, const Curve& curve) : sweeper_(sweeper), curve_(curve) {
    G31_EXPECTS(curve.bend >= 0.0 && std::isfinite(curve.bend));
  }

  CurveHit walk() {
    double share = chord_bulging(kFirstBulgeMm);
    while (t_ < 1.0 && hit_.status == SweepStatus::Miss) {
      const double step = std::min(share, 1.0 - t_);
      const double bulge = curve_.bend * step * step / 8.0;
      const bool passed = bulge <= kCurveErrorMm ? sweep_chord(step) : passes(step, bulge);
      share = passed ? 2.0 * step : 0.5 * step;
    }
    return {t_, hit_};
  }

  /// Follows the beginning of the curve until the ball is free.  @param start_distance  there
  void leave(double start_distance) {
    const double share = chord_bulging(kLeavingBulgeMm);
    while (t_ < 1.0 && hit_.status == SweepStatus::Miss && sweeper_.distance_if_touching(at(t_))) {
      const double step = std::min(share, 1.0 - t_);
      const StraightLeaving leaving =
          sweeper_.leave(at(t_), end_of(step), start_distance, kLeaveFreely);
      hit_ = leaving.hit;
      // Where the chord is free, the curve beside it may not be yet.
      constexpr double kLeastShare = 0.1;
      const bool stopped = hit_.status != SweepStatus::Miss;
      advance(step, stopped ? leaving.share : std::max(leaving.share, kLeastShare));
    }
  }

 private:
  static constexpr double kFirstBulgeMm = 0.5;
  /// Far below what kLeaveFreely allows.
  static constexpr double kLeavingBulgeMm = 1e-5;

  [[nodiscard]] Point at(double t) const { return curve_.at(t); }
  [[nodiscard]] Point end_of(double step) const { return curve_.at(std::min(1.0, t_ + step)); }

  /// The share of the curve that bulges so much from its chord.
  [[nodiscard]] double chord_bulging(double bulge) const {
    return curve_.bend > 0.0 ? std::min(1.0, std::sqrt(8.0 * bulge / curve_.bend)) : 1.0;
  }

  void advance(double step, double share) {
    t_ = share >= 1.0 && t_ + step >= 1.0 ? 1.0 : t_ + share * step;
  }

  /// Whether the ball gets to the end of a chord that is as good as the curve; else hit_ is set.
  bool sweep_chord(double step) {
    const Point from = at(t_);
    const Point to = end_of(step);
    const SweepHit hit = sweeper_.sweep(from, to);
    if (hit.status == SweepStatus::Miss) {
      advance(step, 1.0);
      return true;
    }
    hit_ = hit;
    // A chord may have let the ball in by kCurveErrorMm, which is where it is found now.
    if (t_ > 0.0) {
      hit_.status = SweepStatus::Contact;
    }
    advance(step, hit.s > 0.0 ? std::min(1.0, hit.s / (to - from).norm()) : 0.0);
    return false;
  }

  /// Goes as far as the curve is certainly free; whether that is the whole step.
  bool passes(double step, double bulge) {
    const double share = sweeper_.free_share(at(t_), end_of(step), bulge);
    advance(step, share);
    return share >= 1.0;
  }

  const MeshSweeper& sweeper_;
  const Curve& curve_;
  double t_ = 0.0;
  SweepHit hit_;
};

}  // namespace

CurveHit sweep_curve(const MeshSweeper& sweeper, const Curve& curve) {
  // Asks about the overlap at the start: without length there is nothing else to meet.
  const SweepHit start = sweeper.sweep(curve.at(0.0), curve.at(0.0));
  if (start.status == SweepStatus::StartInContact) {
    return {0.0, start};
  }
  return CurveWalker(sweeper, curve).walk();
}

CurveHit first_contact_leaving_on_curve(const MeshSweeper& sweeper, const Curve& curve) {
  CurveWalker walker(sweeper, curve);
  if (const auto distance = sweeper.distance_if_touching(curve.at(0.0))) {
    walker.leave(*distance);
  }
  return walker.walk();
}

}  // namespace g31::probe
