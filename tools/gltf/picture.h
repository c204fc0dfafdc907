#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

namespace g31::gltf {

/// What kind of motion drew a line.
enum class PathKind { Rapid, Feed, Skip };

inline constexpr std::size_t kPathKinds = 3;

/// Where something was touched, wanted or not.
struct Mark {
  Point p_M = Point::Zero();   ///< mm, machine frame
  Point n_M = Point::UnitZ();  ///< unit normal of the surface there
  std::string part;
  std::string what;  ///< "stylus ball touches ring"; empty for a wanted touch
};

/// Line segments: two points each, one segment after the other; mm, machine frame.
using Segments = std::vector<Point>;

/// What a program did, ready to be drawn.
struct Trace {
  std::array<Segments, kPathKinds> paths;  ///< of the stylus ball's centre, by PathKind
  std::vector<Mark> contacts;              ///< of skip moves, in order
  std::vector<Mark> collisions;
};

/// A part where it stands; the mesh belongs to somebody else.
struct PicturedPart {
  std::string name;
  const parts::Mesh* mesh_M = nullptr;
};

}  // namespace g31::gltf
