#include "probe/contact/contact_mesh.h"

namespace g31::probe {

ContactMesh::ContactMesh(const parts::Mesh& mesh, std::optional<parts::Sphere> sphere,
                         const parts::GoesOn& goes_on)
    : tree_(parts::triangle_boxes(mesh), goes_on), mesh_{mesh.vertices, {}}, sphere_(sphere) {
  mesh_.triangles.reserve(mesh.triangles.size());
  triangles_.reserve(mesh.triangles.size());
  parts::Steps steps(goes_on);
  for (const std::uint32_t index : tree_.order()) {
    steps.step();
    const auto& corners = mesh.triangles[index];
    mesh_.triangles.push_back(corners);
    triangles_.emplace_back(mesh.vertices[corners[0]], mesh.vertices[corners[1]],
                            mesh.vertices[corners[2]]);
  }
}

std::optional<Touch> ContactMesh::nearest_within(const Point& p, double reach) const {
  std::optional<Touch> nearest;
  tree_.visit_near(p, reach + kBoxMarginMm, [&](std::uint32_t slot) {
    const double distance = nearest_of(triangles_[slot], p).distance;
    if (distance < reach || (!nearest && distance == reach)) {
      nearest = Touch{slot, distance};
      reach = distance;
    }
    return reach + kBoxMarginMm;
  });
  return nearest;
}

std::optional<Meeting> ContactMesh::first_meeting(const parts::Path& path, double radius) const {
  std::optional<Meeting> first;
  parts::Path rest = path;
  tree_.visit_along(path, radius + kBoxMarginMm, [&](std::uint32_t slot) {
    const double s = sweep_triangle(rest, triangles_[slot], radius);
    if (s < rest.length || (!first && s == rest.length)) {
      first = Meeting{s, slot};
      rest.length = s;
    }
    return rest.length;
  });
  return first;
}

bool ContactMesh::rests_at(const Point& p, const Nearest& nearest) const {
  bool rests = true;
  visit_within(nearest.point, kTouchBandMm, [&](std::uint32_t slot, const Nearest&) {
    rests = rests && nearest_of(triangles_[slot], p).distance >= nearest.distance - kTouchBandMm;
  });
  return rests;
}

std::size_t ContactMesh::memory_bytes() const {
  return tree_.memory_bytes() + triangles_.capacity() * sizeof(ContactTriangle) +
         mesh_.vertices.capacity() * sizeof(Point) +
         mesh_.triangles.capacity() * sizeof(mesh_.triangles.front());
}

}  // namespace g31::probe
