#pragma once

#include "parts/geometry/box.h"
#include "probe/collision/probe_section.h"
#include "probe/contact/contact_triangle.h"

namespace g31::probe {

/// The space that a section fills while it goes straight from one place to another, grown by a
/// margin on all sides: one convex body, so nothing on the way can be stepped over.
///
/// Where the section also turns, it is the convex hull of its two ends; the margin is to cover what
/// the section bulges out of that (sag_of_turn).
struct SweptSection {
  const ProbeSection* section = nullptr;
  SectionPlace from;
  SectionPlace to;
  double margin = 0.0;  ///< mm, >= 0

  [[nodiscard]] Point way() const { return to.p_M - from.p_M; }
  [[nodiscard]] bool turns() const { return from.turn.coeffs() != to.turn.coeffs(); }

  /// By how much section and sweep are grown together.
  [[nodiscard]] double growth() const { return section->rounding + margin; }

  /// mm: no point of the section goes farther.
  [[nodiscard]] double longest_way() const;

  /// A box of the section before it moves along the way, large enough for all that it turns.
  [[nodiscard]] parts::Box start_box() const;

  /// The place at a fraction 0..1 of the way.
  [[nodiscard]] SectionPlace at(double fraction) const;

  /// A piece of the way, by fractions 0..1 of it.
  [[nodiscard]] SweptSection piece(double begin, double end) const;
};

/// The turn at a fraction 0..1 of the way between two; between equals exactly they.
Eigen::Quaterniond turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                                double fraction);

/// mm: how far a point that turns on a radius leaves the straight line between its ends at most.
double sag_of_turn(double radius, const Eigen::Quaterniond& from, const Eigen::Quaterniond& to);

/// Bodies that come nearer than this count as touching, mm: below it the intersection test (libccd)
/// may lack the digits for a proof that they are apart.  Among triangles of 10 mm on ways of 30 mm
/// it is 1e-6 at worst; with triangles of 500 mm or ways of 1 m it is this.
/// tests/probe/swept_section_test.cc holds it.
inline constexpr double kSweptBandMm = 2e-5;

/// Whether the swept section meets the triangle.
///
/// "No" is certain: it is said only when a plane between the two is at hand.  "Yes" may also be
/// said of bodies within kSweptBandMm.
bool meets(const SweptSection& swept, const ContactTriangle& triangle);

/// Points of a section and a triangle that are nearest to each other.
struct NearestPair {
  Point p_M_section;  ///< mm
  Point p_M_triangle;
};

/// Of the section at the begin of its way, by alternating projection.  For reports only: where a
/// side lies along a face the place on the face has been seen 0.3 mm off.
NearestPair nearest_pair(const SweptSection& swept, const ContactTriangle& triangle);

}  // namespace g31::probe
