#include "probe/sensor/scripted_signals.h"

#include <optional>
#include <variant>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/asked.h"

namespace g31::probe::scripted_signals_test {
namespace {

AxisPositions xyz(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() = Point(x, y, z);
  return q;
}

TEST(ScriptedSignals, RisesWhereTheAxisReachesItsCoordinate) {
  enum class Answer { None, OnAtStart, Rises };
  struct Case {
    const char* name;
    SkipSignal signal;
    AxisPositions from;
    AxisPositions to;
    Answer answer;
    double fraction;
  };
  const Case kCases[] = {
      {"on the way", {0, 25.0}, xyz(0, 0, 0), xyz(100, 0, 0), Answer::Rises, 0.25},
      {"on the way, backwards", {2, -30.0}, xyz(0, 0, -10), xyz(0, 0, -50), Answer::Rises, 0.5},
      {"on a slanting way", {1, 5.0}, xyz(0, 0, 0), xyz(100, 20, 3), Answer::Rises, 0.25},
      {"at the very end", {0, 100.0}, xyz(0, 0, 0), xyz(100, 0, 0), Answer::Rises, 1.0},
      {"behind the end", {0, 100.001}, xyz(0, 0, 0), xyz(100, 0, 0), Answer::None, 0.0},
      {"at the start", {0, 0.0}, xyz(0, 0, 0), xyz(100, 0, 0), Answer::OnAtStart, 0.0},
      {"start already beyond", {0, 10.0}, xyz(20, 0, 0), xyz(100, 0, 0), Answer::OnAtStart, 0.0},
      {"start already beyond, backwards",
       {0, 30.0},
       xyz(20, 0, 0),
       xyz(-5, 0, 0),
       Answer::OnAtStart,
       0.0},
      {"the axis does not move", {1, 0.0}, xyz(0, 0, 0), xyz(100, 0, 0), Answer::None, 0.0},
      {"no coordinate", {0, std::nullopt}, xyz(0, 0, 0), xyz(100, 0, 0), Answer::None, 0.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    ScriptedSignals signals({c.signal});
    const auto trigger = testing::touch_on(signals, {c.from, c.to});
    ASSERT_EQ(trigger.has_value(), c.answer != Answer::None);
    if (trigger) {
      EXPECT_EQ(trigger->on_at_start, c.answer == Answer::OnAtStart);
      EXPECT_EQ(trigger->fraction, c.fraction);
      EXPECT_EQ(trigger->delay_s, 0.0);
      EXPECT_FALSE(trigger->contact.has_value());
    }
    EXPECT_FALSE(testing::collision_on(signals, {c.from, c.to}).has_value());
  }
}

TEST(ScriptedSignals, TakesOneSignalAMoveInOrderAndThenNoMore) {
  ScriptedSignals signals({{0, 1.0}, {1, 1.0}, {0, std::nullopt}, {0, 4.0}});
  const machine::Sweep sweep{xyz(0, 0, 0), xyz(10, 0, 0)};
  EXPECT_EQ(testing::touch_on(signals, sweep)->fraction, 0.1);
  EXPECT_FALSE(testing::touch_on(signals, sweep).has_value())
      << "used up by a move of another axis";
  EXPECT_FALSE(testing::touch_on(signals, sweep).has_value());
  EXPECT_EQ(testing::touch_on(signals, sweep)->fraction, 0.4);
  EXPECT_FALSE(testing::touch_on(signals, sweep).has_value());
}

// A table A that carries a table C, the head 150 mm above its own line; lag, where it is asked for.
machine::MachineSetup five_axes(double servo_gain) {
  machine::MachineSetup setup;
  setup.chain.table_side = "CA";
  setup.chain.tool_side = "XYZ";
  setup.chain.rotary[0].p_M_centre = Point(0.0, 30.0, -150.0);
  setup.chain.rotary[2].p_M_centre = Point(40.0, 20.0, 0.0);
  for (machine::AxisSetup& axis : setup.axes) {
    axis.present = true;
    axis.servo_gain = servo_gain;
  }
  return setup;
}

TEST(ScriptedSignals, RiseByTheAxesHoweverTheTablesAreTurned) {
  struct Case {
    const char* name;
    AxisPositions from;
    AxisPositions to;
    SkipSignal signal;
  };
  const auto at = [](double x, double y, double z, double a, double c) {
    AxisPositions q = xyz(x, y, z);
    q[3] = a;
    q[5] = c;
    return q;
  };
  const Case kCases[] = {
      {"X on a turned table", at(0, 5, 6, 30, 70), at(100, 5, 6, 30, 70), {0, 37.5}},
      {"backwards", at(100, 5, 6, -90, 180), at(-20, 5, 6, -90, 180), {0, -3.25}},
      {"Y with X and C", at(0, 0, 0, 0, 0), at(10, 50, 0, 0, 170), {1, 20.0}},
      {"C alone", at(70, 5, 6, 0, 10), at(70, 5, 6, 0, 130), {5, 45.0}},
      {"C alone, the tip on its line", at(40, 20, 6, 0, 10), at(40, 20, 6, 0, 130), {5, 45.0}},
      {"A alone, on a turned C", at(70, 5, 6, -40, 33), at(70, 5, 6, 60, 33), {3, 12.25}},
      {"C for more than a turn", at(70, 5, 6, 20, -30), at(70, 5, 6, 20, 700), {5, 512.5}},
  };
  for (const double servo_gain : {0.0, 1.5}) {
    for (const Case& c : kCases) {
      SCOPED_TRACE(fmt::format("{}, gain {}", c.name, servo_gain));
      ScriptedSignals signals({c.signal});
      machine::MachineSetup setup = five_axes(servo_gain);
      setup.stopping = machine::Stopping::Ideal;
      machine::MachiningCentre machine(setup, &signals);
      ASSERT_TRUE(machine.move(machine::LinearMove{c.from}));
      machine.come_to_rest();
      EXPECT_FALSE(machine.skip_signal(1));
      machine::LinearMove way{c.to};
      way.feed_mm_min = 500.0;
      const auto outcome = machine.move_until_skip(way);
      ASSERT_TRUE(outcome);
      const auto* const touched = std::get_if<machine::Touched>(&outcome.value());
      ASSERT_NE(touched, nullptr);
      EXPECT_NEAR(touched->q_M_latched[c.signal.axis], *c.signal.at, 1e-9);
      EXPECT_TRUE(machine.skip_signal(1));
      ASSERT_TRUE(machine.move(machine::LinearMove{c.from}));
      EXPECT_FALSE(machine.skip_signal(1));
    }
  }
}

TEST(ScriptedSignals, OfAnAxisThatEndsBeforeItOrStartsBeyondItDoNotRiseOnATurnedTable) {
  const auto outcome_of = [](double c_at) {
    ScriptedSignals signals({{5, c_at}});
    machine::MachiningCentre machine(five_axes(0.0), &signals);
    AxisPositions q = AxisPositions::Zero();
    q[5] = 90.0;
    machine::LinearMove way{q};
    way.feed_mm_min = 500.0;
    return machine.move_until_skip(way).value();
  };
  EXPECT_TRUE(std::holds_alternative<machine::NoTouch>(outcome_of(90.001)));
  EXPECT_TRUE(std::holds_alternative<machine::NoEdge>(outcome_of(-0.001)));
  EXPECT_TRUE(std::holds_alternative<machine::Touched>(outcome_of(89.999)));
}

}  // namespace
}  // namespace g31::probe::scripted_signals_test
