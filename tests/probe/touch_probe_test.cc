#include "probe/sensor/touch_probe.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::touch_probe_test {
namespace {

using machine::Sweep;

/// The ring gauge of 39.996 mm with its top at (250, -180, -300).
const Point kRingAt(250.0, -180.0, -300.0);

parts::Mesh ring_mesh(const Point& rotate_deg) {
  parts::PartSetup setup;
  setup.name = "ring";
  setup.shape = "ring";
  return parts::placed_mesh(parts::make_artefact(setup).value(), {kRingAt, rotate_deg});
}

ProbeSetup straight_probe() {
  ProbeSetup setup;
  setup.ball_diameter_mm = 6.0;
  setup.length_mm = 120.0;
  return setup;
}

using testing::at;

/// The gauge point over the ring's axis, ball centre 10 mm deep in the bore.
Point spindle_in_bore(const ProbeSetup& setup) {
  return kRingAt + Point(0.0, 0.0, setup.length_mm - 10.0);
}

constexpr double kFreeTravelMm = 39.996 / 2 - 3.0;

TEST(TouchProbe, ReadsTheNominalBoreAlongTheAxes) {
  const ProbeSetup setup = straight_probe();
  TouchProbe probe(setup, {{"ring", ring_mesh(Point::Zero())}}, 0);
  const Point centre = spindle_in_bore(setup);
  for (const Point& direction :
       {Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0)}) {
    const auto trigger = testing::touch_on(probe, {at(centre), at(centre + 20.0 * direction)});
    ASSERT_TRUE(trigger.has_value());
    EXPECT_FALSE(trigger->on_at_start);
    EXPECT_NEAR(20.0 * trigger->fraction, kFreeTravelMm, 1e-12);
    ASSERT_TRUE(trigger->contact.has_value());
    EXPECT_EQ(trigger->contact->part, "ring");
    EXPECT_NEAR((trigger->contact->n_M + direction).norm(), 0.0, 1e-14);
    const Point expected = kRingAt + Point(0, 0, -10) + 19.998 * direction;
    EXPECT_NEAR((trigger->contact->p_M_point - expected).norm(), 0.0, 1e-12);
  }
}

TEST(TouchProbe, ReadsEveryDirectionWithinATenthOfAMicrometre) {
  const ProbeSetup setup = straight_probe();
  for (const double tilt : {0.0, 90.0, 37.0}) {
    TouchProbe probe(setup, {{"ring", ring_mesh({0.0, 0.0, tilt})}}, 0);
    const Point centre = spindle_in_bore(setup);
    double worst = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 5000.0;
      const Point direction(std::cos(angle), std::sin(angle), 0.0);
      const auto trigger = testing::touch_on(probe, {at(centre), at(centre + 20.0 * direction)});
      ASSERT_TRUE(trigger.has_value());
      const double diameter_error = 2.0 * (20.0 * trigger->fraction - kFreeTravelMm);
      EXPECT_GE(diameter_error, -1e-11) << "facets are tangent: a bore never reads too small";
      worst = std::max(worst, diameter_error);
    }
    EXPECT_LE(worst, 1e-4);
    EXPECT_GE(worst, 1e-6) << "5000 directions should have met corners of facets";
  }
}

