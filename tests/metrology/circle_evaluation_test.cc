// Circles of simulated machines whose errors are known: what is estimated is what was put in.

#include "probe/metrology/circle_evaluation.h"

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/metrology/circle_path.h"
#include "tests/support/effort.h"

namespace g31::circle_evaluation_test {
namespace {

using metrology::CircleErrors;
using metrology::CircleEvaluation;
using metrology::CircleRequest;
using testing::CircleMachine;
using testing::recorded_circle;

CircleEvaluation evaluated(const testing::CircleRecord& record, const CircleRequest& request) {
  const auto made = metrology::evaluate_circle(record.samples(), request);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error());
  return made.ok() ? made.value() : CircleEvaluation();
}

std::map<std::string, double> named(const CircleErrors& e) {
  return {{"scale X", e.scale[0]},       {"scale Y", e.scale[1]},
          {"backlash X", e.backlash[0]}, {"backlash Y", e.backlash[1]},
          {"squareness", e.squareness},  {"mismatch", e.mismatch},
          {"centre X", e.centre.x()},    {"centre Y", e.centre.y()}};
}

CircleMachine any_machine(std::uint64_t seed) {
  const auto between = [&](double low, double high, std::uint64_t which) {
    return low + (high - low) * uniform(Stream{seed, 3}, which);
  };
  CircleMachine machine;
  machine.errors.centre = {between(-300.0, 300.0, 0), between(-300.0, 300.0, 1)};
  machine.errors.radius = between(20.0, 150.0, 2);
  machine.errors.backlash = {between(0.0, 0.02, 3), between(0.0, 0.02, 4)};
  machine.errors.scale = {between(-1e-4, 1e-4, 5), between(-1e-4, 1e-4, 6)};
  machine.errors.squareness = between(-1e-4, 1e-4, 7);
  machine.errors.mismatch = between(-1e-3, 1e-3, 8);
  machine.bow = {between(-2e-4, 2e-4, 9), between(-2e-4, 2e-4, 10)};
  machine.noise = between(1e-4, 5e-4, 11);
  machine.start = between(0.0, 6.28, 12);
  machine.feed_mm_s = between(10.0, 60.0, 13);
  machine.seed = seed;
  return machine;
}

/// Counter-clockwise at R + a, clockwise at R + b cos 2 theta: H is a + b, at 90 degrees, and the
/// mean of both over the angle is R + a / 2.
TEST(CircleEvaluation, ComparesTheDirections) {
  constexpr std::size_t kTurn = 72'000;
  constexpr double kRadius = 50.0;
  constexpr double kA = 0.003;
  constexpr double kB = 0.002;
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < 2 * kTurn; ++i) {
    const bool is_ccw = i < kTurn;
    const double part = (static_cast<double>(i % kTurn) + 0.5) / static_cast<double>(kTurn);
    const double theta = (is_ccw ? part : 1.0 - part) * 2.0 * std::numbers::pi;
    const double radius = kRadius + (is_ccw ? kA : kB * std::cos(2.0 * theta));
    t.push_back(static_cast<double>(i));
    x.push_back(3.0 + radius * std::cos(theta));
    y.push_back(4.0 + radius * std::sin(theta));
  }
  const metrology::PlaneSamples samples{t, x, y};
  const metrology::Circle reference{{3.0, 4.0}, kRadius};
  const std::vector<metrology::CircleTurn> turns = {{0, kTurn, 1, 0.0, 6.2, 0.0},
                                                    {kTurn, 2 * kTurn, -1, 0.0, 6.2, 0.0}};
  const auto both = metrology::compare_directions(samples, turns, reference);
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->hysteresis, kA + kB, 1e-8);
  EXPECT_NEAR(both->mean, 0.5 * kA, 1e-9);
  const std::vector<metrology::CircleTurn> one = {turns.front()};
  EXPECT_FALSE(metrology::compare_directions(samples, one, reference));
}

TEST(CircleEvaluation, FindsTheErrorsOfTwoHundredMachinesWithinItsUncertainties) {
  const unsigned machines = testing::of_many(200U);
  int inside = 0;
  int all = 0;
  std::map<std::string, double> sum;  // of errors in their uncertainties
  for (unsigned seed = 1; seed <= machines; ++seed) {
    const CircleMachine machine = any_machine(seed);
    const CircleEvaluation circle =
        evaluated(recorded_circle(machine), {machine.errors.radius, {}, 0.0});
    ASSERT_TRUE(circle.fit.has_mismatch);
    const auto truth = named(machine.errors);
    const auto found = named(circle.fit.errors);
    for (const auto& [name, u] : named(circle.fit.u)) {
      // A bow moves the centre: that is no error of the estimate.
      if (name.starts_with("centre")) {
        continue;
      }
      const double off = (found.at(name) - truth.at(name)) / u;
      inside += std::abs(off) <= 3.0 ? 1 : 0;
      ++all;
      sum[name] += off;
    }
  }
  EXPECT_GE(inside, 0.99 * all) << inside << " of " << all;
  for (const auto& [name, total] : sum) {
    EXPECT_LT(std::abs(total) / machines, 3.5 / std::sqrt(machines)) << name;  // 0.25 of 200
  }
}

