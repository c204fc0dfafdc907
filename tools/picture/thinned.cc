#include "tools/picture/thinned.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#ifdef G31_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include "machine/base/contract.h"
#include "tools/picture/folds.h"

namespace g31::picture {

#ifdef G31_HAS_MESHOPTIMIZER
namespace {

/// The corners that its triangles have, in their order.
parts::Mesh with_used_corners(const parts::Mesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(mesh.vertices.size(), kNone);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      place[corner] = 0;
    }
  }
  parts::Mesh picked;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] != kNone) {
      place[v] = static_cast<std::uint32_t>(picked.vertices.size());
      picked.vertices.push_back(mesh.vertices[v]);
    }
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    picked.triangles.push_back({place[a], place[b], place[c]});
  }
  return picked;
}

void take_corners(parts::Mesh& mesh, const std::vector<unsigned>& corners) {
  mesh.triangles.clear();
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
}

/// Positions as meshoptimizer takes them: float is enough near the part, not so far away as the
/// machine's zero may be.
std::vector<std::array<float, 3>> from_middle(const parts::Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Point& p : mesh.vertices) {
    box.extend(p);
  }
  const Point middle = box.center();
  std::vector<std::array<float, 3>> positions;
  positions.reserve(mesh.vertices.size());
  for (const Point& p : mesh.vertices) {
    const Eigen::Vector3f offset = (p - middle).cast<float>();
    positions.push_back({offset.x(), offset.y(), offset.z()});
  }
  return positions;
}

/// Corners of fewer triangles of a mesh, at least so many.
std::vector<unsigned> simplified(const std::vector<std::array<float, 3>>& positions,
                                 const parts::Mesh& mesh, std::size_t least_triangles,
                                 float error) {
  std::vector<unsigned> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  std::vector<unsigned> left(corners.size());
  left.resize(meshopt_simplify(left.data(), corners.data(), corners.size(),
                               positions.front().data(), positions.size(),
                               sizeof(positions.front()), 3 * least_triangles, error, 0, nullptr));
  return left;
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
  const std::vector<std::array<float, 3>> positions = from_middle(mesh);
  const float scale =
      meshopt_simplifyScale(positions.front().data(), positions.size(), sizeof(positions.front()));
  if (!(scale > 0.0F)) {
    return std::nullopt;  // all in one point
  }
  const float error = static_cast<float>(most_error_mm) / scale;
  const Folds folds = count_folds(mesh);
  // In small steps with the folds of each mended: a fold is the beginning of worse ones.
  constexpr std::size_t kFirst = 4;
  constexpr double kStep = 0.7;
  constexpr double kSmallStep = 0.93;  // where folds are left at the end: first in few of these
  constexpr int kSmallSteps = 4;
  constexpr int kMoreSteps = 9;
  parts::Mesh few = mesh;
  std::size_t wanted = std::max(
      most_triangles,
      std::min(kFirst * most_triangles,
               static_cast<std::size_t>(kStep * static_cast<double>(mesh.triangles.size()))));
  for (int more = 0; more <= kMoreSteps;) {
    const std::size_t before = few.triangles.size();
    const bool was_enough = before <= most_triangles;
    take_corners(few, simplified(positions, few, wanted, error));
    mend_folds(few, most_error_mm);
    if (few.triangles.size() <= most_triangles && !has_more(count_folds(few), folds)) {
      break;
    }
    if (!was_enough && few.triangles.size() >= before) {
      break;  // not within the error
    }
    more += few.triangles.size() <= most_triangles ? 1 : 0;
    const auto share_of = [&few](double share) {
      return static_cast<std::size_t>(share * static_cast<double>(few.triangles.size()));
    };
    wanted = few.triangles.size() > most_triangles
                 ? std::max(most_triangles, share_of(kStep))
                 : share_of(more <= kSmallSteps ? kSmallStep : kStep);
  }
  if (few.triangles.empty() || few.triangles.size() > most_triangles) {
    return std::nullopt;
  }
  return with_used_corners(few);
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
