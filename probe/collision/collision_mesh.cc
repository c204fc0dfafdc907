#include "probe/collision/collision_mesh.h"

#include <algorithm>

namespace g31::probe {
namespace {

/// The fraction up to which the section is free of a triangle that it meets on the whole way.
double free_until(const SweptSection& swept, const ContactTriangle& triangle) {
  constexpr double kFinestMm = 1e-9;
  if (meets(swept.piece(0.0, 0.0), triangle)) {
    return 0.0;
  }
  const double length = swept.way.norm();
  double free = 0.0;
  double met = 1.0;
  while ((met - free) * length > kFinestMm) {
    const double middle = 0.5 * (free + met);
    // Only what is new: short sweeps lose fewer digits.
    (meets(swept.piece(free, middle), triangle) ? met : free) = middle;
  }
  return free;
}

/// The direction in which the two are apart just before they touch; from the start the triangle's.
Point normal_of(const SweptSection& before, const ContactTriangle& triangle) {
  const NearestPair pair = nearest_pair(before, triangle);
  const Point gap = pair.p_M_section - pair.p_M_triangle;
  if (gap.norm() > kSweptBandMm) {
    return gap.normalized();
  }
  const Point n_M = triangle.is_sliver() ? Point(Point::UnitZ()) : triangle.normal;
  const double middle = 0.5 * (before.section->z_bottom + before.section->z_top);
  const Point p_M_middle = before.p_M_from + middle * Point::UnitZ();
  return n_M.dot(p_M_middle - triangle.vertices[0]) < 0.0 ? Point(-n_M) : n_M;
}

SectionTouch touch_at(double fraction, const SweptSection& swept, const ContactTriangle& triangle) {
  constexpr double kJustBeforeMm = 0.01;
  const double length = swept.way.norm();
  const double before = length > 0.0 ? std::max(0.0, fraction - kJustBeforeMm / length) : 0.0;
  SectionTouch touch;
  touch.fraction = fraction;
  touch.p_M_point = nearest_pair(swept.piece(fraction, fraction), triangle).p_M_triangle;
  touch.n_M = normal_of(swept.piece(before, before), triangle);
  return touch;
}

}  // namespace

CollisionMesh::CollisionMesh(const parts::Mesh& mesh_M) : tree_(parts::triangle_boxes(mesh_M)) {
  triangles_.reserve(mesh_M.triangles.size());
  for (const std::uint32_t index : tree_.order()) {
    const auto& corners = mesh_M.triangles[index];
    triangles_.emplace_back(mesh_M.vertices[corners[0]], mesh_M.vertices[corners[1]],
                            mesh_M.vertices[corners[2]]);
  }
}

std::optional<SectionTouch> CollisionMesh::first_touch(const SweptSection& swept) const {
  const double length = swept.way.norm();
  const parts::Box box = swept.start_box();
  const parts::Path path{0.5 * (box.min + box.max),
                         length > 0.0 ? Point(swept.way / length) : Point(Point::UnitX()), length};
  const Point reach = 0.5 * (box.max - box.min) + Point::Constant(kSweptBandMm);
  double fraction = 1.0;
  const ContactTriangle* first = nullptr;
  tree_.visit_along(path, reach, [&](std::uint32_t slot) {
    const SweptSection to_go = swept.piece(0.0, fraction);
    if ((first == nullptr || fraction > 0.0) && meets(to_go, triangles_[slot])) {
      fraction *= free_until(to_go, triangles_[slot]);
      first = &triangles_[slot];
    }
    return fraction * length;
  });
  return first != nullptr ? std::optional(touch_at(fraction, swept, *first)) : std::nullopt;
}

}  // namespace g31::probe
