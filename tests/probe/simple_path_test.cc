// The simple path of a move is the definition: axes that follow their commands through a chain, the
// world asked about points.  The fast path, straight from end to end or along a curve, gives the
// same: the same programs on both, over random worlds.

#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/sim/machining_centre.h"
#include "machine/sim/true_way.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/effort.h"

namespace g31::probe::simple_path_test {
namespace {

using machine::ArcMove;
using machine::LinearMove;
using machine::MachiningCentre;
using machine::SkipMove;

constexpr int kMostMoves = 12;
constexpr double kSlowestMmPerMin = 50.0;
constexpr double kSlowestMmPerS = kSlowestMmPerMin / 60.0;

/// Random numbers of one test, in order.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * uniform({seed_, 1}, rolled_++);
  }
  bool one_in(int n) { return between(0.0, n) < 1.0; }
  AxisPositions place() {
    AxisPositions q = AxisPositions::Zero();
    q.head<3>() = Point(between(-60, 60), between(-60, 60), between(100, 190));
    return q;
  }

 private:
  std::uint64_t seed_;
  std::uint64_t rolled_ = 0;
};

ProbeSetup random_probe(Dice& dice) {
  ProbeSetup setup;
  setup.trigger_delay_s = dice.between(0.0, 0.004);
  setup.repeatability_mm = dice.one_in(2) ? 0.001 : 0.0;
  setup.at_switch.pre_travel_mm = dice.one_in(2) ? 0.01 : 0.0;
  setup.deflection_limit_mm = 1.5;
  setup.eccentricity_mm = {dice.between(-0.1, 0.1), dice.between(-0.1, 0.1)};
  if (dice.one_in(2)) {
    setup.stem = {{"stem", 0.0, 50.0, 1.5, 1.5}};
    setup.bodies = {{"probe body", 50.0, 120.0, 20.0, 20.0}};
  }
  return setup;
}

std::vector<ProbedPart> random_parts(Dice& dice) {
  std::vector<ProbedPart> parts;
  for (int i = 0; i < 3; ++i) {
    const Point size(dice.between(5, 40), dice.between(5, 40), dice.between(5, 40));
    const Point at(dice.between(-60, 30), dice.between(-60, 30), dice.between(-20, 20));
    const parts::Placement place{at, Point(0, 0, dice.between(0, 90))};
    parts.push_back(
        {"block " + std::to_string(i), parts::placed_mesh(testing::box_mesh(size), place)});
  }
  return parts;
}

/// The same machine, its every move told to the world through its chain: a table that stands at 0.
machine::MachineSetup simple(machine::MachineSetup setup) {
  setup.chain.table_side = "C";
  setup.axes[5].present = true;
  return setup;
}

/// Runs the same moves on two machines and compares what they say.
class Pair {
 public:
  Pair(const machine::MachineSetup& setup, const ProbeSetup& probe, Dice& dice, std::uint64_t seed)
      : parts_(random_parts(dice)),
        fast_world_(probe, parts_, seed),
        simple_world_(probe, parts_, seed),
        fast_(setup, &fast_world_),
        simple_(simple(setup), &simple_world_) {}

  /// @returns whether both went through
  template <typename Move>
  bool move(const Move& move) {
    const AxisPositions q_M_from = fast_.position();
    const auto a = fast_.move(move);
    const auto b = simple_.move(move);
    if (a.ok() != b.ok()) {
      // Whether an arc that leaves a surface goes deeper at first lies within the error of a way.
      const machine::MachineFault& met = (a.ok() ? b : a).error();
      grazes = linear_axes(met.q_M_at - q_M_from).squaredNorm() < machine::kMoveWayErrorMm;
      EXPECT_TRUE(grazes) << met.what;
    }
    if (!a.ok() && !b.ok()) {
      EXPECT_EQ(a.error().what, b.error().what);
      // A way that grazes a surface touches it much later or sooner for its own error.
      const Point apart = linear_axes(a.error().q_M_at) - linear_axes(b.error().q_M_at);
      grazes = apart.norm() > 2.0 * machine::kMoveWayErrorMm;
    }
    return a.ok() && b.ok() && agree(machine::kMoveWayErrorMm);
  }

