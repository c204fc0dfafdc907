#include "tools/picture/thinned.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#ifdef G31_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include "machine/base/contract.h"

namespace g31::picture {

#ifdef G31_HAS_MESHOPTIMIZER
namespace {

/// The corners that these triangles have, in the order of the mesh.
parts::Mesh picked(const parts::Mesh& mesh, const std::vector<unsigned>& corners) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.vertices.size(), kNone);
  for (const unsigned corner : corners) {
    place[corner] = 0;
  }
  parts::Mesh picked;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] != kNone) {
      place[v] = static_cast<std::uint32_t>(picked.vertices.size());
      picked.vertices.push_back(mesh.vertices[v]);
    }
  }
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    picked.triangles.push_back({place[corners[i]], place[corners[i + 1]], place[corners[i + 2]]});
  }
  return picked;
}

}  // namespace

bool can_thin() {
  return true;
}

std::optional<parts::Mesh> thinned(const parts::Mesh& mesh, std::size_t most_triangles,
                                   double most_error_mm) {
  G31_EXPECTS(most_error_mm > 0.0);
  if (mesh.triangles.size() <= most_triangles) {
    return mesh;
  }
  // float is enough near the part, not so far away as the machine's zero may be.
  Eigen::AlignedBox3d box;
  for (const Point& p : mesh.vertices) {
    box.extend(p);
  }
  const Point middle = box.center();
  std::vector<std::array<float, 3>> positions;
  positions.reserve(mesh.vertices.size());
  for (const Point& p : mesh.vertices) {
    const Eigen::Vector3f from_middle = (p - middle).cast<float>();
    positions.push_back({from_middle.x(), from_middle.y(), from_middle.z()});
  }
  std::vector<unsigned> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  const float* const first = positions.front().data();
  const float scale = meshopt_simplifyScale(first, positions.size(), sizeof(positions.front()));
  if (!(scale > 0.0F)) {
    return std::nullopt;  // all in one point
  }
  std::vector<unsigned> left(corners.size());
  left.resize(meshopt_simplify(left.data(), corners.data(), corners.size(), first, positions.size(),
                               sizeof(positions.front()), 3 * most_triangles,
                               static_cast<float>(most_error_mm) / scale, 0, nullptr));
  if (left.empty() || left.size() > 3 * most_triangles) {
    return std::nullopt;
  }
  return picked(mesh, left);
}
#else
bool can_thin() {
  return false;
}

std::optional<parts::Mesh> thinned(const parts::Mesh& mesh, std::size_t most_triangles,
                                   double most_error_mm) {
  G31_EXPECTS(most_error_mm > 0.0);
  return mesh.triangles.size() <= most_triangles ? std::optional(mesh) : std::nullopt;
}
#endif

}  // namespace g31::picture
