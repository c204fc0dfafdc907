#pragma once

#include <optional>
#include <vector>

#include "parts/geometry/bvh.h"
#include "parts/geometry/mesh.h"
#include "probe/collision/swept_section.h"

namespace g31::probe {

/// Where a section first touches a mesh.
struct SectionTouch {
  double fraction = 0.0;  ///< 0..1 of the way
  Point p_M_point;        ///< mm, on the mesh
  Point n_M;              ///< unit normal of the triangle there, on the section's side
};

/// How far from the true first touch a section is stopped at worst, mm along the way.
inline constexpr double kSectionTouchErrorMm = 1e-5;

/// A mesh that rigid sections of a probe must not touch.  Immutable; may be asked on many threads.
///
/// The surface counts, from both sides: a section that begins wholly inside a closed mesh touches
/// it when it comes out.
class CollisionMesh {
 public:
  /// @param mesh_M  mm, machine frame
  explicit CollisionMesh(const parts::Mesh& mesh_M);

  /// The first touch on the way, at fraction 0 if the section overlaps the mesh there.
  ///
  /// Certified: no touch is passed over.  Accuracy: kSectionTouchErrorMm, and bodies within
  /// kSweptBandMm count as touching.
  [[nodiscard]] std::optional<SectionTouch> first_touch(const SweptSection& swept) const;

 private:
  std::vector<ContactTriangle> triangles_;  ///< in slot order of tree_
  parts::Bvh tree_;
};

}  // namespace g31::probe
