#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "tools/picture/raster.h"
#include "tools/picture/still.h"

namespace g31::picture {

/// The colours of a still (design of reports: light and dark have their own values).
struct Palette {
  const char* paper;
  const char* ink;
  const char* faint;
  const char* accent;
  const char* bad;
  const char* ways[kPathKinds];
  Rgb paper_rgb;
  Rgb line;
  Material part;
  Material fixture;
  Material stylus;
  Material ball;
};
const Palette& palette_of(Theme theme);

/// What the picture is of, mm: what was touched, and the parts about it.
Eigen::AlignedBox3d focus_of(const StillScene& scene);

View isometric_view(const StillScene& scene, int width, int height);
/// From above; where touches go along Z and one axis more, and on a machine without Y, along the
/// third.
View plan_view(const StillScene& scene, int width, int height);
/// "XY" as the axes go right and up.
std::string plane_of(const View& view);

/// How to cut the parts open so that more touches are seen; nullopt: nothing is won by it.
std::optional<CutOpen> cut_for(const StillScene& scene, const View& view);

/// The parts of a scene in a view of so many pixels.
Raster raster_of_parts(const StillScene& scene, const View& view, std::optional<CutOpen> cut,
                       const Palette& palette);

}  // namespace g31::picture
