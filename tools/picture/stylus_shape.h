#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parts/geometry/mesh.h"
#include "tools/picture/way.h"
#include "tools/setup/job.h"

namespace g31::picture {

/// A piece of what the spindle holds.
struct StylusPiece {
  std::string name;  ///< "stylus ball", "stem", or as the sheet calls it
  bool is_ball = false;
  parts::Mesh mesh_S;  ///< mm, from the centre of the main ball or the tip at spindle angle 0
};

/// What the spindle holds in true size: of the probe its balls, stem and bodies as far as the sheet
/// says, of a tool its outline, told from its lowest point.  Nothing without either.
/// @param tool  as StylusPlace has it
std::vector<StylusPiece> stylus_shape(const setup::Job& job, int tool);

/// mm, of the main ball or of the tool; 0: there is neither.
double tip_radius(const setup::Job& job, int tool);

/// How much deeper than the wall, along the inward normal, the main ball was latched, mm; nullopt:
/// a tool or another ball touched, or no radius is known.
/// @param ball_radius_mm  0: not known
std::optional<double> latched_depth_mm(const Mark& mark, double ball_radius_mm);

/// A mesh that is told from the ball's centre, where that stands in the machine.
parts::Mesh standing_at(const parts::Mesh& mesh_S, const StylusPlace& place);

/// A body of revolution about Z.
/// @param profile  from its lower to its upper end: radius and height, mm; radii >= 0
parts::Mesh turned_body(const std::vector<Eigen::Vector2d>& profile, int sides = 48);

}  // namespace g31::picture
