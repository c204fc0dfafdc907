#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "machine/units/point.h"
#include "parts/geometry/box.h"

namespace g31::probe {

/// The directions d in which a ball can stand at an edge or a vertex and touch nothing nearer:
/// those with d . away <= 0 for every direction `away` in which the surface goes on from there.
/// Such a set is an arc around an edge, a patch of the sphere around a vertex; or empty, where the
/// surface is hollow.  It does not matter which way round the triangles turn, or how many of them
/// meet.
///
/// Both functions cut it into pieces of at most a right angle, and widen it by about
/// kExposureSlackRad.

/// The corners of one piece, unit vectors: the piece lies in the cone that they span.
struct ExposedPiece {
  static constexpr std::size_t kMostCorners = 32;
  std::array<Point, kMostCorners> corners;
  std::size_t count = 0;

  [[nodiscard]] Point middle() const;
  /// Around all of the piece on the unit sphere.
  [[nodiscard]] parts::Box box() const;
};

inline constexpr double kExposureSlackRad = 1e-7;

/// All pieces of one set: there is at most one on each side of a cube.
class ExposedPieces {
 public:
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const ExposedPiece* begin() const { return pieces_.data(); }
  [[nodiscard]] const ExposedPiece* end() const { return pieces_.data() + count_; }

  /// An empty one to fill in.
  ExposedPiece& add() { return pieces_[count_++]; }

 private:
  std::array<ExposedPiece, 6> pieces_;
  std::size_t count_ = 0;
};

/// @param edge  unit vector along the edge
/// @param away  unit vectors at right angles to the edge, into each triangle there
ExposedPieces exposed_around_edge(const Point& edge, std::span<const Point> away);

/// @param away  unit vectors along each edge from the vertex
ExposedPieces exposed_around_vertex(std::span<const Point> away);

}  // namespace g31::probe
