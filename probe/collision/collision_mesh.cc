#include "probe/collision/collision_mesh.h"

namespace g31::probe {
namespace {

SweptSection begin_of(const SweptSection& swept, double fraction) {
  SweptSection part = swept;
  part.way = fraction * swept.way;
  return part;
}

/// The fraction up to which the section is free of a triangle that it meets on the whole way.
double free_until(const SweptSection& swept, const ContactTriangle& triangle) {
  if (meets(begin_of(swept, 0.0), triangle)) {
    return 0.0;
  }
  const double length = swept.way.norm();
  double free = 0.0;
  double met = 1.0;
  while ((met - free) * length > 0.1 * kSectionTouchErrorMm) {
    const double middle = 0.5 * (free + met);
    (meets(begin_of(swept, middle), triangle) ? met : free) = middle;
  }
  return free;
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
  SweptSection to_go = swept;
  double fraction = 1.0;
  const ContactTriangle* first = nullptr;
  tree_.visit_inside(swept.box(), [&](std::uint32_t slot) {
    const ContactTriangle& triangle = triangles_[slot];
    if ((first == nullptr || fraction > 0.0) && meets(to_go, triangle)) {
      fraction *= free_until(to_go, triangle);
      to_go = begin_of(swept, fraction);
      first = &triangle;
    }
  });
  if (first == nullptr) {
    return std::nullopt;
  }
  const Point p_M_centre = swept.p_M_from + fraction * swept.way;
  SectionTouch touch;
  touch.fraction = fraction;
  touch.p_M_point = touched_point(*swept.section, p_M_centre, *first);
  const Point p_M_axis(p_M_centre.x(), p_M_centre.y(), touch.p_M_point.z());
  touch.n_M = first->is_sliver() ? Point(0.0, 0.0, 1.0) : first->normal;
  if (touch.n_M.dot(p_M_axis - touch.p_M_point) < 0.0) {
    touch.n_M = -touch.n_M;
  }
  return touch;
}

}  // namespace g31::probe
