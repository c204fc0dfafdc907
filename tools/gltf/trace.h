#pragma once

#include <span>

#include "tools/picture/stylus_shape.h"
#include "tools/picture/way.h"

namespace g31::gltf {

/// What a program did, ready to be drawn; the lists belong to somebody else.
struct Trace {
  std::span<const picture::Way> ways;       ///< in order
  std::span<const picture::Mark> contacts;  ///< of skip moves, in order
  std::span<const picture::Mark> collisions;
  std::span<const picture::StylusPiece> stylus;  ///< what the spindle holds
  picture::StylusPlace stylus_place;             ///< where it is shown
  bool is_of_part = false;  ///< all is in the frame of the part, which rotary axes turn
};

}  // namespace g31::gltf
