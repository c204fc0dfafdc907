#include "tools/setup/fill_probe.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "machine/base/contract.h"
#include "machine/units/turn_from_z.h"
#include "tools/setup/program_switch.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

constexpr double kUsualStemToBall = 0.6;  // diameters
constexpr double kUsualBodyLengthMm = 50.0;
constexpr double kUsualInput = 1.0;
constexpr double kUsualBodyDiameterMm = 40.0;

/// @param p_T_ball  mm, from the tool reference point
void put_in_turret(probe::ProbeSetup& probe, const Point& p_T_ball) {
  probe.in_turret = true;
  probe.eccentricity_mm = {p_T_ball.x(), p_T_ball.y()};
  probe.length_mm = -p_T_ball.z();
  Eigen::Index along = 0;
  if (p_T_ball.cwiseAbs().maxCoeff(&along) > 0.0) {
    Point to_holder = Point::Zero();
    to_holder[along] = -p_T_ball[along];
    probe.turn_of_stylus = turn_from_z(to_holder);
  }
}

probe::ProbeSetup plain_probe_from(const TableKeys& keys) {
  probe::ProbeSetup probe;
  probe.ball_diameter_mm = keys.get(KeyId::ProbeBallDiameter, probe.ball_diameter_mm);
  probe.length_mm = keys.get(KeyId::ProbeLength, probe.length_mm);
  const std::vector<double> eccentricity =
      keys.get(KeyId::ProbeEccentricity, std::vector<double>{0.0, 0.0});
  probe.eccentricity_mm = {eccentricity.at(0), eccentricity.at(1)};
  if (keys.find(KeyId::ProbeAt) != nullptr) {
    put_in_turret(probe, point_from(keys, KeyId::ProbeAt));
  }
  probe.deflection_limit_mm = keys.get(KeyId::ProbeDeflection, probe.deflection_limit_mm);
  probe.trigger_delay_s = keys.get(KeyId::ProbeTriggerDelay, probe.trigger_delay_s);
  if (const Entry* const feed = keys.find(KeyId::ProbeCalibratedFeed)) {
    probe.calibrated_feed_mm_min = number_of(*feed);
  }
  probe.repeatability_mm = keys.get(KeyId::ProbeRepeatability, probe.repeatability_mm);
  probe.input = static_cast<int>(keys.get(KeyId::ProbeInput, kUsualInput));
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

/// @pre the check let it through
std::optional<probe::ProgramSwitch> switch_from(const TableKeys& keys, KeyId id) {
  const Entry* const entry = keys.find(id);
  return entry != nullptr ? program_switch(std::get<std::string>(entry->value)) : std::nullopt;
}

probe::SwitchingSetup switching_from(const TableKeys& keys) {
  probe::SwitchingSetup switching;
  if (const Entry* const tool = keys.find(KeyId::ProbeTool)) {
    switching.tool = static_cast<int>(number_of(*tool));
  }
  switching.on = switch_from(keys, KeyId::ProbeOn);
  switching.off = switch_from(keys, KeyId::ProbeOff);
  switching.start_up_s = keys.get(KeyId::ProbeStartUp, 0.0);
  switching.may_turn = keys.get(KeyId::ProbeMayTurn, 0.0) != 0.0;
  return switching;
}

probe::ProbeState probe_state_from(const TableKeys& keys) {
  const std::string given = keys.get(KeyId::ProbeStateKind, std::string("ready"));
  const auto* const row = std::ranges::find(probe::kProbeStateNames, std::string_view(given),
                                            &probe::ProbeStateName::name);
  G31_EXPECTS(row != probe::kProbeStateNames.end());
  return row->state;
}

/// Stem and bodies, from the ball upwards.
void fill_sections(probe::ProbeSetup& probe, const TableKeys& keys,
                   std::span<const SheetTable> bodies) {
  const Point p_S_ball(probe.eccentricity_mm[0], probe.eccentricity_mm[1], -probe.length_mm);
  double left = -(probe.turn_of_stylus.conjugate() * p_S_ball).z();
  for (const SheetTable& body : bodies) {
    left -= length_of_body(body);
  }
  const double usual_length = std::max(left, 0.5 * probe.ball_diameter_mm);
  const double stem_length = keys.get(KeyId::ProbeStemLength, usual_length);
  const double stem_radius =
      0.5 * keys.get(KeyId::ProbeStemDiameter, kUsualStemToBall * probe.ball_diameter_mm);
  if (stem_radius > 0.0) {
    probe.stem.push_back({"stem", 0.0, stem_length, stem_radius, stem_radius, 0.0});
    probe.stem.back().turn_S = probe.turn_of_stylus;
  }
  double z = stem_length;
  for (const SheetTable& body : bodies) {
    probe.bodies.push_back(body_from(z, body, "probe body"));
    probe.bodies.back().turn_S = probe.turn_of_stylus;
    z += length_of_body(body);
  }
}

probe::StylusBall ball_from(const SheetTable& table, double usual_diameter_mm) {
  const TableKeys keys(table);
  return {point_from(keys, KeyId::ProbeBallAt), keys.get(KeyId::ProbeBallSize, usual_diameter_mm)};
}

/// What holds a further ball: level from the axis of the stem, below the main ball straight from
/// that.
std::optional<probe::ProbeSection> arm_from(const SheetTable& table,
                                            const probe::StylusBall& ball) {
  const double usual_diameter = kUsualStemToBall * ball.diameter_mm;
  const double radius = 0.5 * TableKeys(table).get(KeyId::ProbeBallArm, usual_diameter);
  const Point p_S_root(0.0, 0.0, std::max(0.0, ball.p_S_from_main.z()));
  const Point along = ball.p_S_from_main - p_S_root;
  if (radius == 0.0 || along.isZero(0.0)) {
    return std::nullopt;
  }
  probe::ProbeSection arm{"stylus arm", 0.0, along.norm(), radius, radius, 0.0};
  arm.p_S = p_S_root;
  arm.turn_S = turn_from_z(along);
  return arm;
}

}  // namespace

