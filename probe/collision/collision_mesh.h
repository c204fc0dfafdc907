#pragma once

#include <memory>
#include <optional>

#include "parts/geometry/mesh.h"
#include "probe/collision/swept_section.h"
#include "probe/contact/contact_mesh.h"

namespace g31::probe {

/// Where a section first touches a mesh.
struct SectionTouch {
  double fraction = 0.0;            ///< 0..1 of the way
  Point p_M_point = Point::Zero();  ///< mm, on the mesh
  Point n_M = Point::Zero();        ///< unit normal of the triangle there, against the way
};

/// How far from the true first touch a section is stopped at worst, mm along the way where it meets
/// the surface head-on; where it comes in flat, that divided by the sine of the angle.
inline constexpr double kSectionTouchErrorMm = 1e-6;

/// A mesh that rigid sections of a probe must not touch.  Immutable; may be asked on many threads.
///
/// The surface counts, from both sides: a section that begins wholly inside a closed mesh touches
/// it when it comes out.
class CollisionMesh {
 public:
  /// @param mesh_M  mm, machine frame; may be empty
  explicit CollisionMesh(const parts::Mesh& mesh_M);

  /// The same with a mesh that balls share.
  explicit CollisionMesh(std::shared_ptr<const ContactMesh> mesh);

  /// The first touch on the way, at fraction 0 if the section overlaps the mesh there.
  ///
  /// Certified: the space swept is one convex body that is tested as a whole, so no touch is passed
  /// over, however thin the wall and long the way.  A section that passes by within kSweptBandMm
  /// counts as touching.
  [[nodiscard]] std::optional<SectionTouch> first_touch(const SweptSection& swept) const;

 private:
  /// Of the triangles that the section has come to, the one that stands most across its way: on an
  /// edge several are touched at once.
  [[nodiscard]] const ContactTriangle& most_opposed(const SweptSection& swept, double fraction,
                                                    const ContactTriangle& first) const;

  std::shared_ptr<const ContactMesh> mesh_;
};

}  // namespace g31::probe
