#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "probe/collision/collision_mesh.h"
#include "probe/collision/probe_section.h"

namespace g31::probe {

/// A straight way of the main ball's centre.
struct CentreWay {
  Point p_M_from;       ///< mm
  Point p_M_to;         ///< mm
  double margin = 0.0;  ///< mm: what comes so near counts as touching
};

/// Where a piece of the probe that is not a ball first touches.
struct RigidTouch {
  SectionTouch touch;
  std::string section;   ///< its name
  std::size_t part = 0;  ///< index of the mesh
};

/// The first touch of any section with any part.  Accuracy: that of CollisionMesh.
std::optional<RigidTouch> first_touch(std::span<const ProbeSection> sections,
                                      std::span<const CollisionMesh> parts, const CentreWay& way);

}  // namespace g31::probe
