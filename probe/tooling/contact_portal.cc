#include "probe/tooling/contact_portal.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace g31::probe {
namespace {

using Flat = Eigen::Vector2d;

double cross(const Flat& a, const Flat& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Point some_across(const Point& direction) {
  const Point other = std::abs(direction.x()) < 0.9 ? Point::UnitX() : Point::UnitY();
  return direction.cross(other).normalized();
}

class Portal {
 public:
  Portal(const PlacedShape& target, const PlacedShape& moving, const Point& way,
         const EntryPlane& near)
      : target_(target), moving_(moving), way_(way), length_(way.norm()), best_(near) {
    u_ = some_across(way.normalized());
    v_ = way.normalized().cross(u_);
  }

  EntryPlane entry() {
    if (opens()) {
      shrink();
    }
    return best_;
  }

 private:
  /// The point of the difference furthest in a direction; its plane may be the one that is looked
  /// for.
  Point furthest(const Point& direction) {
    const Point p = target_.furthest(direction) - moving_.furthest(-direction);
    const double towards = direction.dot(way_);
    if (towards < 0.0) {
      const double fraction = direction.dot(p) / towards;
      if (fraction > best_.fraction) {
        best_ = {direction.normalized(), fraction};
      }
    }
    return p;
  }

  /// As seen along the way, which comes in the origin.
  [[nodiscard]] Flat flat(std::size_t corner) const { return flat(corners_.at(corner % 3)); }
  [[nodiscard]] Flat flat(const Point& p) const { return {p.dot(u_), p.dot(v_)}; }

  /// Whether the way goes through the triangle.
  [[nodiscard]] bool is_entered() const {
    const double areas[] = {cross(flat(0), flat(1)), cross(flat(1), flat(2)),
                            cross(flat(2), flat(0))};
    const auto [least, most] = std::ranges::minmax(areas);
    return (least >= 0.0 && most > 0.0) || (most <= 0.0 && least < 0.0);
  }

  /// Triangles of points around the present one, larger and larger, until the way goes through.
  bool opens() {
    constexpr double kFirstTilt = 1e-4;
    constexpr double kLastTilt = 50.0;
    constexpr double kThird = 2.0943951023931953;  // rad
    const Point n = best_.n;
    const Point t = some_across(n);
    const Point t_other = n.cross(t);
    for (double tilt = kFirstTilt; tilt < kLastTilt; tilt *= 4.0) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double angle = 0.1 + static_cast<double>(i) * kThird;
        corners_.at(i) = furthest(n + tilt * (std::cos(angle) * t + std::sin(angle) * t_other));
      }
      if (is_entered() || comes_nearer(n, tilt)) {
        return true;
      }
    }
    return false;
  }

  /// Replaces the corner that is farthest off by points nearer to the way.
  bool comes_nearer(const Point& n, double tilt) {
    constexpr int kMostCorners = 6;
    for (int i = 0; i < kMostCorners; ++i) {
      Flat nearest = flat(0);
      std::size_t opposite = 2;
      for (std::size_t k = 0; k < 3; ++k) {
        const Flat along = flat(k + 1) - flat(k);
        const double square = along.squaredNorm();
        const double share =
            square > 0.0 ? std::clamp(-flat(k).dot(along) / square, 0.0, 1.0) : 0.0;
        const Flat p = flat(k) + share * along;
        if (k == 0 || p.squaredNorm() < nearest.squaredNorm()) {
          nearest = p;
          opposite = (k + 2) % 3;
        }
      }
      const Flat towards = -nearest.normalized();
      const Point p = furthest(n + tilt * (towards.x() * u_ + towards.y() * v_));
      if (!(flat(p).dot(towards) > nearest.dot(towards))) {
        return false;
      }
      corners_.at(opposite) = p;
      if (is_entered()) {
        return true;
      }
    }
    return false;
  }

  void shrink() {
    constexpr int kMostSteps = 80;
    for (int step = 0; step < kMostSteps; ++step) {
      const auto& [a, b, c] = corners_;
      Point n = (b - a).cross(c - a);
      if (n.dot(way_) > 0.0) {
        n = -n;
      }
      const double towards = n.dot(way_);
      if (towards == 0.0) {
        return;
      }
      const double through = n.dot(a) / towards;  // the way is in the difference there
      const Point p = furthest(n);
      if ((through - best_.fraction) * length_ < kPortalGapMm || !replace_corner(p)) {
        return;
      }
    }
  }

  /// The one of the three triangles with the new corner that the way goes through.
  bool replace_corner(const Point& p) {
    const double side = cross(flat(1) - flat(0), flat(2) - flat(0)) > 0.0 ? 1.0 : -1.0;
    const Flat corner = flat(p);
    for (std::size_t i = 0; i < 3; ++i) {
      const Flat from = flat(i);
      const Flat to = flat(i + 1);
      if (side * cross(from, to) >= 0.0 && side * cross(to, corner) >= 0.0 &&
          side * cross(corner, from) >= 0.0) {
        corners_.at((i + 2) % 3) = p;
        return true;
      }
    }
    return false;
  }

  const PlacedShape& target_;
  const PlacedShape& moving_;
  const Point& way_;
  double length_;
  EntryPlane best_;
  Point u_ = Point::Zero();  // across the way
  Point v_ = Point::Zero();
  std::array<Point, 3> corners_ = {Point::Zero(), Point::Zero(), Point::Zero()};
};

}  // namespace

EntryPlane true_entry(const PlacedShape& target, const PlacedShape& moving, const Point& way,
                      const EntryPlane& near) {
  return Portal(target, moving, way, near).entry();
}

}  // namespace g31::probe
