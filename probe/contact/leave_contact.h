#pragma once

#include <limits>
#include <optional>

#include "parts/geometry/box.h"
#include "probe/contact/contact_mesh.h"

namespace g31::probe {

/// What a ball that begins its way in contact may do until it is free.
///
/// A *contact* is where the distance of the ball centre from the surface is least compared with the
/// surface around, and less than the radius: a ball in a face has one, whatever the triangles that
/// it overlaps.  The ball is stopped where
///   * it goes against a contact, one that it had from the start or a new one, at more than `steep`
///     from the contact's tangent plane;
///   * or its centre comes nearer to the mesh than it was at the start, by more than `allowance`.
/// So it leaves in every direction that does not lead deeper, however flat, and neither depth nor
/// size of the triangles matter; going along a hollow surface is going deeper.
struct LeavingRule {
  double allowance_mm = 0.0;  ///< >= kTouchBandMm
  double steep = 0.0;         ///< sine of the angle
};

/// For moves in which a touch is a collision.  Two facets of a bore that meet at less than steep do
/// not catch a ball that rubs along; facets within 0.001 mm of the true surface are as good as it.
inline constexpr LeavingRule kLeaveFreely{1e-3, 0.25881904510252074};  // sin 15 degrees

/// For probing: only what leads away or along is no contact.
inline constexpr LeavingRule kLeaveExactly{kTouchBandMm, 1e-3};

/// To find where the ball is free, whatever it comes to before.
inline constexpr LeavingRule kLeaveAtAnyDepth{std::numeric_limits<double>::infinity(),
                                              std::numeric_limits<double>::infinity()};

/// How the beginning of a way ends.
struct Leaving {
  std::optional<Meeting> stop;  ///< none: nothing in the way until the ball is free
  double free_from = 0.0;       ///< mm along the path; its length if it does not come free
};

/// The way of a ball out of contact.
///
/// @param path  of the ball centre; in contact, or touching, at its start
/// @param start_distance  of the ball centre from the mesh where the whole move began, mm
Leaving leave_contact(const ContactMesh& mesh, const parts::Path& path, double radius,
                      double start_distance, const LeavingRule& rule);

}  // namespace g31::probe
