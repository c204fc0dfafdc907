// Several sets of bodies in one world, tools that come and go, and what their meeting means.

#include "probe/sensor/world.h"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::world_test {
namespace {

using machine::Rotation;
using machine::SensorState;
using machine::SpindleTurn;
using machine::ToolChange;

AxisPositions at(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() = Point(x, y, z);
  return q;
}

/// The face z = 10 of a block; a probe of this length touches it at its length + 13.
const std::vector<ProbedPart> kBlock = {{"block", testing::box_mesh({10, 10, 10})}};

ProbeSetup probe_of(int tool, int input, double length_mm = 120.0) {
  ProbeSetup setup;
  setup.switching.tool = tool;
  setup.input = input;
  setup.length_mm = length_mm;
  return setup;
}

constexpr double kRadius = 3.0;
constexpr SensorState kReady{.ball_radius_mm = kRadius};
constexpr SensorState kNotInPlace{.in_place = false, .ball_radius_mm = kRadius};
constexpr SensorState kSwitchedOff{.switched_on = false, .ball_radius_mm = kRadius};
constexpr SensorState kTurning{.stands = false, .ball_radius_mm = kRadius};

machine::Sweep down() {
  return {at(5, 5, 200), at(5, 5, 80)};
}

TEST(Encounters, SayWhoMayTouchWhom) {
  using enum Role;
  const std::vector<Role> roles = {Part, SensingTip, SensingTarget, Cutter, Rigid};
  const auto expected = [](Role a, Role b, machine::Travel travel) {
    const auto is = [&](Role x, Role y) { return (a == x && b == y) || (a == y && b == x); };
    const bool skips = travel == machine::Travel::Skip;
    if (is(SensingTip, Part) || is(Cutter, SensingTarget)) {
      return skips ? Encounter::Signal : Encounter::Obstacle;
    }
    return is(Cutter, Part) ? Encounter::Free : Encounter::Obstacle;
  };
  for (const Role a : roles) {
    for (const Role b : roles) {
      for (const auto travel :
           {machine::Travel::Rapid, machine::Travel::Feed, machine::Travel::Skip}) {
        EXPECT_EQ(encounter_of(a, b, travel), expected(a, b, travel))
            << static_cast<int>(a) << ' ' << static_cast<int>(b);
      }
    }
  }
}

TEST(TouchProbe, IsMadeOfBodies) {
  ProbeSetup setup = probe_of(1, 1);
  setup.further_balls = {{Point(30, 0, 10), 4.0}};
  setup.stem = {{"stem", 0.0, 50.0, 1.5, 1.5}};
  setup.bodies = {{"holder", 50.0, 90.0, 20.0, 20.0}};
  const std::vector<ToolBody> bodies = bodies_of(setup);
  ASSERT_EQ(bodies.size(), 4U);
  for (const ToolBody& body : bodies) {
    EXPECT_EQ(body.mount, Mount::Spindle);
  }
  EXPECT_EQ(bodies[0].role, Role::SensingTip);
  EXPECT_EQ(std::get<Ball>(bodies[0].shape).p_S_centre, Point(0, 0, -120));
  EXPECT_EQ(std::get<Ball>(bodies[1].shape).p_S_centre, Point(30, 0, -110));
  EXPECT_EQ(std::get<Ball>(bodies[1].shape).radius_mm, 2.0);
  EXPECT_EQ(bodies[2].role, Role::Rigid);
  EXPECT_TRUE(bodies[2].gives_way);
  EXPECT_FALSE(bodies[3].gives_way);
}

TEST(TouchProbe, SensesPartsButMayNotTouchAClamp) {
  std::vector<ProbedPart> parts = kBlock;
  parts.push_back({"clamp", testing::moved_by(testing::box_mesh({10, 10, 10}), {50, 0, 0})});
  parts.back().role = Role::Rigid;
  TouchProbe probe(ProbeSetup(), parts, 0);
  EXPECT_TRUE(testing::touch_on(probe, down()));
  const machine::Sweep onto_clamp{at(55, 5, 200), at(55, 5, 131)};
  EXPECT_FALSE(testing::touch_on(probe, onto_clamp));
  for (const auto& obstacle :
       {testing::damage_on(probe, onto_clamp), testing::collision_on(probe, onto_clamp)}) {
    ASSERT_TRUE(obstacle);
    EXPECT_EQ(obstacle->what, "stylus ball touches clamp");
    EXPECT_NEAR(obstacle->fraction * 69.0, 67.0, 1e-9);
  }
}

TEST(TouchProbe, KeepsSilentWhileAnotherToolIsInTheSpindle) {
  TouchProbe probe(probe_of(1, 1), kBlock, 0);
  EXPECT_EQ(probe.sensor_state(1), kReady);
  EXPECT_EQ(probe.sensor_state(2), std::nullopt);
  probe.take(ToolChange{{5, 100.0, 8.0}});
  EXPECT_EQ(probe.sensor_state(1), kNotInPlace);
  EXPECT_FALSE(testing::touch_on(probe, down()));
  EXPECT_FALSE(testing::collision_on(probe, down()));
  EXPECT_FALSE(testing::damage_on(probe, down()));
  EXPECT_FALSE(probe.signals_at({0.0, at(5, 5, 130)}, {1}));
  const auto up = testing::ends_of({at(5, 5, 130), at(5, 5, 200)});
  EXPECT_TRUE(testing::release_along(probe, up)->on_at_start) << "the line is low already";
  probe.take(ToolChange{{1, 120.0, 3.0}});
  EXPECT_TRUE(testing::touch_on(probe, down()));
  EXPECT_TRUE(testing::collision_on(probe, down()));
  // Another spindle's tools are another matter.
  probe.take(ToolChange{{5, 100.0, 8.0}, 2});
  EXPECT_EQ(probe.sensor_state(1), kReady);
}

TEST(TouchProbe, WithoutANumberItIsThereWhateverToolIsCalled) {
  TouchProbe probe(ProbeSetup(), kBlock, 0);
  probe.take(ToolChange{{5, 100.0, 8.0}});
  probe.take(SpindleTurn{Rotation::Clockwise, 3000.0, {}});
  EXPECT_EQ(probe.sensor_state(1), kReady);
  EXPECT_TRUE(testing::touch_on(probe, down()));
}

TEST(TouchProbe, IsSwitchedByItsCodes) {
  ProbeSetup setup;
  setup.switching.on = ProgramSwitch{ProgramSwitch::Kind::Code, 80};
  setup.switching.off = ProgramSwitch{ProgramSwitch::Kind::Code, 81};
  TouchProbe probe(setup, kBlock, 0);
  EXPECT_EQ(probe.sensor_state(1), kSwitchedOff);
  EXPECT_FALSE(testing::touch_on(probe, down()));
  EXPECT_TRUE(testing::damage_on(probe, down())) << "it breaks all the same";
  probe.take(machine::AuxiliaryCode{80});
  EXPECT_EQ(probe.sensor_state(1), kReady);
  EXPECT_TRUE(testing::touch_on(probe, down()));
  probe.take(machine::AuxiliaryCode{8});
  EXPECT_EQ(probe.sensor_state(1), kReady);
  probe.take(machine::AuxiliaryCode{81});
  EXPECT_EQ(probe.sensor_state(1), kSwitchedOff);
  setup.state = ProbeState::Dead;
  setup.switching.on.reset();
  EXPECT_FALSE(TouchProbe(setup, kBlock, 0).sensor_state(1)->is_ready());
}

TEST(TouchProbe, OneCodeMaySwitchItOnAndOff) {
  ProbeSetup setup;
  setup.switching.on = ProgramSwitch{ProgramSwitch::Kind::Code, 80};
  setup.switching.off = ProgramSwitch{ProgramSwitch::Kind::Code, 80};
  TouchProbe probe(setup, kBlock, 0);
  EXPECT_EQ(probe.sensor_state(1), kSwitchedOff);
  for (const SensorState& state : {kReady, kSwitchedOff, kReady}) {
    probe.take(machine::AuxiliaryCode{80});
    EXPECT_EQ(probe.sensor_state(1), state);
    probe.take(machine::AuxiliaryCode{81});
    EXPECT_EQ(probe.sensor_state(1), state);
  }
}

TEST(TouchProbe, TellsThatItsSpindleTurns) {
  TouchProbe probe(probe_of(1, 1), kBlock, 0);
  probe.take(SpindleTurn{Rotation::Counterclockwise, 500.0, {}, 2});
  EXPECT_EQ(probe.sensor_state(1), kReady);
  probe.take(SpindleTurn{Rotation::Counterclockwise, 500.0, {}});
  EXPECT_EQ(probe.sensor_state(1), kTurning);
  EXPECT_TRUE(testing::touch_on(probe, down())) << "the signal comes all the same";
  probe.take(SpindleTurn{Rotation::Stopped, 0.0, 90.0});
  EXPECT_EQ(probe.sensor_state(1), kReady);
}

TEST(World, HoldsASecondProbe) {
  World::Sets sets;
  sets.push_back(std::make_unique<TouchProbe>(probe_of(1, 1), kBlock, 0));
  sets.push_back(std::make_unique<TouchProbe>(probe_of(11, 2, 100.0), kBlock, 0));
  World world(std::move(sets), Tools::Changing);
  const auto touched_at = [&](int tool, int input) {
    world.take(ToolChange{{tool, 77.0, 8.0}});
    const auto ends = testing::ends_of(down());
    const auto trigger = world.first_signal(machine::Way(ends), {input});
    return trigger ? 200.0 - 120.0 * trigger->fraction : 0.0;
  };
  EXPECT_NEAR(touched_at(1, 1), 133.0, 1e-9);
  EXPECT_NEAR(touched_at(1, machine::kAnyInput), 133.0, 1e-9);
  EXPECT_EQ(touched_at(1, 2), 0.0);
  EXPECT_EQ(world.sensor_state(2), kNotInPlace);
  EXPECT_NEAR(touched_at(11, 2), 113.0, 1e-9);
  EXPECT_NEAR(touched_at(11, machine::kAnyInput), 113.0, 1e-9);
  EXPECT_EQ(world.tool_extent().p_T_tip, Point(0, 0, -100));
  EXPECT_TRUE(world.signals_at({0.0, at(5, 5, 112)}, {2}));
  EXPECT_FALSE(world.signals_at({0.0, at(5, 5, 112)}, {1}));
  EXPECT_EQ(touched_at(5, machine::kAnyInput), 0.0);
  EXPECT_FALSE(testing::collision_on(world, down()));
  EXPECT_EQ(world.tool_extent().p_T_tip, Point(0, 0, -77)) << "as the control believes";
  EXPECT_EQ(world.sensor_state(3), std::nullopt);
}

TEST(World, TheLineOfTheProbeInPlaceFalls) {
  World::Sets sets;
  sets.push_back(std::make_unique<TouchProbe>(probe_of(1, 1), kBlock, 0));
  sets.push_back(std::make_unique<TouchProbe>(probe_of(11, 1, 100.0), kBlock, 0));
  World world(std::move(sets), Tools::Changing);
  const auto up = testing::ends_of({at(5, 5, 112), at(5, 5, 122)});
  world.take(ToolChange{{11, 100.0, 3.0}});
  const auto release = testing::release_along(world, up);
  ASSERT_TRUE(release);
  EXPECT_FALSE(release->on_at_start);
  EXPECT_NEAR(release->fraction, 0.1, 1e-9);
  world.take(ToolChange{{5, 100.0, 3.0}});
  EXPECT_TRUE(testing::release_along(world, up)->on_at_start);
}

/// Where the tip truly is, 100 mm to the side of the axis that turns the head.
TEST(MachiningCentre, TheTipIsThatOfTheToolInTheSpindle) {
  machine::MachineSetup setup;
  setup.axes[4].present = true;
  setup.chain.table_side = "";
  setup.chain.tool_side = "XYZB";
  setup.p_T_tip = Point(0, 0, -120);
  setup.q_M_start[4] = 90.0;
  setup.q_M_start[2] = 200.0;
  setup.stopping = machine::Stopping::Ideal;
  // Turned by 90 degrees the probe points along -X: its ball is at -120, or -100 for the other.
  World::Sets sets;
  const std::vector<ProbedPart> wall = {
      {"wall", testing::moved_by(testing::box_mesh({10, 100, 100}), {-250, -50, 150})}};
  sets.push_back(std::make_unique<TouchProbe>(probe_of(1, 1), wall, 0));
  sets.push_back(std::make_unique<TouchProbe>(probe_of(11, 1, 100.0), wall, 0));
  World world(std::move(sets), Tools::Changing);
  machine::MachiningCentre centre(setup, &world);
  AxisPositions q_M_wall = centre.position();
  q_M_wall[0] = -200.0;
  for (const auto& [tool, length] : {std::pair(1, 120.0), {11, 100.0}}) {
    centre.change_tool({{tool, 55.0, 3.0}});
    const auto outcome =
        centre.move_until_skip(machine::LinearMove{q_M_wall, machine::Traverse::Feed, 600.0});
    const auto* touched = std::get_if<machine::Touched>(&outcome.value());
    ASSERT_NE(touched, nullptr) << tool;
    EXPECT_NEAR(touched->q_M_latched[0], -240.0 + 3.0 + length, 1e-5);
    ASSERT_TRUE(centre.move({setup.q_M_start, machine::Traverse::Feed, 600.0}).ok());
  }
}

TEST(MachiningCentre, ShowsOnItsInputsWhetherTheProbeIsReadyAndTouches) {
  machine::MachineSetup setup;
  using Source = machine::InputWire::Source;
  setup.wires = {{1004, Source::Ready, 1}, {1005, Source::Signal, 1}};
  setup.q_M_start = at(5, 5, 140);
  ProbeSetup probe = probe_of(1, 1);
  probe.switching.on = ProgramSwitch{ProgramSwitch::Kind::Code, 80};
  TouchProbe world(probe, kBlock, 0);
  machine::MachiningCentre centre(setup, &world);
  EXPECT_EQ(centre.digital_input(1000), std::nullopt);
  EXPECT_EQ(centre.digital_input(1004), false);
  centre.auxiliary_code({80});
  EXPECT_EQ(centre.digital_input(1004), true);
  EXPECT_EQ(centre.digital_input(1005), false);
  const auto touch =
      centre.move_until_skip(machine::LinearMove{at(5, 5, 100), machine::Traverse::Feed, 600.0});
  ASSERT_TRUE(touch.ok());
  EXPECT_EQ(centre.digital_input(1005), true);
  centre.change_tool({{2, 10.0, 1.0}});
  EXPECT_EQ(centre.digital_input(1004), false);
  EXPECT_EQ(centre.digital_input(1005), false);
  machine::MachiningCentre empty(setup, nullptr);
  EXPECT_EQ(empty.digital_input(1004), false);
  EXPECT_EQ(empty.sensor_state(1), std::nullopt);
}

}  // namespace
}  // namespace g31::probe::world_test