TEST(CircleEvaluation, UncertaintiesAreThoseThatRepeatsShow) {
  CircleMachine machine = any_machine(5);
  machine.bow = {};
  constexpr int kRepeats = 60;
  std::map<std::string, double> square;
  std::map<std::string, double> stated;
  for (std::uint64_t seed = 1; seed <= kRepeats; ++seed) {
    machine.seed = seed;
    const CircleEvaluation circle =
        evaluated(recorded_circle(machine), {machine.errors.radius, {}, 0.0});
    const auto truth = named(machine.errors);
    const auto u = named(circle.fit.u);
    for (const auto& [name, value] : named(circle.fit.errors)) {
      square[name] += (value - truth.at(name)) * (value - truth.at(name)) / kRepeats;
      stated[name] += u.at(name) / kRepeats;
    }
  }
  for (const auto& [name, mean_square] : square) {
    // 60 repeats know their own scatter within 9 percent; neighbours count up to a third on top.
    EXPECT_GT(stated.at(name), 0.75 * std::sqrt(mean_square)) << name;
    EXPECT_LT(stated.at(name), 1.75 * std::sqrt(mean_square)) << name;
  }
}

/// Screws of 4 to 16 mm whose lead wavers by up to 3 um: sine and cosine of both axes come back,
/// and so do all the other errors.
TEST(CircleEvaluation, FindsTheCyclicErrorsOfScrewsWithinItsUncertainties) {
  const unsigned machines = testing::of_many(120U);
  int inside = 0;
  int all = 0;
  const auto take = [&](double off, double u) {
    inside += std::abs(off) <= 3.0 * u ? 1 : 0;
    ++all;
  };
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CircleMachine machine = any_machine(seed);
    machine.bow = {};
    const auto between = [&](double low, double high, std::uint64_t which) {
      return low + (high - low) * uniform(Stream{seed, 4}, which);
    };
    machine.errors.pitches = {between(4.0, 16.0, 0), between(4.0, 16.0, 1)};
    machine.amplitude = {between(0.0, 0.003, 2), between(0.0, 0.003, 3)};
    machine.phase = {between(-3.1, 3.1, 4), between(-3.1, 3.1, 5)};
    const CircleEvaluation circle = evaluated(
        recorded_circle(machine), {machine.errors.radius, {}, 0.0, machine.errors.pitches});
    const CircleErrors& found = circle.fit.errors;
    const CircleErrors& u = circle.fit.u;
    for (const std::size_t axis : {0U, 1U}) {
      const double a = machine.amplitude.at(axis);
      take(found.cyclic.at(axis).sine - a * std::cos(machine.phase.at(axis)),
           u.cyclic.at(axis).sine);
      take(found.cyclic.at(axis).cosine - a * std::sin(machine.phase.at(axis)),
           u.cyclic.at(axis).cosine);
      take(found.backlash.at(axis) - machine.errors.backlash.at(axis), u.backlash.at(axis));
      take(found.scale.at(axis) - machine.errors.scale.at(axis), u.scale.at(axis));
    }
    take(found.squareness - machine.errors.squareness, u.squareness);
    take(found.mismatch - machine.errors.mismatch, u.mismatch);
  }
  EXPECT_GE(inside, 0.99 * all) << inside << " of " << all;
}

