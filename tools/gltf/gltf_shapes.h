#pragma once

#include <span>
#include <vector>

#include "parts/geometry/mesh.h"
#include "tools/picture/way.h"

namespace g31::gltf {

/// A ball about the origin, as an icosahedron.
parts::Mesh small_ball(double radius_mm);

/// All chords of a kind of motion, two points each; mm, machine frame.
std::vector<Point> segments_of(std::span<const picture::Way> ways, picture::PathKind kind);

/// A prism of three sides about each segment: what viewers show that draw lines too thin, or not.
parts::Mesh tubes_about(std::span<const Point> segments, double radius_mm);

/// For each vertex a shade of grey by its height, the lowest one darkest: a floor is told from the
/// top.  Red, green and blue as a point, 0 to 1.
std::vector<Point> shades_by_height(const parts::Mesh& mesh_M);

}  // namespace g31::gltf