  bool skip(const SkipMove& move) {
    const auto a = fast_.move_until_skip(move);
    const auto b = simple_.move_until_skip(move);
    EXPECT_EQ(a.ok(), b.ok()) << (a.ok() ? b : a).error().what;
    if (!a.ok() || !b.ok()) {
      return false;
    }
    EXPECT_EQ(a.value().index(), b.value().index());
    if (const auto* touched = std::get_if<machine::Touched>(&a.value())) {
      ++touches;
      const auto& other = std::get<machine::Touched>(b.value());
      EXPECT_LT((touched->q_M_latched - other.q_M_latched).norm(), machine::kTouchWayErrorMm);
      EXPECT_EQ(touched->contact->part, other.contact->part);
      EXPECT_LT((touched->contact->p_M_point - other.contact->p_M_point).norm(),
                machine::kTouchWayErrorMm);
    }
    return agree(machine::kTouchWayErrorMm);
  }

  [[nodiscard]] AxisPositions position() const { return fast_.position(); }

  int touches = 0;
  bool grazes = false;

 private:
  bool agree(double tolerance_mm) {
    const bool same = (fast_.position() - simple_.position()).norm() <= tolerance_mm;
    EXPECT_TRUE(same) << fast_.position().transpose() << " or " << simple_.position().transpose();
    EXPECT_NEAR(fast_.time_s(), simple_.time_s(), kMostMoves * tolerance_mm / kSlowestMmPerS);
    return same;
  }

  std::vector<ProbedPart> parts_;
  TouchProbe fast_world_;
  TouchProbe simple_world_;
  MachiningCentre fast_;
  MachiningCentre simple_;
};

bool random_move(Dice& dice, Pair& pair) {
  const double feed = dice.between(kSlowestMmPerMin, 3000.0);
  const AxisPositions q_M_end = dice.place();
  const LinearMove straight{
      q_M_end, dice.one_in(4) ? machine::Traverse::Rapid : machine::Traverse::Feed, feed};
  if (dice.one_in(3)) {
    ArcMove arc;
    arc.q_M_end = q_M_end;
    arc.centre_first = 0.5 * (pair.position()[0] + q_M_end[0]);
    arc.centre_second = 0.5 * (pair.position()[1] + q_M_end[1]);
    arc.turn = dice.one_in(2) ? machine::Turn::Clockwise : machine::Turn::Counterclockwise;
    arc.feed_mm_min = feed;
    return pair.move(arc);
  }
  if (dice.one_in(3)) {
    return pair.move(straight);
  }
  SkipMove skip(straight);
  skip.after = dice.one_in(6) ? machine::AfterSignal::GoOn : machine::AfterSignal::Stop;
  return pair.skip(skip);
}

TEST(SimplePath, IsWhatTheFastOneComesTo) {
  const std::uint64_t runs = testing::of_many(300U);
  int touches = 0;
  int collisions = 0;
  int grazing = 0;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    machine::MachineSetup setup;
    setup.q_M_start.head<3>() = Point(0, 0, 260);
    setup.stop_delay_s = dice.one_in(2) ? 0.008 : 0.0;
    const ProbeSetup probe = random_probe(dice);
    Pair pair(setup, probe, dice, seed);
    bool goes_on = true;
    for (int i = 0; i < kMostMoves && goes_on; ++i) {
      goes_on = random_move(dice, pair);
    }
    touches += pair.touches;
    collisions += goes_on ? 0 : 1;
    grazing += pair.grazes ? 1 : 0;
    ASSERT_FALSE(HasFailure());
  }
  // Both kinds of answers were there to be compared.
  EXPECT_GT(touches, runs / 6);
  EXPECT_GT(collisions, runs / 3);
  EXPECT_LT(grazing, collisions / 10);
}

}  // namespace
}  // namespace g31::probe::simple_path_test