/// Backlash of up to 0.05 mm and cyclic errors together: the screw is half the backlash beside the
/// middle of both ways, which is up to 2 degrees of its phase and ten times what the phase is
/// uncertain by.  Amplitude, phase and backlash are right within their uncertainties, without bias.
TEST(CircleEvaluation, FindsBacklashAndCyclicErrorsTogether) {
  const unsigned machines = testing::of_many(130U);
  std::map<std::string, std::vector<double>> offs;  // in uncertainties
  for (unsigned seed = 1; seed <= machines; ++seed) {
    CircleMachine machine = any_machine(seed);
    machine.bow = {};
    const auto between = [&](double low, double high, std::uint64_t which) {
      return low + (high - low) * uniform(Stream{seed, 5}, which);
    };
    machine.errors.backlash = {between(0.0, 0.05, 0), between(0.0, 0.05, 1)};
    machine.errors.pitches = {between(4.0, 16.0, 2), between(4.0, 16.0, 3)};
    machine.amplitude = {between(0.001, 0.005, 4), between(0.001, 0.005, 5)};
    machine.phase = {between(-3.1, 3.1, 6), between(-3.1, 3.1, 7)};
    machine.noise = between(1e-4, 3e-4, 8);
    const CircleEvaluation circle = evaluated(
        recorded_circle(machine), {machine.errors.radius, {}, 0.0, machine.errors.pitches});
    const CircleErrors& found = circle.fit.errors;
    const CircleErrors& u = circle.fit.u;
    for (const std::size_t axis : {0U, 1U}) {
      const auto& [sine, cosine] = found.cyclic.at(axis);
      const auto& [u_sine, u_cosine] = u.cyclic.at(axis);
      const double amplitude = std::hypot(sine, cosine);
      const double off_phase =
          std::remainder(std::atan2(cosine, sine) - machine.phase.at(axis), 2.0 * std::numbers::pi);
      offs["phase"].push_back(off_phase * amplitude * amplitude /
                              std::hypot(cosine * u_sine, sine * u_cosine));
      offs["amplitude"].push_back((amplitude - machine.amplitude.at(axis)) * amplitude /
                                  std::hypot(sine * u_sine, cosine * u_cosine));
      offs["backlash"].push_back((found.backlash.at(axis) - machine.errors.backlash.at(axis)) /
                                 u.backlash.at(axis));
    }
  }
  for (const auto& [name, values] : offs) {
    double sum = 0.0;
    double square = 0.0;
    int inside = 0;
    for (const double off : values) {
      sum += off;
      square += off * off;
      inside += std::abs(off) <= 3.0 ? 1 : 0;
    }
    const auto count = static_cast<double>(values.size());
    // Under the sanitizers one of 66 is more than a hundredth.
    EXPECT_GE(inside, std::floor(0.99 * count)) << name;
    EXPECT_LT(std::abs(sum) / count, 3.5 * std::sqrt(square) / count) << name;
    // Not because the uncertainties are far too large.
    EXPECT_GT(std::sqrt(square / count), 0.4) << name;
  }
}

/// Without noise and play nothing of it is left.
TEST(CircleEvaluation, TakesCyclicErrorsBackExactly) {
  CircleMachine machine;
  machine.errors.radius = 50.0;
  machine.errors.centre = {100.0, -40.0};
  machine.errors.pitches = {10.0, 12.0};
  machine.amplitude = {0.002, 0.001};
  machine.phase = {0.5, -2.0};
  const CircleEvaluation circle =
      evaluated(recorded_circle(machine, 20000), {50.0, {}, 0.0, machine.errors.pitches});
  EXPECT_NEAR(circle.fit.errors.cyclic[0].sine, 0.002 * std::cos(0.5), 1e-9);
  EXPECT_NEAR(circle.fit.errors.cyclic[0].cosine, 0.002 * std::sin(0.5), 1e-9);
  EXPECT_NEAR(circle.fit.errors.cyclic[1].sine, 0.001 * std::cos(-2.0), 1e-9);
  EXPECT_NEAR(circle.fit.errors.cyclic[1].cosine, 0.001 * std::sin(-2.0), 1e-9);
  EXPECT_LT(circle.fit.noise, 1e-9);
  // Without the pitch the wavering is noise: of both axes sqrt((2 um)^2 + (1 um)^2) / 2, less what
  // passes for other errors.
  const CircleEvaluation plain = evaluated(recorded_circle(machine, 20000), {50.0, {}, 0.0});
  EXPECT_GT(plain.fit.noise, 0.7 * 0.5e-3 * std::sqrt(5.0));
  EXPECT_LT(plain.fit.noise, 0.5e-3 * std::sqrt(5.0));
}

TEST(CircleEvaluation, OfACircleWithoutErrorsIsZero) {
  CircleMachine machine;
  machine.errors.radius = 50.0;
  machine.errors.centre = {100.0, -40.0};
  for (const std::optional<double> radius : {std::optional(50.0), std::optional<double>()}) {
    const CircleEvaluation circle = evaluated(recorded_circle(machine), {radius, {}, 0.0});
    for (const auto& [name, value] : named(circle.fit.errors)) {
      const double truth = name == "centre X" ? 100.0 : name == "centre Y" ? -40.0 : 0.0;
      EXPECT_NEAR(value, truth, 1e-12) << name;
    }
    EXPECT_NEAR(circle.fit.errors.radius, 50.0, 1e-12);
    EXPECT_LT(circle.radial_error.width(), 1e-12);
    EXPECT_LT(circle.spike[0].value(), 1e-12);
    EXPECT_LT(circle.spike[1].value(), 1e-12);
  }
}

