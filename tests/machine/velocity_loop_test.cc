// Stick motion: an axis with position and velocity loop and friction, on a circle where it turns
// back.  The second way is the same equation by Runge and Kutta's method in steps of 10 us, from
// the exact command; heights and widths are those of a solver with variable steps outside g31.

#include "machine/sim/velocity_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace g31::machine::velocity_loop_test {
namespace {

constexpr double kRadius = 50.0;
constexpr double kBeforeS = 1.5;
constexpr double kBehindS = 0.6;

LoopMotion::Setup loop(double friction, double feed_forward = 0.0) {
  return {{250.0, 0.01, friction, 0.02}, 28.0, feed_forward};
}

/// The command of one axis on the circle, which turns back at the time 0.
struct Turn {
  double w;
  [[nodiscard]] double place(double t) const { return kRadius * std::cos(w * t); }
  [[nodiscard]] double speed(double t) const { return -kRadius * w * std::sin(w * t); }
  [[nodiscard]] double acceleration(double t) const { return -w * w * place(t); }
};

/// As if it had long been under way at the time -kBeforeS.
LoopSample start_of(const LoopMotion::Setup& setup, const Turn& turn) {
  const double t = -kBeforeS;
  const double friction = setup.loop.friction_per_s2;
  const double behind = (1.0 - setup.feed_forward) * turn.speed(t) / setup.position_gain_per_s;
  return {
      0.0,
      turn.place(t) - behind,
      {turn.speed(t),
       (turn.acceleration(t) + friction) * setup.loop.reset_s / setup.loop.gain_per_s, friction}};
}

using State = std::array<double, 4>;  // position, speed, integral, friction

State rates(const LoopMotion::Setup& setup, const Turn& turn, double t, const State& y) {
  const VelocityLoopSetup& l = setup.loop;
  const double e = setup.position_gain_per_s * (turn.place(t) - y[0]) +
                   setup.feed_forward * turn.speed(t) - y[1];
  const double sign = y[1] < 0.0 ? -1.0 : 1.0;
  return {y[1], l.gain_per_s * (e + y[2] / l.reset_s) - y[3], e,
          (l.friction_per_s2 * sign - y[3]) * std::abs(y[1]) / l.friction_way};
}

State moved(const State& y, const State& by, double h) {
  State out = y;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] += h * by[i];
  }
  return out;
}

/// Positions every millisecond from the time -kBeforeS on.
std::vector<double> by_runge_kutta(const LoopMotion::Setup& setup, const Turn& turn) {
  const LoopSample start = start_of(setup, turn);
  State y = {start.position, start.state.speed, start.state.integral, start.state.friction};
  const double h = 1e-5;
  std::vector<double> places = {y[0]};
  const int steps = static_cast<int>(std::lround((kBeforeS + kBehindS) / h));
  for (int i = 0; i < steps; ++i) {
    const double t = i * h - kBeforeS;
    const State a = rates(setup, turn, t, y);
    const State b = rates(setup, turn, t + h / 2, moved(y, a, h / 2));
    const State c = rates(setup, turn, t + h / 2, moved(y, b, h / 2));
    const State d = rates(setup, turn, t + h, moved(y, c, h));
    for (std::size_t k = 0; k < y.size(); ++k) {
      y[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
    }
    if ((i + 1) % 100 == 0) {
      places.push_back(y[0]);
    }
  }
  return places;
}

std::vector<double> by_loop_motion(const LoopMotion::Setup& setup, const Turn& turn) {
  const LoopSample start = start_of(setup, turn);
  LoopMotion motion(setup, start.position, start.state);
  const double h = 1e-3;
  const int pieces = static_cast<int>(std::lround((kBeforeS + kBehindS) / h));
  std::vector<double> places = {start.position};
  for (int i = 0; i < pieces; ++i) {
    const double t = i * h - kBeforeS;
    const double way = turn.place(t + h) - turn.place(t);
    const double v_from = h * turn.speed(t);
    const double v_to = h * turn.speed(t + h);
    motion.follow({turn.place(t), v_from / h, (3.0 * way - 2.0 * v_from - v_to) / (h * h),
                   (v_from + v_to - 2.0 * way) / (h * h * h)},
                  h);
    places.push_back(motion.at((i + 1) * h).position);
  }
  return places;
}

struct Spike {
  double height_um = 0.0;
  double width_ms = 0.0;  ///< at half its height
};

/// What friction adds to the motion without it.
Spike spike_of(const std::vector<double>& with, const std::vector<double>& without) {
  Spike spike;
  std::vector<double> added(with.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    added[i] = 1000.0 * (with[i] - without[i]);
    spike.height_um = std::max(spike.height_um, added[i]);
  }
  const auto half = [&](std::size_t i) {  // where it crosses half of it, ms
    return static_cast<double>(i) - (added[i] - 0.5 * spike.height_um) / (added[i] - added[i - 1]);
  };
  std::size_t rises = 1;
  while (added[rises] < 0.5 * spike.height_um) {
    ++rises;
  }
  std::size_t falls = added.size() - 1;
  while (added[falls - 1] < 0.5 * spike.height_um) {
    --falls;
  }
  spike.width_ms = half(falls) - half(rises);
  return spike;
}

TEST(VelocityLoop, FrictionThatTurnsRoundMakesASpike) {
  struct Row {
    double feed_m_min, height_um, width_ms;
  };
  const Row kRows[] = {{0.5, 4.03, 202.0}, {1.0, 6.72, 119.0}, {2.0, 10.01, 75.7},
                       {3.0, 12.01, 60.5}, {4.0, 13.39, 52.5}, {6.0, 15.12, 44.8}};
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.feed_m_min);
    const Turn turn{row.feed_m_min * 1000.0 / 60.0 / kRadius};
    const auto with = by_loop_motion(loop(300.0), turn);
    const auto exact = by_runge_kutta(loop(300.0), turn);
    for (std::size_t i = 0; i < with.size(); ++i) {
      ASSERT_NEAR(with[i], exact[i], 1e-6) << "ms " << i;
    }
    const Spike spike = spike_of(with, by_loop_motion(loop(0.0), turn));
    EXPECT_NEAR(spike.height_um, row.height_um, 0.006);
    EXPECT_NEAR(spike.width_ms, row.width_ms, 0.6);
  }
}

