#include "probe/sensor/touchable_parts.h"

#include <algorithm>
#include <memory>

#include "machine/base/contract.h"

namespace g31::probe {

TouchableParts::TouchableParts(const ProbeSetup& setup, const std::vector<ProbedPart>& parts,
                               const parts::GoesOn& goes_on) {
  bool has_sections = false;
  for (const ToolBody& body : bodies_of(setup)) {
    if (const auto* const ball = std::get_if<Ball>(&body.shape)) {
      G31_EXPECTS(ball->radius_mm > 0.0);
      add_radius(ball->radius_mm);
    } else {
      has_sections = true;
    }
  }
  parts_.reserve(parts.size());
  for (const ProbedPart& part : parts) {
    G31_EXPECTS(!is_on_tool_side(part.mount));
    Part& built = parts_.emplace_back(
        Part{part.name,
             part.is_solid,
             encounter_of(Role::SensingTip, part.role, machine::Travel::Feed),
             encounter_of(Role::SensingTip, part.role, machine::Travel::Skip),
             std::make_shared<const ContactMesh>(part.mesh_M, part.sphere_M, goes_on),
             {}});
    built.sweepers.reserve(radii_.size());
    for (const double radius : radii_) {
      built.sweepers.emplace_back(built.mesh, radius);
    }
    if (has_sections) {
      solids_.emplace_back(built.mesh);
    }
  }
}

std::size_t TouchableParts::size_of(double radius) const {
  const auto known = std::ranges::find(radii_, radius);
  G31_EXPECTS(known != radii_.end());
  return static_cast<std::size_t>(known - radii_.begin());
}

void TouchableParts::add_radius(double radius) {
  if (std::ranges::find(radii_, radius) == radii_.end()) {
    radii_.push_back(radius);
  }
}

}  // namespace g31::probe