TEST(CircleEvaluation, WithoutARadiusKnowsTheDifferenceOfTheScales) {
  CircleMachine machine;
  machine.errors.radius = 50.0;
  machine.errors.scale = {30e-6, -10e-6};
  const CircleEvaluation circle = evaluated(recorded_circle(machine), {});
  // The mean of the scales makes the circle larger; their difference, 40, is halved up and down.
  EXPECT_NEAR(circle.fit.errors.radius, 50.0 * (1.0 + 10e-6), 1e-7);
  EXPECT_NEAR(circle.fit.errors.scale[0], 20e-6, 1e-9);
  EXPECT_NEAR(circle.fit.errors.scale[1], -20e-6, 1e-9);
}

TEST(CircleEvaluation, OfOneDirectionLeavesTheMismatchInTheSquareness) {
  CircleMachine machine;
  machine.errors.radius = 50.0;
  machine.errors.mismatch = 0.5e-3;
  testing::CircleRecord record = recorded_circle(machine);
  for (auto* values : {&record.t, &record.x, &record.y}) {
    values->resize(values->size() / 2);
  }
  const CircleEvaluation circle = evaluated(record, {50.0, {}, 0.0});
  EXPECT_FALSE(circle.fit.has_mismatch);
  EXPECT_FALSE(circle.cw.has_value());
  // Delta r = v tau sin cos beside R beta sin cos: beta = omega tau.
  EXPECT_NEAR(circle.fit.errors.squareness, machine.feed_mm_s / 50.0 * 0.5e-3, 1e-9);
}

TEST(CircleEvaluation, FindsTheCircleBetweenTheWaysToItAndFromIt) {
  CircleMachine machine;
  machine.errors.radius = 30.0;
  machine.errors.centre = {10.0, 20.0};
  const testing::CircleRecord circle = recorded_circle(machine);
  testing::CircleRecord record;
  const auto add = [&](double x, double y) {
    record.t.push_back(0.001 * static_cast<double>(record.t.size()));
    record.x.push_back(x);
    record.y.push_back(y);
  };
  for (int i = 0; i < 1000; ++i) {
    add(10.0 + 0.03 * i, 20.0);  // from the centre
  }
  for (int i = 0; i < 3000; ++i) {
    add(40.0, 20.0);  // standstill
  }
  for (std::size_t i = 0; i < circle.x.size(); ++i) {
    add(circle.x[i], circle.y[i]);
  }
  for (int i = 0; i < 1000; ++i) {
    add(40.0 - 0.07 * i, 20.0 + 0.01 * i);
  }
  record.x[5200] += 5.0;  // one wild sample
  const CircleEvaluation found = evaluated(record, {30.0, {}, 0.0});
  EXPECT_NEAR(found.fit.errors.centre.x(), 10.0, 1e-9);
  EXPECT_LT(found.radial_error.width(), 1e-9);
}

TEST(CircleEvaluation, FindsASpikeAndNoPlayInIt) {
  CircleMachine machine;
  machine.errors.radius = 50.0;
  testing::CircleRecord record = recorded_circle(machine, 20000);
  // Behind the reversal of Y at 90 degrees: as friction makes it, 10 um at its highest.
  for (std::size_t i = 0; i < record.x.size(); ++i) {
    const double angle = std::atan2(record.y[i], record.x[i]) - 0.5 * std::numbers::pi;
    const double since = i <= 20000 ? angle : -angle;
    if (since > 0.0 && since < 0.6) {
      record.y[i] += 0.010 * (since / 0.03) * std::exp(1.0 - since / 0.03);
    }
  }
  const CircleEvaluation circle = evaluated(record, {50.0, {}, 0.0});
  EXPECT_NEAR(*circle.spike[1], 0.010, 1e-5);
  EXPECT_NEAR(*circle.spike[0], 0.0, 1e-5);
  EXPECT_NEAR(circle.fit.errors.backlash[1], 0.0, 2e-5);
  // The spike takes the centre of least squares with it: by 1/pi times the integral of what it adds
  // to the radius, times the sine of the angle.
  double pull = 0.0;
  constexpr int kSteps = 100'000;
  for (int i = 0; i < kSteps; ++i) {
    const double u = 0.6 * (i + 0.5) / kSteps;
    pull += 0.6 / kSteps * 0.010 * (u / 0.03) * std::exp(1.0 - u / 0.03) * std::pow(std::cos(u), 2);
  }
  pull /= std::numbers::pi;
  EXPECT_GT(pull, 2e-4);
  EXPECT_NEAR(circle.reference.centre.y(), pull, 1e-6);
  EXPECT_NEAR(circle.radial_error.greatest, 0.010 - pull, 2e-5);
  const CircleEvaluation about = evaluated(record, {50.0, Eigen::Vector2d::Zero(), 0.0});
  EXPECT_NEAR(about.radial_error.greatest, 0.010, 2e-5);
}