// Feed-forward of the speed takes the lag, not the spike.
TEST(VelocityLoop, FeedForwardDoesNotChangeTheSpike) {
  const Turn turn{2000.0 / 60.0 / kRadius};
  const Spike spike =
      spike_of(by_loop_motion(loop(300.0, 0.95), turn), by_loop_motion(loop(0.0, 0.95), turn));
  EXPECT_NEAR(spike.height_um, 10.01, 0.01);
}

// Without friction the loop is linear: a ramp is followed v / Kp behind, a stop without rest.
TEST(VelocityLoop, ARampIsFollowedSpeedOverGainBehindAndTheEndIsReached) {
  for (const double friction : {0.0, 300.0}) {
    LoopMotion motion(loop(friction), 0.0, {});
    motion.follow({0.0, 50.0, 0.0, 0.0}, 2.0);
    EXPECT_NEAR(100.0 - motion.at(2.0).position, 50.0 / 28.0, 1e-6);
    EXPECT_NEAR(motion.at(1.99995).state.speed, 50.0, 1e-5);
    const double near_s = motion.within_s(0.01);
    EXPECT_NEAR(std::abs(motion.at(near_s).position - 100.0), 0.01, 2e-4);
    EXPECT_NEAR(motion.at(20.0).position, 100.0, 1e-6);
    EXPECT_EQ(motion.at(30.0).position, motion.at(300.0).position);
  }
}

// By Hurwitz the roots of s^3 + w s^2 + w (Kp + 1/Ti) s + w Kp/Ti are damped where
// w (Kp + 1/Ti) > Kp/Ti; slow loops are so in steps of 0.1 ms too.
TEST(VelocityLoop, SettlesWhereItsRootsAreDamped) {
  int settled = 0;
  int swinging = 0;
  for (const double gain : {2.0, 10.0, 50.0, 250.0}) {
    for (const double position_gain : {1.0, 27.0, 100.0, 400.0}) {
      for (const double reset_s : {0.002, 0.01, 0.1}) {
        const double left = gain * (position_gain + 1.0 / reset_s);
        const double right = position_gain / reset_s;
        if (std::abs(left - right) < 0.05 * right) {
          continue;  // too near to tell in steps
        }
        EXPECT_EQ(settles({{gain, reset_s, 0.0, 0.02}, position_gain, 0.0}), left > right)
            << gain << " " << position_gain << " " << reset_s;
        (left > right ? settled : swinging)++;
      }
    }
  }
  EXPECT_GT(settled, 10);
  EXPECT_GT(swinging, 10);
  // The steps are too long for a loop of a millionth of a second.
  EXPECT_FALSE(settles({{1e6, 0.01, 0.0, 0.02}, 27.0, 0.0}));
}

// However steep friction is, it stays between its two values.
TEST(VelocityLoop, SteepFrictionStaysFinite) {
  LoopMotion::Setup steep = loop(1e6);
  steep.loop.friction_way = 1e-9;
  LoopMotion motion(steep, 0.0, {});
  motion.follow({0.0, 50.0, 0.0, 0.0}, 1.0);
  motion.follow({50.0, -50.0, 0.0, 0.0}, 1.0);
  for (int ms = 0; ms <= 2000; ++ms) {
    const LoopSample sample = motion.at(ms * 1e-3);
    ASSERT_TRUE(std::isfinite(sample.position));
    ASSERT_LE(std::abs(sample.state.friction), 1e6);
  }
}

}  // namespace
}  // namespace g31::machine::velocity_loop_test
