#include "parts/import/round_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace g31::parts {
namespace {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;

/// Two angles of one facet, two heights of one edge.
constexpr double kSameMm = 1e-7;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// The triangle that has an edge in this direction.
class EdgeMap {
 public:
  explicit EdgeMap(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      add(mesh.triangles[i], i);
    }
  }

  void add(const Triangle& triangle, std::size_t index) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      by_edge_[key(triangle[corner], triangle[(corner + 1) % 3])] = index;
    }
  }

  [[nodiscard]] std::optional<std::size_t> find(Index from, Index to) const {
    const auto found = by_edge_.find(key(from, to));
    return found == by_edge_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  static std::uint64_t key(Index from, Index to) {
    return (static_cast<std::uint64_t>(from) << 32U) | to;
  }

  std::unordered_map<std::uint64_t, std::size_t> by_edge_;
};

/// An edge of a wall along its upper or lower end, as its triangle has it.
struct RimEdge {
  Index from = 0;
  Index to = 0;
};

class WallRefiner {
 public:
  WallRefiner(Mesh& mesh, EdgeMap& edges, const RoundWall& wall)
      : mesh_(mesh), edges_(edges), wall_(wall) {}

  void refine() {
    if (!find_rims() || !match_rims()) {
      return;
    }
    for (std::size_t i = wall_.first; i < wall_.last; ++i) {
      mesh_.triangles[i] = {0, 0, 0};  // taken out at the end
    }
    for (std::size_t i = 0; i < lower_.size(); ++i) {
      rebuild(lower_[i], upper_[i]);
    }
  }

 private:
  [[nodiscard]] double angle_of(Index vertex) const {
    const Point out = mesh_.vertices[vertex] - wall_.axis_at;
    return std::atan2(out.y(), out.x());
  }

