#include "parts/geometry/corner_fans.h"

#include <algorithm>
#include <numeric>

#include "machine/base/contract.h"

namespace g31::parts {
namespace {

std::vector<std::uint32_t> places_of(const std::vector<Point>& vertices) {
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    const Point& p = vertices[a];
    const Point& q = vertices[b];
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (p[axis] != q[axis]) {
        return p[axis] < q[axis];
      }
    }
    return a < b;
  };
  std::vector<std::uint32_t> sorted(vertices.size());
  std::iota(sorted.begin(), sorted.end(), 0U);
  std::ranges::sort(sorted, is_before);
  std::vector<std::uint32_t> place(vertices.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_new = i == 0 || vertices[sorted[i]] != vertices[sorted[i - 1]];
    place[sorted[i]] = is_new ? sorted[i] : place[sorted[i - 1]];
  }
  return place;
}

}  // namespace

CornerFans::CornerFans(const Mesh& mesh)
    : place_(places_of(mesh.vertices)), first_(mesh.vertices.size() + 1) {
  G31_EXPECTS(mesh.triangles.size() < 0x4000'0000U);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      ++first_[place_[v] + 1];
    }
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  corners_.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      corners_[next[place_[mesh.triangles[t][i]]]++] = {t, i};
    }
  }
}

}  // namespace g31::parts
