#include <cmath>

#include <gtest/gtest.h>

#include "machine/errors/axis_play.h"
#include "machine/errors/geometric_errors.h"
#include "machine/sim/machining_centre.h"
#include "machine/sim/true_way.h"
#include "tests/support/scripted_surroundings.h"
#include "tests/support/world_of_pieces.h"

namespace g31::machine::machine_errors_test {
namespace {

using errors::ErrorTable;
using testing::ScriptedSurroundings;

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

LinearMove feed(const AxisPositions& q_M_end) {
  return {q_M_end, Traverse::Feed, 600.0};
}

/// A plane x = at: touched by the true position, wherever the encoders are.
class Wall final : public testing::WorldOfPieces {
 public:
  explicit Wall(int axis, double at) : axis_(axis), at_(at) {}

 private:
  std::optional<SkipTrigger> trigger_on(const Sweep& sweep) override {
    const auto fraction = crossing(sweep.q_M_from, sweep.q_M_to);
    return fraction ? std::optional(SkipTrigger{*fraction, false, 0.0, {}}) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> crossing(const AxisPositions& q_M_from,
                                               const AxisPositions& q_M_to) const {
    const double way = q_M_to[axis_] - q_M_from[axis_];
    const double part = (at_ - q_M_from[axis_]) / way;
    return way != 0.0 && part >= 0.0 && part <= 1.0 ? std::optional(part) : std::nullopt;
  }
  int axis_;
  double at_;
};

AxisPositions latched(MachiningCentre& centre, const AxisPositions& q_M_end) {
  const auto outcome = centre.move_until_skip(feed(q_M_end));
  const auto* touched = outcome ? std::get_if<Touched>(&outcome.value()) : nullptr;
  if (touched == nullptr) {
    ADD_FAILURE() << "no touch";
    return q_M_end;
  }
  return touched->q_M_latched;
}

MachineSetup stops_at_once() {
  MachineSetup setup;
  setup.stopping = Stopping::Ideal;
  return setup;
}

TEST(MachineErrors, WithoutErrorsEveryPositionIsTheIdealOneBitForBit) {
  MachineSetup zero;
  // Keys that are given, but say nothing.
  zero.p_T_tip = Point(0.1, 0.2, -120.0);
  zero.geometric_errors.along[0][3] = ErrorTable({{0.0, 0.0}, {500.0, 0.0}});
  zero.axes[0].play.spike_way = 1.0;
  zero.compensation.along[1][0] = ErrorTable({{0.0, 0.0}, {500.0, 0.0}});
  zero.axes[1].scale_growth.expansion = 11.5;
  zero.axes[2].scale_growth.temperature = 30.0;
  ScriptedSurroundings world({{'X', 1.0 / 3.0, 0.013, false, {}}});
  ScriptedSurroundings plain_world({{'X', 1.0 / 3.0, 0.013, false, {}}});
  MachiningCentre machine(zero, &world);
  MachiningCentre plain(MachineSetup(), &plain_world);
  const auto touched = machine.move_until_skip(feed(axes(0.7, 0.1, 0.3)));
  const auto plainly = plain.move_until_skip(feed(axes(0.7, 0.1, 0.3)));
  EXPECT_EQ(std::get<Touched>(touched.value()).q_M_latched,
            std::get<Touched>(plainly.value()).q_M_latched);
  EXPECT_EQ(machine.position(), plain.position());
  EXPECT_EQ(machine.time_s(), plain.time_s());
  ASSERT_TRUE(machine.move(feed(axes(-0.1, 1.0 / 7.0, 9.0))).ok());
  EXPECT_EQ(world.move_sweeps().back().q_M_to, axes(-0.1, 1.0 / 7.0, 9.0));
  EXPECT_TRUE(TruePosition(zero).is_ideal());
}

/// Different numbers everywhere: table (0, a) to (100, b) for each of the eighteen.
errors::GeometricErrorSetup all_errors() {
  errors::GeometricErrorSetup setup;
  for (int axis = 0; axis < 3; ++axis) {
    for (int way = 0; way < 6; ++way) {
      const double size = way < 3 ? 1e-3 : 1.0;
      const double first = size * (1 + axis + 3 * way);
      const double last = size * (7 - 2 * axis - way);
      setup.along[static_cast<std::size_t>(axis)][static_cast<std::size_t>(way)] =
          ErrorTable({{0.0, first}, {100.0, last}});
    }
  }
  setup.c0y = 12.0;
  setup.b0z = -7.0;
  setup.a0z = 5.0;
  return setup;
}

/// One of the eighteen by its own formula.
double single(int axis, int way, double place) {
  const double size = way < 3 ? 1e-3 : 1e-6;
  const double first = size * (1 + axis + 3 * way);
  const double last = size * (7 - 2 * axis - way);
  return first + (last - first) * place / 100.0;
}

/// A touch of a wall ends where x + A sin(2 pi x / p + phase) is the wall, by Newton's method;
/// pitches that divide the pieces of a way are no exception.
TEST(MachineErrors, CyclicErrorsComeBackWithTheScrew) {
  struct Screw {
    double pitch, amplitude;
  };
  for (const auto& [pitch, amplitude] : {Screw{10.0, 0.003},
                                         {5.0, 0.003},
                                         {2.5, 0.003},
                                         {1.25, 0.003},
                                         {0.7, 0.003},
                                         {0.03, 0.001},
                                         {0.011, 0.001},
                                         {0.004, 0.0005}}) {
    for (const double wall : {0.31, 4.1, 17.3, 33.33}) {
      MachineSetup setup = stops_at_once();
      setup.axes[0].cyclic_error = {amplitude, pitch, 40.0};
      const double turns = 2.0 * 3.14159265358979323846 / pitch;
      const double phase = 40.0 / 180.0 * 3.14159265358979323846;
      double expected = wall;
      for (int i = 0; i < 200; ++i) {
        expected -= (expected + amplitude * std::sin(turns * expected + phase) - wall) /
                    (1.0 + amplitude * turns * std::cos(turns * expected + phase));
      }
      Wall world(0, wall);
      MachiningCentre machine(setup, &world);
      EXPECT_NEAR(latched(machine, axes(40.0, 0.0, 0.0))[0], expected, 2e-6) << pitch;
    }
  }
  MachineSetup still;
  still.axes[0].cyclic_error.pitch = 4.0;
  EXPECT_TRUE(TruePosition(still).is_ideal());
}

TEST(MachineErrors, CompensationIsAddedWhereTheAxesStand) {
  MachineSetup setup;
  setup.compensation.along[0][1] = ErrorTable({{0.0, 0.001}, {100.0, 0.003}});   // EYX
  setup.compensation.along[2][1] = ErrorTable({{0.0, -0.004}, {50.0, -0.004}});  // EYZ
  setup.compensation.along[0][0] = ErrorTable({{0.0, 0.0}, {100.0, 0.010}});     // EXX
  EXPECT_FALSE(TruePosition(setup).is_ideal());
  const AxisPositions q = TruePosition(setup).after(axes(50.0, 7.0, 20.0));
  EXPECT_DOUBLE_EQ(q[0], 50.005);
  EXPECT_DOUBLE_EQ(q[1], 7.0 + 0.002 - 0.004);
  EXPECT_DOUBLE_EQ(q[2], 20.0);
}

TEST(MachineErrors, TheVolumetricErrorIsTheSumWrittenOut) {
  const errors::GeometricErrors map(all_errors());
  const Point p_T(0.5, -0.25, -120.0);
  const Point kPlaces[] = {{0, 0, 0}, {100, 0, 0}, {10, 20, 30}, {99, 1, 50}, {33.3, 66.6, 12.5}};
  for (const Point& p : kPlaces) {
    const double x = p.x(), y = p.y(), z = p.z();
    const auto e = [&](int way, int axis) { return single(axis, way, p[axis]); };
    // Part - X - Y - Z - tool.  Arms: Z the tool; Y the tool and z; X the tool, y and z.
    const double u = p_T.x(), v = p_T.y(), w = p_T.z();
    const double dx = e(0, 0) + e(0, 1) + e(0, 2)              // EXX EXY EXZ
                      + e(4, 0) * (z + w) - e(5, 0) * (y + v)  // EBX ECX
                      + e(4, 1) * (z + w) - e(5, 1) * v        // EBY ECY
                      + e(4, 2) * w - e(5, 2) * v              // EBZ ECZ
                      - 12e-6 * y - 7e-6 * z;                  // EC0Y EB0Z
    const double dy = e(1, 0) + e(1, 1) + e(1, 2)              //
                      + e(5, 0) * u - e(3, 0) * (z + w)        //
                      + e(5, 1) * u - e(3, 1) * (z + w)        //
                      + e(5, 2) * u - e(3, 2) * w              //
                      - 5e-6 * z;                              // EA0Z
    const double dz = e(2, 0) + e(2, 1) + e(2, 2)              //
                      + e(3, 0) * (y + v) - e(4, 0) * u        //
                      + e(3, 1) * v - e(4, 1) * u              //
                      + e(3, 2) * v - e(4, 2) * u;
    EXPECT_LT((map.at(p, p_T) - Point(dx, dy, dz)).norm(), 1e-16) << x << ' ' << y << ' ' << z;
  }
}

/// One error alone, the place where it is looked at, and what it does there.
struct OneError {
  const char* name;
  int axis, way;  ///< E, direction, axis; squareness has no axis
  int probed;     ///< the axis on which it is seen
  double displacement;
};

// X 200, Y 100, Z 50, the tip at (1, 2, -120) from the gauge point; part - X - Y - Z - tool.
// Linear errors 3 um, angular ones 10 um/m; what follows the axis towards the tip is turned.
const OneError kEach[] = {
    {"EXX", 0, 0, 0, 0.003},
    {"EYX", 0, 1, 1, 0.003},
    {"EZX", 0, 2, 2, 0.003},
    {"EXY", 1, 0, 0, 0.003},
    {"EYY", 1, 1, 1, 0.003},
    {"EZY", 1, 2, 2, 0.003},
    {"EXZ", 2, 0, 0, 0.003},
    {"EYZ", 2, 1, 1, 0.003},
    {"EZZ", 2, 2, 2, 0.003},
    {"EAX lowers Y by what stands above it", 0, 3, 1, -1e-5 * (50 - 120)},
    {"EAX raises what is behind it", 0, 3, 2, 1e-5 * (100 + 2)},
    {"EBX moves X by what stands above it", 0, 4, 0, 1e-5 * (50 - 120)},
    {"EBX lowers what is beside it", 0, 4, 2, -1e-5 * 1},
    {"ECX moves X back by Y", 0, 5, 0, -1e-5 * (100 + 2)},
    {"ECX moves Y by the tip", 0, 5, 1, 1e-5 * 1},
    {"EAY", 1, 3, 1, -1e-5 * (50 - 120)},
    {"EAY does not turn Y itself", 1, 3, 2, 1e-5 * 2},
    {"EBY", 1, 4, 0, 1e-5 * (50 - 120)},
    {"EBY raises the tip", 1, 4, 2, -1e-5 * 1},
    {"ECY turns the tip alone", 1, 5, 0, -1e-5 * 2},
    {"ECY turns the tip alone, Y", 1, 5, 1, 1e-5 * 1},
    {"EAZ does not turn Z itself", 2, 3, 1, 1e-5 * 120},
    {"EBZ", 2, 4, 0, -1e-5 * 120},
    {"ECZ", 2, 5, 0, -1e-5 * 2},
    {"ECZ, Y", 2, 5, 1, 1e-5 * 1},
    {"A0Z leans Z back", -1, 3, 1, -1e-5 * 50},
    {"B0Z leans Z to +X", -1, 4, 0, 1e-5 * 50},
    {"C0Y leans Y to -X", -1, 5, 0, -1e-5 * 100},
};

MachineSetup with_one(const OneError& one) {
  MachineSetup setup = stops_at_once();
  setup.p_T_tip = Point(1, 2, -120);
  errors::GeometricErrorSetup& errors = setup.geometric_errors;
  if (one.axis >= 0) {
    errors.along[static_cast<std::size_t>(one.axis)][static_cast<std::size_t>(one.way)] =
        ErrorTable({{0.0, one.way < 3 ? 0.003 : 10.0}});
  } else {
    (one.way == 3 ? errors.a0z : one.way == 4 ? errors.b0z : errors.c0y) = 10.0;
  }
  return setup;
}

TEST(MachineErrors, EachOfThe21IsSeenByATouchWithItsSignAndItsLever) {
  const AxisPositions q_M = axes(200, 100, 50);
  for (const OneError& one : kEach) {
    SCOPED_TRACE(one.name);
    MachineSetup setup = with_one(one);
    setup.q_M_start = q_M;
    setup.q_M_start[one.probed] -= 4.0;
    AxisPositions q_M_end = q_M;
    q_M_end[one.probed] += 4.0;
    Wall wall(one.probed, q_M[one.probed]);
    MachiningCentre centre(setup, &wall);
    // The tip is there too early by the displacement: the encoder stands that much before the wall.
    EXPECT_NEAR(latched(centre, q_M_end)[one.probed], q_M[one.probed] - one.displacement, 1e-8);
  }
}

// Each error moves the tip nowhere else: of the six numbers that are not in the table above.
TEST(MachineErrors, EachOfThe21LeavesTheOtherDirectionsAlone) {
  for (const OneError& one : kEach) {
    SCOPED_TRACE(one.name);
    const Point d =
        errors::GeometricErrors(with_one(one).geometric_errors).at({200, 100, 50}, {1, 2, -120});
    EXPECT_NEAR(d[one.probed], one.displacement, 1e-15);
    if (one.way < 3 || one.axis < 0) {
      EXPECT_NEAR(d.norm(), std::abs(one.displacement), 1e-15);
    } else {
      EXPECT_EQ(d[one.way - 3], 0.0) << "along its own axis nothing turns";
    }
  }
}

TEST(MachineErrors, SquarenessIsTheSameInEitherOrderOfAxesAndOfMoves) {
  for (const std::array<int, 3>& order :
       {std::array<int, 3>{0, 1, 2}, std::array<int, 3>{1, 0, 2}, std::array<int, 3>{2, 1, 0}}) {
    for (const bool x_first : {true, false}) {
      MachineSetup setup = stops_at_once();
      setup.geometric_errors.c0y = 100.0;
      setup.geometric_errors.part_to_tool = order;
      Wall wall(0, 205.0);
      MachiningCentre centre(setup, &wall);
      ASSERT_TRUE(centre.move(feed(x_first ? axes(200, 0, 0) : axes(0, 300, 0))).ok());
      ASSERT_TRUE(centre.move(feed(axes(200, 300, 0))).ok());
      EXPECT_NEAR(latched(centre, axes(210, 300, 0))[0], 205.0 + 0.03, 1e-8);
    }
  }
}

TEST(MachineErrors, TheOrderOfTheAxesDecidesAboutTheArms) {
  errors::GeometricErrorSetup setup;
  setup.along[1][5] = ErrorTable({{0.0, 10.0}});  // ECY, 10 um/m
  const Point p(200.0, 50.0, 0.0);
  EXPECT_LT((errors::GeometricErrors(setup).at(p, Point::Zero()) - Point::Zero()).norm(), 1e-18)
      << "X lies between Y and the part: it does not turn";
  setup.part_to_tool = {1, 0, 2};
  EXPECT_LT((errors::GeometricErrors(setup).at(p, Point::Zero()) - Point(0, 0.002, 0)).norm(),
            1e-18)
      << "Y carries X: 10 um/m over 200 mm";
}

TEST(MachineErrors, TablesAreStraightBetweenTheirPlacesAndConstantOutside) {
  const ErrorTable table({{-10.0, 1.0}, {0.0, 3.0}, {30.0, 0.0}});
  EXPECT_EQ(table.at(-11.0), 1.0);
  EXPECT_EQ(table.at(-5.0), 2.0);
  EXPECT_EQ(table.at(0.0), 3.0);
  EXPECT_EQ(table.at(10.0), 2.0);
  EXPECT_EQ(table.at(31.0), 0.0);
}

TEST(MachineErrors, SquarenessShowsInMeasuredPositions) {
  MachineSetup setup = stops_at_once();
  setup.geometric_errors.c0y = 100.0;  // 0.1 mm on 1000
  for (const double y : {0.0, 100.0, 300.0}) {
    setup.q_M_start = axes(0, y, 0);
    Wall wall(0, 5.0);
    MachiningCentre centre(setup, &wall);
    // The tip is -1e-4 y off in X: the encoder must go that much further to touch.
    EXPECT_NEAR(latched(centre, axes(10, y, 0))[0], 5.0 + 1e-4 * y, 1e-9) << y;
  }
}

TEST(MachineErrors, BacklashIsSeenAfterAReversal) {
  MachineSetup setup = stops_at_once();
  setup.axes[0].play.backlash = 0.010;
  Wall wall(0, 5.0);
  MachiningCentre centre(setup, &wall);
  EXPECT_NEAR(latched(centre, axes(10, 0, 0))[0], 5.0, 1e-9) << "from the positive direction: none";
  ASSERT_TRUE(centre.move(feed(axes(9, 0, 0))).ok());
  EXPECT_NEAR(latched(centre, axes(0, 0, 0))[0], 5.0 - 0.010, 1e-9);
  ASSERT_TRUE(centre.move(feed(axes(1, 0, 0))).ok());
  EXPECT_NEAR(latched(centre, axes(10, 0, 0))[0], 5.0, 1e-9);
}

TEST(MachineErrors, ATableStandsStillWhileTheEncoderTakesUpTheBacklash) {
  const errors::AxisPlay up = errors::AxisPlay({0.010, 0.0, 0.05}, 0.0).after(3.0);
  EXPECT_EQ(up.offset(), 0.0);
  EXPECT_NEAR(up.after(2.996).offset(), 0.004, 1e-15);
  EXPECT_NEAR(up.after(2.0).offset(), 0.010, 1e-15);
  EXPECT_NEAR(up.after(2.0).after(2.003).offset(), 0.007, 1e-15);
}

TEST(MachineErrors, BacklashAndSpikeTogetherNeverMoveTheTableBack) {
  const errors::PlaySetup setups[] = {
      {0.002, 0.003, 0.05}, {0.010, 0.0, 0.05}, {0.0, 0.005, 0.02}, {0.001, 0.0025, 0.01}};
  for (const errors::PlaySetup& setup : setups) {
    errors::AxisPlay play(setup, 0.0);
    double q = 0.0;
    double table = 0.0;
    // To and fro, ever shorter, in steps of a micrometre.
    for (const double way : {1.0, -0.5, 0.3, -0.02, 0.01, -0.004}) {
      const double direction = std::copysign(1.0, way);
      for (int i = 0; i < static_cast<int>(std::abs(way) * 1000.0 + 0.5); ++i) {
        q += direction * 0.001;
        play = play.after(q);
        const double moved = direction * (q + play.offset() - table);
        ASSERT_GE(moved, -1e-12) << q << ' ' << way;
        ASSERT_LE(moved, 0.001 * (1.0 + 3.0 * setup.spike / setup.spike_way) + 1e-12);
        table = q + play.offset();
      }
    }
  }
}

TEST(MachineErrors, AReversalSpikeReachesItsHeightAndDiesAway) {
  const errors::AxisPlay up = errors::AxisPlay({0.0, 0.010, 0.05}, 0.0).after(3.0);
  EXPECT_EQ(up.offset(), 0.0) << "the first move is no reversal";
  EXPECT_NEAR(up.after(2.95).offset(), 0.010, 1e-15) << "behind by its height after spike_way";
  EXPECT_NEAR(up.after(2.90).offset(), 0.010 * 2.0 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(up.after(0.0).offset(), 0.0);
}

TEST(MachineErrors, AWarmScaleReadsLess) {
  MachineSetup setup = stops_at_once();
  setup.axes[0].scale_growth = {11.5, 30.0};
  setup.axes[0].scale_fixed_at = 100.0;
  setup.q_M_start = axes(290, 0, 0);
  Wall wall(0, 300.0);
  MachiningCentre centre(setup, &wall);
  // true = q + 115e-6 (q - 100)
  EXPECT_NEAR(latched(centre, axes(310, 0, 0))[0], (300.0 + 115e-6 * 100.0) / (1.0 + 115e-6), 1e-9);
}

TEST(MachineErrors, AnEncoderWithStepsLatchesWholeSteps) {
  MachineSetup setup = stops_at_once();
  setup.axes[0].scale_resolution = 0.001;
  Wall wall(0, 5.00037);
  MachiningCentre centre(setup, &wall);
  EXPECT_NEAR(latched(centre, axes(10, 0, 0))[0], 5.000, 1e-12);
  EXPECT_NEAR(centre.position()[0], 5.000, 1e-12);
}

TEST(MachineErrors, TheTrueWayStaysWithinItsTolerance) {
  MachineSetup setup;
  setup.geometric_errors = all_errors();
  setup.p_T_tip = Point(0, 0, -120);
  setup.axes[0].play = {0.010, 0.008, 0.05};
  setup.q_M_start = axes(5, 0, 0);
  TruePosition truth(setup);
  truth.go_to(axes(0, 0, 0));
  const StraightPath path(axes(0, 0, 0), axes(90, 40, 30));
  const MotionProfile profile(path.length(), 20.0, 500.0);
  const ServoMotion motion(path, profile.phases(), {}, {});
  const TrueWay way(truth, motion, motion.duration_s(), {kTouchWayErrorMm, 0.0});
  const auto points = way.points();
  ASSERT_EQ(points.back().fraction, 1.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point from = linear_axes(points[i - 1].q_M);
    const Point chord = linear_axes(points[i].q_M) - from;
    for (const double part : {0.1, 0.3, 0.62, 0.9}) {
      const double fraction =
          points[i - 1].fraction + part * (points[i].fraction - points[i - 1].fraction);
      const AxisPositions q_M_true = truth.after(motion.encoder_at(way.time_s(fraction)));
      ASSERT_LT((linear_axes(q_M_true) - from - part * chord).norm(), 2.0 * kTouchWayErrorMm)
          << fraction;
    }
  }
  EXPECT_LT(points.size(), 2000U);
}

}  // namespace
}  // namespace g31::machine::machine_errors_test