  /// The edges at both ends; false: there are others, or vertices between them.
  bool find_rims() {
    double low = mesh_.vertices[mesh_.triangles[wall_.first][0]].z();
    double high = low;
    for (std::size_t i = wall_.first; i < wall_.last; ++i) {
      for (const Index vertex : mesh_.triangles[i]) {
        low = std::min(low, mesh_.vertices[vertex].z());
        high = std::max(high, mesh_.vertices[vertex].z());
      }
    }
    for (std::size_t i = wall_.first; i < wall_.last; ++i) {
      const Triangle& triangle = mesh_.triangles[i];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const RimEdge edge{triangle[corner], triangle[(corner + 1) % 3]};
        const double z = mesh_.vertices[edge.from].z();
        const bool is_low = z - low < kSameMm;
        if (!is_low && high - z > kSameMm) {
          return false;
        }
        if (std::abs(mesh_.vertices[edge.to].z() - z) < kSameMm) {
          (is_low ? lower_ : upper_).push_back(edge);
        }
      }
    }
    return high - low > kSameMm && lower_.size() == upper_.size() && has_neighbours();
  }

  [[nodiscard]] bool has_neighbours() const {
    const auto has = [&](const RimEdge& edge) {
      const auto beside = edges_.find(edge.to, edge.from);
      return beside && (*beside < wall_.first || *beside >= wall_.last);
    };
    return std::ranges::all_of(lower_, has) && std::ranges::all_of(upper_, has);
  }

  /// Puts the upper edges beside the lower ones that they are above.  Those run the other way.
  bool match_rims() {
    const auto begins_at = [&](Index vertex) { return angle_of(vertex); };
    std::ranges::sort(lower_, {}, [&](const RimEdge& edge) { return begins_at(edge.from); });
    std::ranges::sort(upper_, {}, [&](const RimEdge& edge) { return begins_at(edge.to); });
    for (std::size_t i = 0; i < lower_.size(); ++i) {
      if (!is_above(upper_[i].to, lower_[i].from) || !is_above(upper_[i].from, lower_[i].to)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool is_above(Index upper, Index lower) const {
    const Point apart = mesh_.vertices[upper] - mesh_.vertices[lower];
    return std::hypot(apart.x(), apart.y()) < kSameMm;
  }

  /// Angles strictly between those of an edge at which corners are wanted, in its direction.
  [[nodiscard]] std::vector<double> angles_between(double from, double to) const {
    const double span = std::remainder(to - from, kTurn);
    const double least = std::sqrt(8.0 * kSagittaAtExtremesMm / wall_.radius_mm);
    std::vector<double> angles;
    const auto take = [&](double angle) {
      const double share = std::remainder(angle - from, kTurn) / span;
      const double margin = 0.5 * least / std::abs(span);
      if (share > margin && share < 1.0 - margin) {
        angles.push_back(angle);
      }
    };
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double extreme = quarter * kTurn / 4.0;
      take(extreme);
      // A facet from a to b beside an extreme keeps off a ball r in a hole R where
      // b - a < 2 a sqrt(R/r - 1): those of the mesh do so from twice their width on.
      constexpr double kWider = 1.5;
      constexpr double kWidths = 2.0;
      for (double away = least; away < kWidths * std::abs(span); away *= kWider) {
        take(extreme + away);
        take(extreme - away);
      }
    }
    std::ranges::sort(angles, {},
                      [&](double angle) { return std::remainder(angle - from, kTurn) / span; });
    return angles;
  }

  Index vertex_at(double angle, double z) {
    // Exact at the extremes.
    const double quarters = angle / (kTurn / 4.0);
    const bool is_extreme = quarters == std::round(quarters);
    double c = std::cos(angle);
    double s = std::sin(angle);
    if (is_extreme) {
      c = std::round(c);
      s = std::round(s);
    }
    mesh_.vertices.emplace_back(wall_.axis_at.x() + wall_.radius_mm * c,
                                wall_.axis_at.y() + wall_.radius_mm * s, z);
    return static_cast<Index>(mesh_.vertices.size() - 1);
  }

  /// The corners of a rim edge with those between; the neighbour gets them too.
  std::vector<Index> divided(const RimEdge& edge, const std::vector<double>& angles) {
    std::vector<Index> corners = {edge.from};
    for (const double angle : angles) {
      corners.push_back(vertex_at(angle, mesh_.vertices[edge.from].z()));
    }
    corners.push_back(edge.to);
    divide_neighbour(edge, corners);
    return corners;
  }

  void divide_neighbour(const RimEdge& edge, const std::vector<Index>& corners) {
    const std::size_t beside = *edges_.find(edge.to, edge.from);
    const Triangle old = mesh_.triangles[beside];
    Index tip = old[0];
    for (const Index vertex : old) {
      tip = vertex != edge.from && vertex != edge.to ? vertex : tip;
    }
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const Triangle piece = {corners[i + 1], corners[i], tip};
      if (i == 0) {
        mesh_.triangles[beside] = piece;
        edges_.add(piece, beside);
      } else {
        add(piece);
      }
    }
  }

  void add(const Triangle& triangle) {
    mesh_.triangles.push_back(triangle);
    edges_.add(triangle, mesh_.triangles.size() - 1);
  }

  void rebuild(const RimEdge& lower, const RimEdge& upper) {
    const auto angles = angles_between(angle_of(lower.from), angle_of(lower.to));
    const auto low = divided(lower, angles);
    auto high = divided(upper, {angles.rbegin(), angles.rend()});
    std::ranges::reverse(high);
    for (std::size_t i = 0; i + 1 < low.size(); ++i) {
      add({low[i], low[i + 1], high[i + 1]});
      add({low[i], high[i + 1], high[i]});
    }
  }

  Mesh& mesh_;
  EdgeMap& edges_;
  const RoundWall& wall_;
  std::vector<RimEdge> lower_;
  std::vector<RimEdge> upper_;
};

}  // namespace

void refine_round_walls(Mesh& mesh, const std::vector<RoundWall>& walls) {
  EdgeMap edges(mesh);
  for (const RoundWall& wall : walls) {
    if (wall.first < wall.last) {
      WallRefiner(mesh, edges, wall).refine();
    }
  }
  std::erase_if(mesh.triangles,
                [](const Triangle& triangle) { return triangle[0] == triangle[1]; });
}

}  // namespace g31::parts
