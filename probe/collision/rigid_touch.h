#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "probe/collision/collision_mesh.h"
#include "probe/collision/probe_section.h"

namespace g31::probe {

/// A straight way of the main ball's centre, and how the probe turns on it.
struct CentreWay {
  Point p_M_from;       ///< mm
  Point p_M_to;         ///< mm
  double margin = 0.0;  ///< mm: what comes so near counts as touching
  Eigen::Quaterniond turn_from = Eigen::Quaterniond::Identity();  ///< of the whole probe
  Eigen::Quaterniond turn_to = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond spindle = Eigen::Quaterniond::Identity();  ///< about its own axis, before that
};

/// Where a piece of the probe that is not a ball first touches.
struct RigidTouch {
  SectionTouch touch;
  std::string section;   ///< its name
  std::size_t part = 0;  ///< index of the mesh
};

/// The first touch of any section with any part.  Accuracy: that of CollisionMesh; where the probe
/// turns, a section counts as touching within sag_of_turn.
std::optional<RigidTouch> first_touch(std::span<const ProbeSection> sections,
                                      std::span<const CollisionMesh> parts, const CentreWay& way);

}  // namespace g31::probe
