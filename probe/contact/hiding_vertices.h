#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "machine/units/point.h"
#include "probe/contact/contact_triangle.h"
#include "probe/contact/exposed_directions.h"

namespace g31::probe {

/// Vertices that keep a ball from what lies lower beside them.
///
/// A ball of radius r with its centre at p + r n overlaps a vertex u where
/// (u - p) . n > |u - p|^2 / (2 r).  Whatever it touches at p then, it has met the mesh before:
/// such a centre is none of the offset surface.  Only what overlaps by more than kHiddenMm counts,
/// far more than rounding: what is left out is never the first contact.
class HidingVertices {
 public:
  static constexpr double kHiddenMm = 1e-8;

  HidingVertices(std::vector<Point> vertices, double radius)
      : vertices_(std::move(vertices)), radius_(radius) {}

  /// Whether one vertex hides all of a face.  @param up  its normal on the side asked about
  [[nodiscard]] bool hide_face(const ContactTriangle& triangle, const Point& up);

  /// What of the directions around a vertex, or around an edge between two, is not hidden, and at
  /// most a little of what is.
  [[nodiscard]] ExposedPiece left_of(const ExposedPiece& piece, const std::array<Point, 2>& ends);

 private:
  /// The last that hid something is the first to be asked again.
  void ask_first(std::size_t i) { std::swap(vertices_[i], vertices_[i / 2]); }

  std::vector<Point> vertices_;
  double radius_;
};

}  // namespace g31::probe
