#include "probe/sensor/bodies.h"

#include <array>

namespace g31::probe {
namespace {

struct EncounterRow {
  Role role;
  Role other;
  Encounter on_moves;
  Encounter on_skip_moves;
};

constexpr std::array kEncounters = {
#define ENCOUNTER(role, other, on_moves, on_skip_moves) \
  EncounterRow{Role::role, Role::other, Encounter::on_moves, Encounter::on_skip_moves},
#include "probe/sensor/encounters.def"
#undef ENCOUNTER
};

}  // namespace

Encounter encounter_of(Role a, Role b, machine::Travel travel) {
  for (const EncounterRow& row : kEncounters) {
    if ((row.role == a && row.other == b) || (row.role == b && row.other == a)) {
      return travel == machine::Travel::Skip ? row.on_skip_moves : row.on_moves;
    }
  }
  return Encounter::Obstacle;
}

std::vector<ToolBody> bodies_of(const ProbeSetup& setup) {
  const Point p_S_main(setup.eccentricity_mm[0], setup.eccentricity_mm[1], -setup.length_mm);
  std::vector<ToolBody> bodies;
  const auto add_ball = [&](const Point& p_S, double diameter_mm) {
    bodies.push_back({"stylus ball", Role::SensingTip, Ball{p_S, 0.5 * diameter_mm}});
  };
  add_ball(p_S_main, setup.ball_diameter_mm);
  for (const StylusBall& ball : setup.further_balls) {
    add_ball(p_S_main + ball.p_S_from_main, ball.diameter_mm);
  }
  for (const ProbeSection& section : setup.stem) {
    bodies.push_back({section.name, Role::Rigid, section});
    bodies.back().gives_way = true;
  }
  for (const ProbeSection& section : setup.bodies) {
    bodies.push_back({section.name, Role::Rigid, section});
  }
  return bodies;
}

}  // namespace g31::probe
