#include "probe/collision/rigid_touch.h"

#include <utility>

namespace g31::probe {
namespace {

SectionPlace place_of(const ProbeSection& section, const Point& p_M_ball,
                      const Eigen::Quaterniond& turn) {
  return {p_M_ball + turn * section.p_S, turn * section.turn_S};
}

/// A section that is round about the spindle's axis does not show its turning.
SweptSection swept_by(const ProbeSection& section, const CentreWay& way) {
  const bool is_round = section.p_S.head<2>().isZero(0.0) &&
                        section.turn_S.coeffs() == Eigen::Quaterniond::Identity().coeffs();
  const Eigen::Quaterniond from = is_round ? way.turn_from : way.turn_from * way.spindle;
  const Eigen::Quaterniond to = is_round ? way.turn_to : way.turn_to * way.spindle;
  return {&section, place_of(section, way.p_M_from, from), place_of(section, way.p_M_to, to),
          way.margin + sag_of_turn(reach_of(section), from, to)};
}

}  // namespace

std::optional<RigidTouch> first_touch(std::span<const ProbeSection> sections,
                                      std::span<const CollisionMesh> parts, const CentreWay& way) {
  std::optional<RigidTouch> first;
  for (const ProbeSection& section : sections) {
    const SweptSection swept = swept_by(section, way);
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
