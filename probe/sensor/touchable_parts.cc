#include "probe/sensor/touchable_parts.h"

#include <algorithm>

#include "machine/base/contract.h"

namespace g31::probe {

TouchableParts::TouchableParts(const ProbeSetup& setup, const std::vector<ProbedPart>& parts) {
  G31_EXPECTS(setup.ball_diameter_mm > 0.0);
  add_radius(0.5 * setup.ball_diameter_mm);
  for (const StylusBall& ball : setup.further_balls) {
    add_radius(0.5 * ball.diameter_mm);
  }
  parts_.reserve(parts.size());
  for (const ProbedPart& part : parts) {
    Part& built = parts_.emplace_back(Part{part.name, {}});
    built.sweepers.reserve(radii_.size());
    for (const double radius : radii_) {
      built.sweepers.emplace_back(part.mesh_M, radius);
    }
    if (!setup.stem.empty() || !setup.bodies.empty()) {
      solids_.emplace_back(part.mesh_M);
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
