#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/bvh.h"
#include "parts/geometry/mesh.h"
#include "parts/geometry/sphere.h"
#include "probe/contact/contact_triangle.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {

/// A ball whose surface is no farther than this from a triangle, outside or inside, touches it
/// without overlapping it, mm.
inline constexpr double kTouchBandMm = 1e-9;

/// A triangle that a ball at rest touches or overlaps.
struct Touch {
  std::uint32_t slot = 0;
  double distance = 0.0;  ///< of the ball centre, mm
};

/// A triangle that a moving ball meets after s mm.
struct Meeting {
  double s = 0.0;
  std::uint32_t slot = 0;
};

/// A mesh ready for contact with balls of any size and with rigid bodies; triangles are numbered by
/// their slots in a tree.  Immutable: balls and bodies share one.
class ContactMesh {
 public:
  /// @throws parts::BrokenOff  as `goes_on` has it
  explicit ContactMesh(const parts::Mesh& mesh, std::optional<parts::Sphere> sphere = {},
                       const parts::GoesOn& goes_on = {});

  /// The true sphere that the triangles stand for: MeshSweeper and first_surface take it instead of
  /// them, everything else takes them.
  [[nodiscard]] const std::optional<parts::Sphere>& sphere() const { return sphere_; }

  [[nodiscard]] const std::vector<ContactTriangle>& triangles() const { return triangles_; }
  [[nodiscard]] const parts::Bvh& tree() const { return tree_; }

  /// The mesh as given, its triangles by their slots.
  [[nodiscard]] const parts::Mesh& mesh() const { return mesh_; }

  /// The triangle's number in the mesh as given.
  [[nodiscard]] std::uint32_t index_of(std::uint32_t slot) const { return tree_.order()[slot]; }

  /// The triangle nearest to p, if there is one within `reach` mm.
  [[nodiscard]] std::optional<Touch> nearest_within(const Point& p, double reach) const;

  /// Calls visit(slot, nearest) for every triangle within `reach` mm of p.
  template <typename Visit>
  void visit_within(const Point& p, double reach, Visit&& visit) const;

  /// The first triangle that a ball meets along the path.  Its start must be free.  Slower than
  /// MeshSweeper, but for every radius.
  [[nodiscard]] std::optional<Meeting> first_meeting(const parts::Path& path, double radius) const;

  /// Whether the distance from p is least at `nearest` compared with the surface around it: only
  /// there a ball about p rests on the surface.  Where it dips into a face, it also overlaps the
  /// triangles around, but rests on none of them.
  [[nodiscard]] bool rests_at(const Point& p, const Nearest& nearest) const;

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  parts::Bvh tree_;
  parts::Mesh mesh_;
  std::vector<ContactTriangle> triangles_;
  std::optional<parts::Sphere> sphere_;
};

/// Trees are asked for this much beyond what counts: far more than roundoff, hardly any work.
inline constexpr double kBoxMarginMm = 1e-8;

template <typename Visit>
void ContactMesh::visit_within(const Point& p, double reach, Visit&& visit) const {
  tree_.visit_near(p, reach + kBoxMarginMm, [&](std::uint32_t slot) {
    const Nearest nearest = nearest_of(triangles_[slot], p);
    if (nearest.distance <= reach) {
      visit(slot, nearest);
    }
    return reach + kBoxMarginMm;
  });
}

}  // namespace g31::probe