double length_of_body(const SheetTable& table) {
  return TableKeys(table).get(KeyId::ProbeBodyLength, kUsualBodyLengthMm);
}

probe::ProbeSection body_from(double z_bottom, const SheetTable& table, const char* usual_name) {
  const TableKeys keys(table);
  const double z_top = z_bottom + length_of_body(table);
  const double radius = 0.5 * keys.get(KeyId::ProbeBodyDiameter, kUsualBodyDiameterMm);
  const double radius_top = 0.5 * keys.get(KeyId::ProbeBodyTop, 2.0 * radius);
  const double most = std::min({radius, radius_top, 0.5 * (z_top - z_bottom)});
  const double rounding = std::min(keys.get(KeyId::ProbeBodyRounding, 0.0), most);
  return {keys.get(KeyId::ProbeBodyName, std::string(usual_name)),
          z_bottom + rounding,
          z_top - rounding,
          radius - rounding,
          radius_top - rounding,
          rounding};
}

probe::ProbeSetup probe_from(const Sheet& sheet, const SheetTable& table) {
  const TableKeys keys(table);
  probe::ProbeSetup probe = plain_probe_from(keys);
  probe.at_switch = switch_from(keys);
  probe.switching = switching_from(keys);
  probe.state = probe_state_from(keys);
  for (const SheetTable& ball : list_of(sheet, SectionId::ProbeBall)) {
    probe.further_balls.push_back(ball_from(ball, probe.ball_diameter_mm));
    if (auto arm = arm_from(ball, probe.further_balls.back())) {
      probe.stem.push_back(*std::move(arm));
    }
  }
  fill_sections(probe, keys, list_of(sheet, SectionId::ProbeBody));
  return probe;
}

std::optional<probe::SecondProbeSetup> second_probe_from(
    const Sheet& sheet, const std::optional<probe::ProbeSetup>& first, ErrorList& errors) {
  const auto table = sheet.tables.find({SectionId::ProbeSecond, ""});
  if (table == sheet.tables.end()) {
    return std::nullopt;
  }
  const TableKeys keys(table->second);
  const auto unfit = [&](const char* why, const char* instead) {
    errors.add(SetupErrorId::SecondProbeUnfit, table->second.where, {why}, instead);
    return std::optional<probe::SecondProbeSetup>();
  };
  if (!first || first->in_turret) {
    return unfit("needs a [probe] in the first spindle",
                 "for example: [probe] ball_diameter = 6.0");
  }
  if (keys.find(KeyId::SecondAt) == nullptr) {
    return unfit("needs its place", "for example: at = [200.0, 0.0, 0.0]");
  }
  probe::SecondProbeSetup second{*first, point_from(keys, KeyId::SecondAt)};
  const double other_input = first->input == 1 ? 2.0 : 1.0;
  second.probe.input = static_cast<int>(keys.get(KeyId::SecondInput, other_input));
  if (second.probe.input == first->input) {
    return unfit("has the input of [probe]", "for example: input = 2");
  }
  second.probe.ball_diameter_mm = keys.get(KeyId::SecondBall, first->ball_diameter_mm);
  second.probe.length_mm = keys.get(KeyId::SecondLength, first->length_mm);
  const auto eccentricity = keys.get(KeyId::SecondEccentricity, std::vector<double>{0.0, 0.0});
  second.probe.eccentricity_mm = {eccentricity.at(0), eccentricity.at(1)};
  second.probe.trigger_delay_s = keys.get(KeyId::SecondDelay, first->trigger_delay_s);
  return second;
}

std::vector<machine::InputWire> wires_of(const SheetTable& table, int measuring_input) {
  const TableKeys keys(table);
  std::vector<machine::InputWire> wires;
  using Source = machine::InputWire::Source;
  for (const auto& [id, source] : {std::pair(KeyId::ProbeReadyInput, Source::Ready),
                                   std::pair(KeyId::ProbeSignalInput, Source::Signal)}) {
    if (const Entry* const number = keys.find(id)) {
      wires.push_back({static_cast<int>(number_of(*number)), source, measuring_input});
    }
  }
  return wires;
}

}  // namespace g31::setup
