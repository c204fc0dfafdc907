#include "tools/picture/folds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "machine/base/contract.h"
#include "tools/picture/feature_edges.h"

namespace g31::picture {
namespace {

using Corner = std::uint32_t;
using Triangle = std::array<Corner, 3>;

constexpr std::uint32_t kNoTriangle = ~std::uint32_t{0};

/// Half of what edges of drawings bend by (feature_edges).
const double kFold = 1.0 - std::cos(10.0 * std::numbers::pi / 180.0);

/// Less than that is rounding.
constexpr double kLeastGain = 1e-9;

void leave_out(parts::Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
  std::vector<bool> goes(mesh.triangles.size());
  for (const std::uint32_t triangle : triangles) {
    goes[triangle] = true;
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < goes.size(); ++t) {
    if (!goes[t]) {
      mesh.triangles[kept++] = mesh.triangles[t];
    }
  }
  mesh.triangles.resize(kept);
}

class Flips {
 public:
  Flips(parts::Mesh& mesh, double most_error_mm) : mesh_(mesh), most_error_mm_(most_error_mm) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      normals_.push_back(normal_of(corners));
      for (std::size_t i = 0; i < 3; ++i) {
        Sides& sides = sides_[key(corners.at(i), corners.at((i + 1) % 3))];
        ++sides.count;
        (sides.one == kNoTriangle ? sides.one : sides.other) = t;
      }
    }
  }

  void run() {
    std::vector<std::uint64_t> next;
    for (const auto& [edge, sides] : sides_) {
      next.push_back(edge);
    }
    // A table has no order of its own, and a picture is the same each time.
    std::ranges::sort(next, std::greater<>());
    while (!next.empty()) {
      const std::uint64_t edge = next.back();
      next.pop_back();
      const auto at = sides_.find(edge);
      if (at != sides_.end() && bend(at->second) > kFold) {
        flip(edge, next);
      }
    }
    leave_out(mesh_, gone_);
  }

 private:
  struct Sides {
    std::uint32_t one = kNoTriangle;
    std::uint32_t other = kNoTriangle;
    int count = 0;
  };

  /// Two triangles that share the edge from a to b, each the other way round, and the corners
  /// across.
  struct Pair {
    std::uint32_t left = 0;   // a b c
    std::uint32_t right = 0;  // b a d
    Corner a = 0;
    Corner b = 0;
    Corner c = 0;
    Corner d = 0;
  };

  static std::uint64_t key(Corner a, Corner b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }

  [[nodiscard]] const Point& at(Corner corner) const { return mesh_.vertices[corner]; }