TEST(TouchProbe, HoldsTheBallWhereLengthAndEccentricityPutIt) {
  ProbeSetup setup = straight_probe();
  setup.eccentricity_mm = {0.3, -0.2};
  setup.trigger_delay_s = 0.004;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  const auto trigger = testing::touch_on(probe, {at({5, 5, 150}), at({5, 5, 120})});
  ASSERT_TRUE(trigger.has_value());
  EXPECT_NEAR(150.0 - 30.0 * trigger->fraction, 120.0 + 10.0 + 3.0, 1e-12);
  EXPECT_NEAR((trigger->contact->p_M_point - Point(5.3, 4.8, 10.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(trigger->delay_s, 0.004);
}

TEST(TouchProbe, MeetsTheFirstOfSeveralParts) {
  const parts::Mesh block = testing::box_mesh({10, 10, 10});
  const auto moved = [&](double x) {
    return parts::placed_mesh(block, {Point(x, 0, 0), Point::Zero()});
  };
  ProbeSetup setup = straight_probe();
  TouchProbe probe(setup, {{"far", moved(100)}, {"near", moved(50)}, {"farther", moved(150)}}, 0);
  const Point start(0, 5, 5 + setup.length_mm);
  const Sweep sweep{at(start), at(start + Point(200, 0, 0))};
  EXPECT_EQ(testing::touch_on(probe, sweep)->contact->part, "near");
  EXPECT_NEAR(200.0 * testing::touch_on(probe, sweep)->fraction, 47.0, 1e-12);
  EXPECT_EQ(testing::collision_on(probe, sweep)->what, "stylus ball touches near");
}

TEST(TouchProbe, SaysNothingOnAFreeWayAndForRotaryAxesAlone) {
  ProbeSetup setup = straight_probe();
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  const Sweep free{at({0, 0, 300}), at({0, 50, 300})};
  EXPECT_FALSE(testing::touch_on(probe, free).has_value());
  EXPECT_FALSE(testing::collision_on(probe, free).has_value());
  AxisPositions turned = at({0, 0, 300});
  turned[5] = 90.0;
  EXPECT_FALSE(testing::touch_on(probe, {at({0, 0, 300}), turned}).has_value());
  TouchProbe nothing(setup, std::vector<ProbedPart>{}, 0);
  EXPECT_FALSE(testing::touch_on(nothing, free).has_value());
}

TEST(TouchProbe, AMoveThatListensToAnotherInputHearsNothing) {
  ProbeSetup setup = straight_probe();
  setup.input = 2;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  const machine::Waypoint down[] = {{0.0, at({5, 5, 150})}, {1.0, at({5, 5, 120})}};
  const machine::Waypoint up[] = {down[1], {1.0, at({5, 5, 150})}};
  for (const machine::SignalEdge edge :
       {machine::SignalEdge::Rising, machine::SignalEdge::Falling}) {
    const machine::Way way(edge == machine::SignalEdge::Rising ? down : up);
    EXPECT_FALSE(probe.first_signal(way, {1, edge}));
    EXPECT_TRUE(probe.first_signal(way, {2, edge}));
    EXPECT_TRUE(probe.first_signal(way, {machine::kAnyInput, edge}));
  }
  EXPECT_FALSE(probe.signals_at({0.0, at({5, 5, 120})}, {1}));
  EXPECT_TRUE(probe.signals_at({0.0, at({5, 5, 120})}, {2}));
}

TEST(TouchProbe, FindsTheSignalOnWhenAMoveBeginsInThePart) {
  const ProbeSetup setup = straight_probe();
  TouchProbe probe(setup, {{"ring", ring_mesh(Point::Zero())}}, 0);
  const Point deep = spindle_in_bore(setup) + Point(kFreeTravelMm + 0.05, 0, 0);
  for (const Point& to : {Point(deep + Point(1, 0, 0)), Point(deep - Point(1, 0, 0))}) {
    const auto trigger = testing::touch_on(probe, {at(deep), at(to)});
    ASSERT_TRUE(trigger.has_value());
    EXPECT_TRUE(trigger->on_at_start);
    EXPECT_EQ(trigger->fraction, 0.0);
    EXPECT_EQ(trigger->contact->part, "ring");
  }
}

TEST(TouchProbe, CollidesInAnOrdinaryMoveButLeavesAContactFreely) {
  const ProbeSetup setup = straight_probe();
  TouchProbe probe(setup, {{"ring", ring_mesh(Point::Zero())}}, 0);
  const Point centre = spindle_in_bore(setup);
  struct Case {
    const char* name;
    Point from;
    Point to;
    std::optional<double> fraction;
  };
  const double touch = kFreeTravelMm;
  const Case kCases[] = {
      {"into the bore from above", centre + Point(0, 0, 50), centre, std::nullopt},
      {"through the wall", centre, centre + Point(100, 0, 0), touch / 100},
      {"back from a touch", centre + Point(touch, 0, 0), centre, std::nullopt},
      {"back from 0.2 mm of overtravel", centre + Point(touch + 0.2, 0, 0), centre, std::nullopt},
      {"across from one wall to the other", centre + Point(touch + 0.2, 0, 0),
       centre - Point(touch + 0.2, 0, 0), (2 * touch + 0.2) / (2 * touch + 0.4)},
      {"out at 45 degrees", centre + Point(0, touch + 0.05, 0), centre + Point(0, 0, touch),
       std::nullopt},
      {"deeper into the wall", centre + Point(touch + 0.2, 0, 0), centre + Point(touch + 1, 0, 0),
       0.0},
      {"onto the top face beside the bore", centre + Point(30, 0, 50), centre + Point(30, 0, 0),
       (60.0 - 3.0 - 20.0 + 0.0) / 50.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto obstacle = testing::collision_on(probe, {at(c.from), at(c.to)});
    ASSERT_EQ(obstacle.has_value(), c.fraction.has_value());
    if (obstacle) {
      EXPECT_EQ(obstacle->what, "stylus ball touches ring");
      EXPECT_NEAR(obstacle->fraction, *c.fraction, 1e-8);
    }
  }
}

TEST(TouchProbe, CollidesOnAnArcWhereTheBallMeetsThePart) {
  const ProbeSetup setup = straight_probe();
  const parts::Mesh block = testing::box_mesh({10, 10, 10});
  TouchProbe probe(
      setup,
      {{"far", parts::placed_mesh(block, {Point(-40, 0, 0), Point::Zero()})}, {"near", block}}, 0);
  // A circle of 30 mm in the plane Z5 around (5, 5 + 30 + gap): its lowest point is over the block.
  const auto arc = [&](double gap) {
    return machine::CurvedWay{
        [&setup, gap](double fraction) {
          const double angle = 2.0 * std::numbers::pi * fraction;
          return at(Point(5 + 30 * std::sin(angle), 13 + gap + 30 + 30 * std::cos(angle),
                          5 + setup.length_mm));
        },
        4.0 * std::numbers::pi * std::numbers::pi * 30.0, 1};
  };
  EXPECT_FALSE(testing::collision_on(probe, arc(1e-6)).has_value());
  const auto obstacle = testing::collision_on(probe, arc(-0.01));
  ASSERT_TRUE(obstacle.has_value());
  EXPECT_EQ(obstacle->what, "stylus ball touches near");
  const double angle = std::numbers::pi - std::acos(1.0 - 0.01 / 30.0);
  EXPECT_NEAR(obstacle->fraction, angle / (2.0 * std::numbers::pi), 1e-8);
  EXPECT_NEAR((obstacle->contact.n_M - Point::UnitY()).norm(), 0.0, 1e-6);
}

/// 4000 touches of a block with a standard deviation of 1 um.
std::vector<double> scattered(std::uint64_t seed, double repeatability_mm) {
  ProbeSetup setup = straight_probe();
  setup.repeatability_mm = repeatability_mm;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, seed);
  std::vector<double> errors;
  for (int i = 0; i < 4000; ++i) {
    const auto trigger = testing::touch_on(probe, {at({5, 5, 143}), at({5, 5, 123})});
    errors.push_back(20.0 * trigger->fraction - 10.0);
    // What is scattered is the signal; the touch itself is where it is.
    EXPECT_NEAR((trigger->contact->p_M_point - Point(5, 5, 10)).norm(), 0.0, 1e-12);
  }
  return errors;
}

TEST(TouchProbe, ScattersAsItsRepeatabilitySays) {
  const std::vector<double> errors = scattered(5, 0.001);
  double mean = 0.0;
  double square = 0.0;
  for (const double e : errors) {
    mean += e / 4000.0;
    square += e * e / 4000.0;
  }
  EXPECT_NEAR(mean, 0.0, 5 * 0.001 / std::sqrt(4000.0));
  EXPECT_NEAR(std::sqrt(square), 0.001, 5 * 0.001 / std::sqrt(8000.0));
  EXPECT_EQ(scattered(5, 0.001), errors) << "the same seed, the same touches";
  EXPECT_NE(scattered(6, 0.001), errors);
}

TEST(TouchProbe, ScatterStaysInTheMove) {
  bool at_start = false;
  bool at_end = false;
  for (const double e : scattered(5, 50.0)) {
    EXPECT_GE(e, -10.0);
    EXPECT_LE(e, 10.0);
    at_start |= e == -10.0;
    at_end |= e == 10.0;
  }
  EXPECT_TRUE(at_start && at_end);
}

}  // namespace
}  // namespace g31::probe::touch_probe_test
