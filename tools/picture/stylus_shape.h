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
  Point p_S_centre = Point::Zero();  ///< of a ball: from that of the main one
  double radius_mm = 0.0;            ///< of a ball
};

/// What the spindle holds in true size: of the probe its balls, stem and bodies as far as the sheet
/// says, of a tool its outline, told from its lowest point.  Nothing without either.
/// @param tool  as StylusPlace has it
std::vector<StylusPiece> stylus_shape(const setup::Job& job, int tool);

/// mm, of the main ball or of the tool; 0: there is neither.
double tip_radius(const setup::Job& job, int tool);

/// The ball of the stylus at `mark.stylus` that touched: of all whose surface has the normal of the
/// mark at its place the nearest one, as it was pushed in less than others are away.  Of a tool its
/// tip; nullopt: there is neither.
std::optional<TouchingBall> touching_ball(const setup::Job& job, const Mark& mark);

/// How much deeper than the wall, along the inward normal, the ball was latched, mm; nullopt: a
/// tool touched, or no ball is known.
std::optional<double> latched_depth_mm(const Mark& mark);

/// A mesh that is told from the ball's centre, where that stands in the machine.
parts::Mesh standing_at(const parts::Mesh& mesh_S, const StylusPlace& place);

/// A body of revolution about Z.
/// @param profile  from its lower to its upper end: radius and height, mm; radii >= 0
parts::Mesh turned_body(const std::vector<Eigen::Vector2d>& profile, int sides = 48);

}  // namespace g31::picture