  [[nodiscard]] Point normal_of(const Triangle& t) const {
    return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).stableNormalized();
  }

  /// 0 flat, 2 folded back; what has no area, or no other side, bends by nothing that a flip mends.
  [[nodiscard]] double bend(const Sides& sides) const {
    return sides.count == 2 ? 1.0 - normals_[sides.one].dot(normals_[sides.other]) : 0.0;
  }

  /// What lies across an edge from a triangle bends it by so much.
  [[nodiscard]] double bend_at(Corner a, Corner b, std::uint32_t from, const Point& normal) const {
    const Sides& sides = sides_.at(key(a, b));
    if (sides.count != 2) {
      return 0.0;
    }
    return 1.0 - normal.dot(normals_[sides.one == from ? sides.other : sides.one]);
  }

  [[nodiscard]] std::optional<Pair> pair_at(std::uint64_t edge) const {
    const Sides& sides = sides_.at(edge);
    Pair pair{sides.one, sides.other, static_cast<Corner>(edge >> 32U),
              static_cast<Corner>(edge & 0xFFFFFFFFU)};
    const auto place = [&](std::uint32_t triangle, Corner corner) {
      const Triangle& t = mesh_.triangles[triangle];
      return static_cast<std::size_t>(std::ranges::find(t, corner) - t.begin());
    };
    if (mesh_.triangles[pair.left].at((place(pair.left, pair.a) + 1) % 3) != pair.b) {
      std::swap(pair.left, pair.right);
    }
    const Triangle& left = mesh_.triangles[pair.left];
    const Triangle& right = mesh_.triangles[pair.right];
    if (left.at((place(pair.left, pair.a) + 1) % 3) != pair.b ||
        right.at((place(pair.right, pair.b) + 1) % 3) != pair.a) {
      return std::nullopt;  // turned over against each other
    }
    pair.c = left.at((place(pair.left, pair.a) + 2) % 3);
    pair.d = right.at((place(pair.right, pair.b) + 2) % 3);
    return pair;
  }

  /// How far the diagonals of the four corners are apart.
  [[nodiscard]] double gap(const Pair& p) const {
    const Point across = (at(p.b) - at(p.a)).cross(at(p.d) - at(p.c));
    const double length = across.norm();
    return length > 0.0 ? std::abs(across.dot(at(p.c) - at(p.a))) / length : 0.0;
  }

  void flip(std::uint64_t edge, std::vector<std::uint64_t>& next) {
    const auto pair = pair_at(edge);
    if (!pair || pair->c == pair->d) {
      return;
    }
    if (sides_.contains(key(pair->c, pair->d))) {
      const Pair& p = *pair;
      if (!remove_corner(p, next)) {
        remove_corner({p.right, p.left, p.b, p.a, p.d, p.c}, next);
      }
      return;
    }
    if (gap(*pair) > most_error_mm_) {
      return;
    }
    const auto& [left, right, a, b, c, d] = *pair;
    const Triangle new_left = {a, d, c};
    const Triangle new_right = {d, b, c};
    const Point n_left = normal_of(new_left);
    const Point n_right = normal_of(new_right);
    const double before = bend(sides_.at(edge)) + bend_at(b, c, left, normals_[left]) +
                          bend_at(c, a, left, normals_[left]) +
                          bend_at(a, d, right, normals_[right]) +
                          bend_at(d, b, right, normals_[right]);
    const double after = 1.0 - n_left.dot(n_right) + bend_at(b, c, left, n_right) +
                         bend_at(c, a, left, n_left) + bend_at(a, d, right, n_left) +
                         bend_at(d, b, right, n_right);
    if (after > before - kLeastGain) {
      return;
    }
    sides_.erase(edge);
    sides_[key(c, d)] = {left, right, 2};
    pass_on(key(b, c), left, right);
    pass_on(key(a, d), right, left);
    mesh_.triangles[left] = new_left;
    mesh_.triangles[right] = new_right;
    normals_[left] = n_left;
    normals_[right] = n_right;
    next.insert(next.end(), {key(b, c), key(c, a), key(a, d), key(d, b), key(c, d)});
  }

  /// Where the corner a has three triangles alone, one takes their place if the surface bends less.
  bool remove_corner(const Pair& pair, std::vector<std::uint64_t>& next) {
    const auto& [left, right, a, b, c, d] = pair;
    const auto third_at = [&](Corner end, std::uint32_t known) {
      const Sides& sides = sides_.at(key(pair.a, end));
      return sides.count != 2 ? kNoTriangle : sides.one == known ? sides.other : sides.one;
    };
    const std::uint32_t third = third_at(c, left);
    if (third == kNoTriangle || third != third_at(d, right) || sides_.at(key(c, d)).count != 2) {
      return false;
    }
    const Triangle whole = {d, b, c};
    const Point n = normal_of(whole);
    const double before =
        bend_at(a, b, left, normals_[left]) + bend_at(a, c, left, normals_[left]) +
        bend_at(a, d, right, normals_[right]) + bend_at(b, c, left, normals_[left]) +
        bend_at(d, b, right, normals_[right]) + bend_at(c, d, third, normals_[third]);
    const double after = bend_at(b, c, left, n) + bend_at(d, b, right, n) + bend_at(c, d, third, n);
    if (std::abs(n.dot(at(a) - at(b))) > most_error_mm_ || after > before - kLeastGain) {
      return false;
    }
    for (const Corner end : {b, c, d}) {
      sides_.erase(key(a, end));
    }
    pass_on(key(d, b), right, left);
    pass_on(key(c, d), third, left);
    mesh_.triangles[left] = whole;
    normals_[left] = n;
    gone_.insert(gone_.end(), {right, third});
    next.insert(next.end(), {key(b, c), key(c, d), key(d, b)});
    return true;
  }

  /// Another triangle is on a side of an edge.
  void pass_on(std::uint64_t edge, std::uint32_t from, std::uint32_t to) {
    Sides& sides = sides_.at(edge);
    (sides.one == from ? sides.one : sides.other) = to;
  }

  parts::Mesh& mesh_;
  double most_error_mm_;
  std::vector<Point> normals_;
  std::vector<std::uint32_t> gone_;
  std::unordered_map<std::uint64_t, Sides> sides_;
};

/// Two triangles of the same corners are nothing between them.
void drop_twins(parts::Mesh& mesh) {
  std::vector<std::pair<Triangle, std::uint32_t>> by_corners;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::ranges::sort(corners);
    by_corners.emplace_back(corners, t);
  }
  std::ranges::sort(by_corners);
  std::vector<std::uint32_t> twins;
  for (std::size_t i = 1; i < by_corners.size(); ++i) {
    if (by_corners[i].first == by_corners[i - 1].first) {
      twins.insert(twins.end(), {by_corners[i - 1].second, by_corners[i].second});
      ++i;
    }
  }
  leave_out(mesh, twins);
}

}  // namespace

void mend_folds(parts::Mesh& mesh, double most_error_mm) {
  G31_EXPECTS(most_error_mm > 0.0);
  drop_twins(mesh);
  Flips(mesh, most_error_mm).run();
}

Folds count_folds(const parts::Mesh& mesh) {
  constexpr double kFoldedBackDeg = 150.0;
  return {feature_edges(mesh).size(), feature_edges(mesh, kFoldedBackDeg).size()};
}

}  // namespace g31::picture
