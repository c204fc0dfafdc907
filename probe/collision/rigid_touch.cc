#include "probe/collision/rigid_touch.h"

#include <utility>

namespace g31::probe {

std::optional<RigidTouch> first_touch(std::span<const ProbeSection> sections,
                                      std::span<const CollisionMesh> parts, const CentreWay& way) {
  std::optional<RigidTouch> first;
  for (const ProbeSection& section : sections) {
    const SweptSection swept{&section, way.p_M_from, way.p_M_to - way.p_M_from, way.margin};
    for (std::size_t part = 0; part < parts.size(); ++part) {
      auto touch = parts[part].first_touch(swept);
      if (touch && (!first || touch->fraction < first->touch.fraction)) {
        first = RigidTouch{*std::move(touch), section.name, part};
      }
    }
  }
  return first;
}

}  // namespace g31::probe
