#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "parts/geometry/mesh.h"

namespace g31::testing {

/// A ball against all triangles of a mesh in quadruple precision, the slow and obvious way: every
/// boundary piece of every offset triangle by b^2 - a c, no tree, no tolerances.  The judge of
/// MeshSweeper.
///
/// @param start, end  of the ball centre, mm
class ExactSweep {
 public:
  __extension__ using Real = __float128;
  using Vec = std::array<Real, 3>;
  static constexpr double kMiss = std::numeric_limits<double>::infinity();

  ExactSweep(const parts::Mesh& mesh, const Point& start, const Point& end)
      : mesh_(mesh), start_d_(start), end_d_(end), from_(vec(start)) {
    const Vec travel = sub(vec(end), from_);
    length_ = root(dot(travel, travel));
    u_ = scale(travel, 1 / length_);
  }

  /// mm along the way at which a ball of that radius first touches; kMiss if it does not.  The
  /// start must be free.
  [[nodiscard]] double first_contact(double radius, double radius_change) const {
    const Real r = static_cast<Real>(radius) + static_cast<Real>(radius_change);
    Real first = static_cast<Real>(kMiss);
    for (const auto& t : mesh_.triangles) {
      if (!far_away(t, radius)) {
        first = smaller(first, triangle({at(t[0]), at(t[1]), at(t[2])}, r));
      }
    }
    return static_cast<double>(first);
  }

  /// The distance of a point of the way (s mm from the start) from the mesh, less the radius.
  [[nodiscard]] double gap_at(double s, double radius) const {
    const Vec p = add(from_, scale(u_, static_cast<Real>(s)));
    Real least = static_cast<Real>(kMiss);
    for (const auto& t : mesh_.triangles) {
      if (!far_away(t, radius)) {
        least = smaller(least, distance({at(t[0]), at(t[1]), at(t[2])}, p));
      }
    }
    return static_cast<double>(least - static_cast<Real>(radius));
  }

 private:
  using Corners = std::array<Vec, 3>;

  static Vec vec(const Point& p) {
    return {static_cast<Real>(p.x()), static_cast<Real>(p.y()), static_cast<Real>(p.z())};
  }
  static Vec add(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
  static Vec sub(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Vec scale(const Vec& a, Real k) { return {a[0] * k, a[1] * k, a[2] * k}; }
  static Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Real smaller(Real a, Real b) { return b < a ? b : a; }
  static Real root(Real x) {
    if (x <= 0) {
      return 0;
    }
    auto y = static_cast<Real>(std::sqrt(static_cast<double>(x)));
    for (int i = 0; i < 3 && y > 0; ++i) {
      y = (y + x / y) / 2;
    }
    return y;
  }

  [[nodiscard]] Vec at(std::uint32_t i) const { return vec(mesh_.vertices[i]); }

  /// Surely out of reach: saves time, decides nothing (1e-3 mm to spare).
  [[nodiscard]] bool far_away(const std::array<std::uint32_t, 3>& t, double radius) const {
    const Point middle = (mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]) / 3.0;
    double size = 0.0;
    for (const std::uint32_t i : t) {
      size = std::max(size, (mesh_.vertices[i] - middle).norm());
    }
    const Point way = end_d_ - start_d_;
    const double k = std::clamp((middle - start_d_).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (start_d_ + k * way - middle).norm() > size + radius + 1e-3;
  }

  /// Whether the foot of p on the plane lies in the triangle; n is any normal of it.
  static bool inside(const Corners& c, const Vec& n, const Vec& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (dot(cross(sub(c[(i + 1) % 3], c[i]), sub(p, c[i])), n) < 0) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] Real accept(Real s) const {
    return s >= 0 && s <= length_ ? s : static_cast<Real>(kMiss);
  }

  [[nodiscard]] Real triangle(const Corners& c, Real r) const {
    Real first = face(c, r);
    for (std::size_t i = 0; i < 3; ++i) {
      first = smaller(first, smaller(sphere(c[i], r), cylinder(c[i], c[(i + 1) % 3], r)));
    }
    return first;
  }

  [[nodiscard]] Real face(const Corners& c, Real r) const {
    const Vec n = cross(sub(c[1], c[0]), sub(c[2], c[0]));
    const Real size = root(dot(n, n));
    const Real climb = dot(u_, n);
    Real first = static_cast<Real>(kMiss);
    if (size == 0 || climb == 0) {
      return first;
    }
    for (const Real side : {r, -r}) {
      const Real s = (side * size - dot(sub(from_, c[0]), n)) / climb;
      if (inside(c, n, add(from_, scale(u_, s)))) {
        first = smaller(first, accept(s));
      }
    }
    return first;
  }

  [[nodiscard]] Real sphere(const Vec& centre, Real r) const {
    const Vec w = sub(from_, centre);
    const Real b = dot(w, u_);
    const Real discriminant = b * b - (dot(w, w) - r * r);
    if (discriminant < 0) {
      return static_cast<Real>(kMiss);
    }
    return smaller(accept(-b - root(discriminant)), accept(-b + root(discriminant)));
  }

  [[nodiscard]] Real cylinder(const Vec& from, const Vec& to, Real r) const {
    const Vec e = sub(to, from);
    const Real ee = dot(e, e);
    const Vec w = sub(from_, from);
    const Real a = ee - dot(u_, e) * dot(u_, e);
    Real first = static_cast<Real>(kMiss);
    if (ee == 0 || a <= ee * 1e-60) {
      return first;
    }
    const Real b = ee * dot(w, u_) - dot(u_, e) * dot(w, e);
    const Real c = ee * (dot(w, w) - r * r) - dot(w, e) * dot(w, e);
    const Real discriminant = b * b - a * c;
    if (discriminant < 0) {
      return first;
    }
    for (const Real q : {root(discriminant), -root(discriminant)}) {
      const Real s = (q - b) / a;
      const Real along = dot(add(w, scale(u_, s)), e);
      if (along >= 0 && along <= ee) {
        first = smaller(first, accept(s));
      }
    }
    return first;
  }

  static Real distance(const Corners& c, const Vec& p) {
    const Vec n = cross(sub(c[1], c[0]), sub(c[2], c[0]));
    const Real size = root(dot(n, n));
    if (size > 0 && inside(c, n, p)) {
      const Real height = dot(sub(p, c[0]), n) / size;
      return height < 0 ? -height : height;
    }
    Real least = static_cast<Real>(kMiss);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec e = sub(c[(i + 1) % 3], c[i]);
      const Vec w = sub(p, c[i]);
      const Real ee = dot(e, e);
      Real k = ee > 0 ? dot(w, e) / ee : 0;
      k = k < 0 ? 0 : (k > 1 ? 1 : k);
      const Vec offset = sub(w, scale(e, k));
      least = smaller(least, root(dot(offset, offset)));
    }
    return least;
  }

  const parts::Mesh& mesh_;
  Point start_d_;
  Point end_d_;
  Vec from_;
  Vec u_{};
  Real length_ = 0;
};

}  // namespace g31::testing
