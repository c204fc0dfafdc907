#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "machine/units/point.h"
#include "probe/tooling/tool_setup.h"
#include "probe/tooling/tool_shape.h"

namespace g31::probe {

/// How a tool turns while it goes towards what it touches.
struct Turning {
  double angle_deg = 0.0;   ///< of the spindle where the widest and longest teeth would touch
  double rate_deg_s = 0.0;  ///< positive from +X towards +Y; not 0
  double speed_mm_s = 0.0;  ///< along the way; > 0
};

/// Where the outline of the teeth touches, in the frame of the tool at spindle angle 0.
struct OutlineTouch {
  Point n_T = Point::Zero();    ///< unit normal of the target, towards the tool
  Point way_T = Point::Zero();  ///< unit direction of the tool's way
  /// The target's highest point, from the gauge point: a shorter tooth passes above it.
  double z_T_top = 0.0;
  /// The face that a tooth touches from above: its middle from the tool's axis, the directions of
  /// its sides, halves of them, mm.
  Eigen::Vector2d p_T_face = Eigen::Vector2d::Zero();
  Eigen::Vector2d face_side = Eigen::Vector2d::UnitX();
  Eigen::Vector2d face_half = Eigen::Vector2d::Zero();
  bool is_face_round = false;
};

/// How much further than its outline a turning tool goes until the first tooth touches, mm: a short
/// tooth touches later, and each only when the spindle brings it.
///
/// The target is taken as its tangent plane at the contact: exact on flat sides, from above within
/// a 360th of the feed per revolution, however narrow the face is, within (F/n)^2 / 2R on a round
/// one of radius R for the feed per revolution F/n.
/// @param profiles  of these teeth, of which there is one at least
/// @return nullopt: none comes there, for all are too short
std::optional<double> way_to_first_tooth(const std::vector<Tooth>& teeth,
                                         const TeethProfiles& profiles, const OutlineTouch& touch,
                                         const Turning& turning);

}  // namespace g31::probe
