#include "probe/sensor/scripted_signals.h"

#include <optional>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace g31::probe::scripted_signals_test
