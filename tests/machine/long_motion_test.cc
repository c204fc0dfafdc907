// Motions that last long: memory stays small, and who watches the work can end it.

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "machine/sim/machining_centre.h"
#include "machine/sim/velocity_loop.h"
#include "tests/support/world_of_pieces.h"

namespace g31::machine::long_motion_test {
namespace {

LoopMotion::Setup loop() {
  return {{250.0, 0.01, 100.0, 0.02}, 28.0, 0.0};
}

/// A command of 20 s in one keeps few of its steps, in two of 10 s each all of them.
TEST(LongMotion, OfAVelocityLoopIsThatOfItsParts) {
  constexpr double kHalfS = 10.0;
  constexpr double kSpeed = 3.0;
  const CommandCubic whole = {1.0, kSpeed, 0.0, 0.0};
  const CommandCubic rest = {1.0 + kHalfS * kSpeed, kSpeed, 0.0, 0.0};
  LoopMotion in_one(loop(), 1.0, {});
  in_one.follow(whole, 2.0 * kHalfS);
  LoopMotion in_two(loop(), 1.0, {});
  in_two.follow(whole, kHalfS);
  in_two.follow(rest, kHalfS);
  // Forward, and to and fro: what is not kept is computed again.
  for (int i = 0; i <= 4000; ++i) {
    const int k = i <= 2000 ? i : (i * 977) % 2003;
    const double time_s = std::min(2.0 * kHalfS + 0.5, 0.010243 * k);
    const LoopSample a = in_one.at(time_s);
    const LoopSample b = in_two.at(time_s);
    ASSERT_NEAR(a.position, b.position, 1e-9) << time_s;
    ASSERT_NEAR(a.state.speed, b.state.speed, 1e-7) << time_s;
    ASSERT_NEAR(a.state.friction, b.state.friction, 1e-6) << time_s;
  }
  EXPECT_NEAR(in_one.within_s(1e-3), in_two.within_s(1e-3), 1e-3);
}

/// At a steady speed the axis is v / Kv behind, after an hour as well; a sample would take 48
/// bytes.
TEST(LongMotion, OfAnHourTakesLittleMemory) {
  constexpr double kHourS = 3600.0;
  struct rusage before = {};
  ::getrusage(RUSAGE_SELF, &before);
  LoopMotion motion(loop(), 0.0, {});
  motion.follow({0.0, 1.0, 0.0, 0.0}, kHourS);
  EXPECT_NEAR(motion.at(kHourS / 2.0).position, kHourS / 2.0 - 1.0 / 28.0, 1e-5);
  EXPECT_NEAR(motion.at(kHourS - 1.0).position, kHourS - 1.0 - 1.0 / 28.0, 1e-5);
  struct rusage after = {};
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 16 << 10);  // kB
}

/// Ends the work at its n-th step.
class Impatient final : public WorkWatch {
 public:
  explicit Impatient(int steps) : left_(steps) {}
  void look() override {
    if (--left_ < 0) {
      throw std::runtime_error("enough");
    }
  }

 private:
  int left_;
};

class CountingSink final : public TraceSink {
 public:
  void on_sample(const TraceSample& /*sample*/) override { ++samples; }
  std::uint64_t samples = 0;
};

/// Asks for many places of a curve, as of a slow one close to a part.
class Asking final : public testing::WorldOfPieces {
 public:
  std::optional<Obstacle> first_obstacle(const Way& way, Travel /*travel*/) override {
    for (int i = 0; i <= 5000; ++i) {
      (void)way.curve()->q_M_at(i / 5000.0);
    }
    return std::nullopt;
  }
};

TEST(LongMotion, AlongACurveIsWatched) {
  Asking world;
  MachiningCentre machine(MachineSetup(), &world);
  Impatient watch(1000);
  machine.watch(watch);
  ArcMove arc;
  arc.q_M_end << 0, 20, 0, 0, 0, 0;
  arc.centre_second = 10.0;
  arc.feed_mm_min = 600.0;
  EXPECT_THROW((void)machine.move(arc), std::runtime_error);
}

TEST(LongMotion, OfATraceIsWatched) {
  MachineSetup setup;
  MachiningCentre machine(setup, nullptr);
  Impatient watch(1000);
  CountingSink sink;
  machine.watch(watch);
  machine.trace(0.001, sink);
  EXPECT_THROW(machine.dwell(99999999.0), std::runtime_error);
  EXPECT_EQ(sink.samples, 1000U);
}

TEST(LongMotion, OfAVelocityLoopIsWatched) {
  MachineSetup setup;
  setup.axes[0].servo_gain = 3.0;
  setup.axes[0].velocity_loop = loop().loop;
  MachiningCentre machine(setup, nullptr);
  Impatient watch(100'000);
  machine.watch(watch);
  LinearMove slow;
  slow.q_M_end[0] = 100.0;
  slow.traverse = Traverse::Feed;
  slow.feed_mm_min = 0.001;  // 70 days
  EXPECT_THROW((void)machine.move(slow), std::runtime_error);
}

}  // namespace
}  // namespace g31::machine::long_motion_test
