#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "parts/features/feature.h"
#include "parts/features/removed_volume.h"

namespace g31::parts {

/// The faces of a removed volume by what they are to whoever stands in it.
struct SortedFaces {
  using Faces = std::vector<const RemovedFace*>;
  Faces walls;    ///< upright planes
  Faces corners;  ///< upright cylinders: hollow, of an island round outside
  Faces floors;
  Faces edges;  ///< chamfers and roundings along the upper edge or the floor
  Faces open;
};

/// From where faces go round: from what is cut out, or from what is left standing in it.
enum class SeenFrom { Inside, Island };

/// Why faces of a volume are none that a kind has; nothing: they may be.
/// @param faces   of the volume
/// @param sorted  filled as far as that
std::optional<std::string> sort_faces(const RemovedVolume& volume, const SortedFaces::Faces& faces,
                                      SeenFrom from, SortedFaces& sorted);

/// What closes one side of a volume.
struct OutlineSide {
  bool is_open = false;
  bool is_wall = false;      ///< a plane, or the round end of a slot
  bool is_slanting = false;  ///< open, and not at right angles to the walls
  double at = 0.0;           ///< how far out it is, in own axes along the side's direction
};

/// A rectangle seen from above, each side a wall or open.
struct Outline {
  OwnAxes axes;
  std::array<OutlineSide, 4> sides;  ///< as Side counts X and Y
  double corner_radius_mm = 0.0;
};

/// The outline of a volume, or of an island in it, with straight walls.
/// @param outline  filled on success
/// @returns why it is no rectangle
std::optional<std::string> find_outline(const RemovedVolume& volume, const SortedFaces& sorted,
                                        SeenFrom from, Outline& outline);

/// The direction that a side shows to, in own axes.
Point direction_of(Side side);

}  // namespace g31::parts
