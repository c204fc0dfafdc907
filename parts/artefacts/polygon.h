#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace g31::parts {

using Point2 = Eigen::Vector2d;

/// The corners of a regular polygon whose sides are tangent to the circle of that radius about the
/// origin, counter-clockwise; the middle of the side before corner 0 lies on +X.
///
/// Built from its smallest piece by mirroring, so that the polygon is exactly symmetric and its
/// sides on the axes (+X; -X with an even number; all four with a multiple of 4) are exactly at
/// the radius.
/// @param sides  >= 3
std::vector<Point2> tangent_polygon(double radius, std::size_t sides);

/// The corners of a rectangle about the origin, counter-clockwise from the one in the first
/// quadrant; with a corner radius each corner is `corner_sides` facets tangent to it, half of the
/// first and the last of them as prolongations of the straight sides.
/// @param corner_radius  0 for sharp corners, at most half of the shorter side
std::vector<Point2> rectangle(const Point2& size, double corner_radius, std::size_t corner_sides);

/// Of one circle: beyond it a mesh only costs.
inline constexpr std::size_t kMostFacets = 100000;

/// How many sides, a multiple of 4, keep the corners of a tangent polygon within the sagitta of
/// its circle; nullopt: more than `most`.
std::optional<std::size_t> sides_within(double radius, double sagitta, std::size_t most);

/// The same for a sphere of equal sides along and across: its corners stand off by both ways.
std::optional<std::size_t> sphere_sides_within(double radius, double sagitta, std::size_t most);

}  // namespace g31::parts
