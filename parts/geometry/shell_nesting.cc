#include "parts/geometry/shell_nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "parts/geometry/bvh.h"
#include "parts/geometry/winding_number.h"

namespace g31::parts {
namespace {

bool contains(const Box& outer, const Box& inner) {
  return (outer.min.array() <= inner.min.array()).all() &&
         (outer.max.array() >= inner.max.array()).all();
}

class ShellNesting {
 public:
  ShellNesting(const Mesh& mesh, const MeshShells& found, const FacetsByShell& facets)
      : mesh_(mesh), found_(found), facets_(facets) {}

  std::vector<ShellPlace> places(const NestingWork& work) {
    Steps steps(work.goes_on);
    std::vector<ShellPlace> places(found_.shells.size());
    for (std::uint32_t shell = 0; shell < places.size(); ++shell) {
      steps.ask();
      if (auto place = place_of(shell); work_ <= work.most) {
        place.judged = ShellPlace::Judged::Yes;
        places[shell] = place;
      } else {
        break;
      }
    }
    return places;
  }

 private:
  ShellPlace place_of(std::uint32_t shell) {
    ShellPlace place;
    std::vector<Point> extremes;
    work_ += found_.shells.size();
    for (std::uint32_t other = 0; other < found_.shells.size(); ++other) {
      const Shell& around = found_.shells[other];
      if (other == shell || !around.is_closed || !contains(around.box, found_.shells[shell].box)) {
        continue;
      }
      if (extremes.empty()) {
        extremes = extremes_of(shell);
      }
      std::size_t inside = 0;
      for (const Point& p : extremes) {
        inside += is_in(p, other) ? 1U : 0U;
      }
      place.depth += inside == extremes.size() ? 1U : 0U;
      place.crosses = place.crosses || (inside > 0 && inside < extremes.size());
    }
    return place;
  }

  /// The vertices that are the farthest along each axis.
  std::vector<Point> extremes_of(std::uint32_t shell) {
    std::vector<Point> points(6, mesh_.vertices[mesh_.triangles[facets_.of(shell)[0]][0]]);
    work_ += facets_.of(shell).size();
    for (const std::uint32_t t : facets_.of(shell)) {
      for (const std::uint32_t corner : mesh_.triangles[t]) {
        const Point& p = mesh_.vertices[corner];
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
          Point& least = points[static_cast<std::size_t>(axis)];
          Point& most = points[static_cast<std::size_t>(axis) + 3];
          least = p[axis] < least[axis] ? p : least;
          most = p[axis] > most[axis] ? p : most;
        }
      }
    }
    return points;
  }

  /// By the winding number, which is 0 or 1 in size.
  bool is_in(const Point& p, std::uint32_t shell) {
    double sum = 0.0;
    work_ += facets_.of(shell).size();
    for (const std::uint32_t t : facets_.of(shell)) {
      const auto& corners = mesh_.triangles[t];
      sum += solid_angle(p, mesh_.vertices[corners[0]], mesh_.vertices[corners[1]],
                         mesh_.vertices[corners[2]]);
    }
    return std::fabs(sum) > 2.0 * std::numbers::pi;
  }

  const Mesh& mesh_;
  const MeshShells& found_;
  const FacetsByShell& facets_;
  std::uint64_t work_ = 0;
};

std::array<Point, 3> corners_of(const Mesh& mesh, std::uint32_t t) {
  const auto& v = mesh.triangles[t];
  return {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]};
}

/// From a point to a segment.
double distance_to_side(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * along).norm();
}

double distance_to_facet(const Point& p, const std::array<Point, 3>& v) {
  const Point normal = (v[1] - v[0]).cross(v[2] - v[0]);
  double nearest = std::numeric_limits<double>::infinity();
  bool is_above = normal.squaredNorm() > 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& a = v.at(i);
    const Point& b = v.at((i + 1) % 3);
    nearest = std::min(nearest, distance_to_side(p, a, b));
    is_above = is_above && (b - a).cross(p - a).dot(normal) >= 0.0;
  }
  return is_above ? std::fabs((p - v[0]).dot(normal)) / normal.norm() : nearest;
}

}  // namespace

std::vector<ShellPlace> shell_places(const Mesh& mesh, const MeshShells& found,
                                     const FacetsByShell& facets, const NestingWork& work) {
  return ShellNesting(mesh, found, facets).places(work);
}

std::vector<std::uint32_t> stray_shells(const Mesh& mesh, const MeshShells& found,
                                        const std::vector<ShellPlace>& places) {
  constexpr double kSmall = 0.01;  // of the largest
  constexpr double kFarSizes = 2.0;
  double largest = 0.0;
  for (const Shell& shell : found.shells) {
    largest = std::max(largest, shell.diagonal());
  }
  const auto is_small = [&](std::uint32_t shell) {
    return found.shells[shell].diagonal() <= kSmall * largest;
  };
  std::vector<std::uint32_t> stray;
  for (std::uint32_t shell = 0; shell < found.shells.size(); ++shell) {
    const bool is_a_point = found.shells[shell].is_closed && found.shells[shell].facets == 1;
    if (is_small(shell) && !is_a_point && places[shell].depth == 0) {
      stray.push_back(shell);
    }
  }
  if (stray.empty()) {
    return stray;
  }
  std::vector<Bvh::Twig> large;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_small(found.shell_of[t])) {
      Bvh::Twig& twig = large.emplace_back();
      twig.slot = t;
      for (const Point& corner : corners_of(mesh, t)) {
        twig.box.include(corner);
      }
    }
  }
  const Bvh tree(std::move(large));
  std::erase_if(stray, [&](std::uint32_t number) {
    const Shell& shell = found.shells[number];
    const double far = kFarSizes * shell.diagonal();
    const Point& p = mesh.vertices[mesh.triangles[shell.first_facet][0]];
    double nearest = std::numeric_limits<double>::infinity();
    tree.visit_near(p, far, [&](std::uint32_t t) {
      nearest = std::min(nearest, distance_to_facet(p, corners_of(mesh, t)));
      return far;
    });
    return nearest <= far;
  });
  return stray;
}

}  // namespace g31::parts
