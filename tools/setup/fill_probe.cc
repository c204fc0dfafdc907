#include "tools/setup/fill_probe.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/contract.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

probe::ProbeSetup ball_and_signal_from(const TableKeys& keys) {
  probe::ProbeSetup probe;
  probe.ball_diameter_mm = keys.get(KeyId::ProbeBallDiameter, probe.ball_diameter_mm);
  probe.length_mm = keys.get(KeyId::ProbeLength, probe.length_mm);
  const std::vector<double> eccentricity =
      keys.get(KeyId::ProbeEccentricity, std::vector<double>{0.0, 0.0});
  probe.eccentricity_mm = {eccentricity.at(0), eccentricity.at(1)};
  probe.trigger_delay_s = keys.get(KeyId::ProbeTriggerDelay, probe.trigger_delay_s);
  probe.repeatability_mm = keys.get(KeyId::ProbeRepeatability, probe.repeatability_mm);
  return probe;
}

probe::SwitchSetup switch_from(const TableKeys& keys) {
  probe::SwitchSetup at_switch;
  at_switch.type = keys.get(KeyId::ProbeType, std::string("3D")) == "mono"
                       ? probe::ProbeType::Mono
                       : probe::ProbeType::ThreeD;
  at_switch.mono_direction_deg = keys.get(KeyId::ProbeDirection, at_switch.mono_direction_deg);
  at_switch.pre_travel_mm = keys.get(KeyId::ProbePreTravel, at_switch.pre_travel_mm);
  at_switch.seats = keys.get(KeyId::ProbeSeats, std::string("even")) == "tripod"
                        ? probe::Seats::Tripod
                        : probe::Seats::Even;
  at_switch.weak_direction_deg = keys.get(KeyId::ProbeWeakDirection, at_switch.weak_direction_deg);
  at_switch.trigger_force_n = keys.get(KeyId::ProbeForce, at_switch.trigger_force_n);
  at_switch.axial_force_n = keys.get(KeyId::ProbeAxialForce, at_switch.axial_force_n);
  at_switch.stem_stiffness_n_mm = keys.get(KeyId::ProbeStiffness, at_switch.stem_stiffness_n_mm);
  return at_switch;
}

probe::ProbeState probe_state_from(const TableKeys& keys) {
  const std::string given = keys.get(KeyId::ProbeStateKind, std::string("ready"));
  const auto* const row = std::ranges::find(probe::kProbeStateNames, std::string_view(given),
                                            &probe::ProbeStateName::name);
  G31_EXPECTS(row != probe::kProbeStateNames.end());
  return row->state;
}

probe::StylusBall ball_from(const SheetTable& table, double usual_diameter_mm) {
  const TableKeys keys(table);
  return {point_from(keys, KeyId::ProbeBallAt), keys.get(KeyId::ProbeBallSize, usual_diameter_mm)};
}

}  // namespace

std::optional<probe::ProbeSetup> probe_from(const Sheet& sheet) {
  const auto table = sheet.tables.find({SectionId::Probe, ""});
  if (table == sheet.tables.end()) {
    return std::nullopt;
  }
  const TableKeys keys(table->second);
  probe::ProbeSetup probe = ball_and_signal_from(keys);
  probe.at_switch = switch_from(keys);
  probe.state = probe_state_from(keys);
  if (const auto balls = sheet.lists.find(SectionId::ProbeBall); balls != sheet.lists.end()) {
    for (const SheetTable& ball : balls->second) {
      probe.further_balls.push_back(ball_from(ball, probe.ball_diameter_mm));
    }
  }
  return probe;
}

}  // namespace g31::setup