/// Lobes leave the centre of least squares alone, wherever the reversals are: the range is twice
/// their amplitude.  Half of the samples run four times as slowly and count for no more.  A
/// thousandth of a radian at either end does not count at all (`circle_turns`): 3 nm.
TEST(CircleEvaluation, CountsRadialErrorsFromTheCentreOfLeastSquares) {
  constexpr double kLobe = 0.003;
  constexpr std::size_t kSamples = 50'000;
  for (const int order : {2, 3, 5, 9}) {
    testing::CircleRecord record;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const double share = static_cast<double>(i) / (kSamples - 1);
      const double part = share < 0.8 ? share / 1.6 : 0.5 + (share - 0.8) / 0.4;
      const double theta = 2.0 * std::numbers::pi * part;
      const double radius = 50.0 + kLobe * std::cos(order * theta + 0.7);
      record.t.push_back(1e-3 * static_cast<double>(i));
      record.x.push_back(7.0 + radius * std::cos(theta));
      record.y.push_back(-2.0 + radius * std::sin(theta));
    }
    const CircleEvaluation circle = evaluated(record, {50.0, {}, 0.0});
    EXPECT_NEAR(circle.reference.centre.x(), 7.0, 1e-5) << order;
    EXPECT_NEAR(circle.reference.centre.y(), -2.0, 1e-5) << order;
    EXPECT_NEAR(circle.radial_error.width(), 2.0 * kLobe, 1e-5) << order;
  }
}

/// Of half a circle there and back the centre of least squares would go with its form, here by a
/// third of an ellipse's error: the model knows better.
TEST(CircleEvaluation, CountsRadialErrorsOfAnArcFromTheCentreOfTheModel) {
  constexpr double kScale = 100e-6;
  constexpr int kHalf = 20'000;
  testing::CircleRecord record;
  for (int i = 0; i < 2 * kHalf; ++i) {
    const double part = static_cast<double>(i < kHalf ? i : 2 * kHalf - 1 - i) / (kHalf - 1);
    const double theta = std::numbers::pi * part;
    record.t.push_back(1e-3 * i);
    record.x.push_back(3.0 + 50.0 * (1.0 + kScale) * std::cos(theta));
    record.y.push_back(4.0 + 50.0 * (1.0 - kScale) * std::sin(theta));
  }
  const CircleEvaluation arc = evaluated(record, {50.0, {}, 0.0});
  EXPECT_NEAR(arc.fit.errors.scale[0], kScale, 1e-6);
  EXPECT_NEAR(arc.reference.centre.y(), 4.0, 1e-5);
  EXPECT_NEAR(arc.radial_error.width(), 2.0 * 50.0 * kScale, 2e-5);
}

TEST(CircleEvaluation, RefusesWhatIsNoCircle) {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;
  const auto wrong = [&] {
    const auto made = metrology::evaluate_circle({t, x, y}, {});
    return made.ok() ? std::string() : made.error();
  };
  EXPECT_EQ(wrong(), "the path is not a circle");
  for (int i = 0; i < 500; ++i) {
    t.push_back(i);
    x.push_back(0.1 * i);
    y.push_back(0.2 * i);
  }
  EXPECT_EQ(wrong(), "the path is not a circle");
  for (int i = 0; i < 500; ++i) {
    x[static_cast<std::size_t>(i)] = 10.0 * std::cos(0.004 * i);
    y[static_cast<std::size_t>(i)] = 10.0 * std::sin(0.004 * i);
  }
  EXPECT_EQ(wrong(), "less than half a circle was recorded");
  std::fill(x.begin(), x.end(), 1.0);
  std::fill(y.begin(), y.end(), 1.0);
  EXPECT_EQ(wrong(), "the path is not a circle");
}

}  // namespace
}  // namespace g31::circle_evaluation_test
