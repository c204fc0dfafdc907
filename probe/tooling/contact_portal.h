#pragma once

#include "machine/units/point.h"
#include "probe/tooling/convex_shape.h"

namespace g31::probe {

/// A plane that the start of a way enters last on its way into the Minkowski difference of two
/// shapes, as far as is known.
struct EntryPlane {
  Point n = Point::Zero();  ///< unit normal
  double fraction = 0.0;    ///< of the way, where it enters
};

/// Makes a plane that is near to the truth the true one: the way goes into the difference through a
/// triangle of its points, a portal, which is made smaller until the plane that supports it there
/// lies in it (after G. Snethen, XenoCollide, 2008).  No plane is entered after the contact, so the
/// last one found is the truest, whatever ends the search.
/// Accuracy: kPortalGapMm along the way, as far as coordinates of up to 1000 mm round.
/// @param way  of `moving` from its place; @pre the way meets the target
EntryPlane true_entry(const PlacedShape& target, const PlacedShape& moving, const Point& way,
                      const EntryPlane& near);

inline constexpr double kPortalGapMm = 1e-10;

}  // namespace g31::probe
