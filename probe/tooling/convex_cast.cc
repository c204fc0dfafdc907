#include "probe/tooling/convex_cast.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "machine/base/contract.h"
#include "probe/tooling/contact_portal.h"
#include "probe/tooling/nearest_of_simplex.h"

namespace g31::probe {
namespace {

constexpr double kMetMm = 1e-9;
constexpr double kLevel = 1e-12;

/// One question: the start as a ray against the Minkowski difference target - moving.
class Cast {
 public:
  Cast(const PlacedShape& target, const PlacedShape& moving, const Point& way)
      : target_(target), moving_(moving), way_(way) {}

  CastHit hit() {
    CastHit hit;
    if (!search()) {
      return hit;
    }
    hit.p_point = simplex_.on_target();
    if (n_.isZero(0.0)) {
      hit.status = CastStatus::StartsInside;
      return hit;
    }
    refine();
    if (fraction_ <= 1.0) {
      hit = {CastStatus::Contact, fraction_, n_, hit.p_point};
    }
    return hit;
  }

 private:
  /// The point of the difference furthest in a direction.
  [[nodiscard]] SimplexPoint furthest(const Point& direction) const {
    const Point p_target = target_.furthest(direction);
    return {p_target - moving_.furthest(-direction), p_target};
  }

  bool search();
  void refine();
  bool try_normal(const Point& n);
  void snap(const PlacedShape& shape);
  [[nodiscard]] bool is_level(const Point& along) const { return std::abs(n_.dot(along)) < kLevel; }

  const PlacedShape& target_;
  const PlacedShape& moving_;
  const Point& way_;
  Simplex simplex_;
  Point n_ = Point::Zero();  // of the plane that the way enters last, at
  double fraction_ = 0.0;    // this fraction of it
};

/// Whether the point is new.
bool add(Simplex& simplex, const SimplexPoint& point) {
  for (std::size_t i = 0; i < simplex.count; ++i) {
    if (simplex.points[i].p == point.p) {
      return false;
    }
  }
  simplex.points[simplex.count++] = point;
  return true;
}

/// Goes along the ray as long as a plane separates its point from the difference.  Whether the way
/// may meet it; n_ stays 0 where the way begins inside.
bool Cast::search() {
  constexpr int kMostSteps = 100;
  add(simplex_, furthest(-way_));
  Point x = Point::Zero();
  Point v = reduce_to_nearest(simplex_, x);
  for (int step = 0; step < kMostSteps && v.norm() > kMetMm; ++step) {
    const SimplexPoint next = furthest(v);
    const double ahead = v.dot(x - next.p);
    const bool advances = ahead > 0.0;
    if (advances) {
      const double towards = v.dot(way_);
      if (towards >= 0.0) {
        return false;
      }
      fraction_ -= ahead / towards;
      if (fraction_ > 1.0) {
        return false;
      }
      x = fraction_ * way_;
      n_ = v;
    }
    const double before = v.norm();
    if (!add(simplex_, next) && !advances) {
      break;
    }
    v = reduce_to_nearest(simplex_, x);
    if (!advances && v.norm() >= before) {
      break;  // the rest is rounding
    }
  }
  return true;
}

/// What the search ends with is off by rounding where shapes are long: the last plane is made that
/// of a flat side, then the true one.
void Cast::refine() {
  n_.normalize();
  snap(target_);
  snap(moving_);
  const EntryPlane entry = true_entry(target_, moving_, way_, {n_, fraction_});
  n_ = entry.n;
  fraction_ = entry.fraction;
}

/// Takes a normal whose plane the way enters later than that of the present one.
bool Cast::try_normal(const Point& n) {
  const double towards = n.dot(way_);
  if (towards >= 0.0) {
    return false;
  }
  const double fraction = n.dot(furthest(n).p) / towards;
  if (fraction <= fraction_) {
    return false;
  }
  fraction_ = fraction;
  n_ = n;
  return true;
}

/// To the axes of a shape, and to what is level with them.
void Cast::snap(const PlacedShape& shape) {
  constexpr double kNear = 0.02;
  for (int axis = 0; axis < 3; ++axis) {
    const Point along = shape.turn.col(axis);
    const double share = n_.dot(along);
    if (std::abs(share) > 1.0 - kNear * kNear) {
      try_normal(share < 0.0 ? Point(-along) : along);
    } else if (std::abs(share) < kNear && !is_level(along)) {
      try_normal((n_ - share * along).normalized());
    }
  }
}

}  // namespace

CastHit convex_cast(const PlacedShape& target, const PlacedShape& moving, const Point& way) {
  G31_EXPECTS(!way.isZero(0.0));
  return Cast(target, moving, way).hit();
}

}  // namespace g31::probe
