#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/picture/pictured_part.h"
#include "tools/picture/stylus_shape.h"
#include "tools/picture/way.h"

namespace g31::picture {

enum class Theme { Light, Dark };

/// What a still is of; the lists belong to somebody else.
struct StillScene {
  std::string title;
  std::span<const PicturedPart> parts;
  std::span<const Way> ways;
  std::span<const Mark> contacts;
  std::span<const Mark> collisions;
  std::span<const StylusPiece> stylus;
  double tip_radius_mm = 0.0;  ///< of ball or tool where it is shown last; 0: there is neither
  StylusPlace last;            ///< where the stylus is shown
  bool has_y = true;           ///< a machine without Y is shown in its plane of X and Z
};

struct StillLook {
  int width = 1200;  ///< pixels, kLeastStillPixels to kMostStillPixels
  Theme theme = Theme::Light;
};

inline constexpr int kLeastStillPixels = 600;
inline constexpr int kMostStillPixels = 4000;

/// A picture of a run for documents, as SVG: isometric, cut open where that shows more touches, and
/// beside it along the axis that the touches do not use, as a rule from above.
///
/// Bodies are pixels within it, everything else lines: ways by kind of motion, dotted where
/// something is before them; touches with their numbers; in the plan how much deeper than the wall
/// each ball was latched, magnified.  The same scene gives the same bytes.
std::string still_svg(const StillScene& scene, const StillLook& look);

}  // namespace g31::picture
