#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "machine/units/point.h"
#include "parts/geometry/bvh.h"
#include "probe/collision/swept_body.h"
#include "probe/contact/contact_triangle.h"

namespace g31::probe {

/// Planes with a swept section on one side: what lies on the other is clear of it, so a tree of
/// boxes need not look into it.
///
/// Up to six planes stand about the section and its way from the start.  The last few that have
/// parted a triangle from it are kept as well: they part the triangles around it too.
class SweptClearance {
 public:
  explicit SweptClearance(const SweptSection& swept);

  [[nodiscard]] std::span<const parts::Plane> planes() const { return {planes_.data(), count_}; }

  /// Goes on with less of the same way.
  void shorten_to(const SweptSection& swept);

  /// Adds the plane across a direction to those that stay.
  /// @param direction  of any length; none across 0
  void add(const Point& direction);

  /// Whether the section passes by a triangle at more than kClearMm.
  ///
  /// "Yes" is certain: a plane is at hand, and is kept.  "No" may also be said of a triangle that
  /// is clear.
  [[nodiscard]] bool is_clear_of(const ContactTriangle& triangle);

 private:
  static constexpr std::size_t kMostPlanes = 12;
  static constexpr std::size_t kMostStaying = 9;

  [[nodiscard]] parts::Plane plane_across(const Point& normal) const;
  void keep(const parts::Plane& plane);

  SweptBody body_;
  std::array<parts::Plane, kMostPlanes> planes_;  ///< those that stay, then those that were found
  std::size_t count_ = 0;
  std::size_t staying_ = 0;
  std::size_t oldest_found_ = 0;
};

/// How far a plane stands off the section, mm: twice the band in which meets() may say "yes" of
/// bodies that are apart, so of what is left out meets() would have said "no".
inline constexpr double kClearMm = 2.0 * kSweptBandMm;

}  // namespace g31::probe
