#pragma once

#include "parts/geometry/box.h"
#include "probe/collision/probe_section.h"
#include "probe/contact/contact_triangle.h"

namespace g31::probe {

/// The space that a section fills while the ball centre goes straight from one place to another,
/// grown by a margin on all sides: one convex body, so nothing on the way can be stepped over.
struct SweptSection {
  const ProbeSection* section = nullptr;
  Point p_M_from;       ///< mm, ball centre
  Point way;            ///< mm, to the ball centre at the end
  double margin = 0.0;  ///< mm, >= 0

  /// By how much section and sweep are grown together.
  [[nodiscard]] double growth() const { return section->rounding + margin; }
  [[nodiscard]] parts::Box box() const;
};

/// Bodies that come nearer than this count as touching, mm: below it the intersection test (libccd)
/// may lack the digits for a proof that they are apart.
inline constexpr double kSweptBandMm = 1e-6;

/// Whether the swept section meets the triangle.
///
/// "No" is certain: it is said only when a plane between the two is at hand.  "Yes" may also be
/// said of bodies within kSweptBandMm.
bool meets(const SweptSection& swept, const ContactTriangle& triangle);

/// A nearest point of the triangle to the section standing with the ball centre at p_M, by
/// alternating projection; within about 0.01 mm where face lies nearly along face.
Point touched_point(const ProbeSection& section, const Point& p_M, const ContactTriangle& triangle);

}  // namespace g31::probe
