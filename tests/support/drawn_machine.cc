#include "tests/support/drawn_machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/random.h"

namespace g31::testing {
namespace {

/// One number after the other.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint32_t what) : stream_{seed, what} {}
  double between(double low, double high) { return low + (high - low) * uniform(stream_, next_++); }

 private:
  Stream stream_;
  std::uint64_t next_ = 0;
};

using Pairs = std::vector<std::pair<double, double>>;

std::string written(const Pairs& pairs) {
  std::vector<std::string> all;
  for (const auto& [place, error] : pairs) {
    all.push_back(fmt::format("[{:.17g}, {:.17g}]", place, error));
  }
  return fmt::format("[{}]", fmt::join(all, ", "));
}

/// A bow, an S and two waves, with the line of least squares taken off, and then a slope.
Pairs bent_way(Draw& draw, const DrawnMachine& machine, double middle, double slope) {
  constexpr int kHalf = 20;
  std::vector<double> bends;
  const std::array<double, 4> share = {draw.between(-1.0, 1.0), draw.between(-1.0, 1.0),
                                       draw.between(-1.0, 1.0), draw.between(-1.0, 1.0)};
  const double phase = draw.between(0.0, 2.0 * std::numbers::pi);
  double mean = 0.0;
  double product = 0.0;
  double square = 0.0;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double u = static_cast<double>(i) / kHalf;
    bends.push_back(share[0] * u * u + share[1] * u * u * u + share[2] * std::sin(3.0 * u + phase) +
                    share[3] * std::sin(5.0 * u + 2.0 * phase));
    mean += bends.back() / (2 * kHalf + 1);
    product += u * bends.back();
    square += u * u;
  }
  double largest = 0.0;
  for (int i = -kHalf; i <= kHalf; ++i) {
    double& bend = bends[static_cast<std::size_t>(i + kHalf)];
    bend -= mean + product / square * static_cast<double>(i) / kHalf;
    largest = std::max(largest, std::abs(bend));
  }
  Pairs pairs;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double along = machine.radius * static_cast<double>(i) / kHalf;
    pairs.emplace_back(
        middle + along,
        machine.form * bends[static_cast<std::size_t>(i + kHalf)] / largest + slope * along);
  }
  // Behind the circle, where the play takes the axes, the slope goes on.
  pairs.insert(pairs.begin(), {pairs.front().first - 1.0, pairs.front().second - slope});
  pairs.emplace_back(pairs.back().first + 1.0, pairs.back().second + slope);
  return pairs;
}

constexpr double kMicro = 1e6;
constexpr int kBenchSteps = 20;

std::vector<double> wavering(Draw& draw, std::size_t count, double most) {
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back(draw.between(-most, most));
  }
  return places;
}

Pairs by_steps(const std::vector<double>& errors) {
  Pairs pairs;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    pairs.emplace_back(kBenchStep * static_cast<double>(i), errors[i]);
  }
  return pairs;
}

}  // namespace

DrawnMachine drawn_machine(std::uint64_t seed) {
  Draw draw(seed, 1);
  DrawnMachine machine;
  machine.seed = seed;
  machine.radius = std::round(draw.between(15.0, 100.0) * 1e3) / 1e3;
  machine.feed_mm_s = std::round(draw.between(500.0, 4000.0)) / 60.0;
  for (const std::size_t axis : {0U, 1U}) {
    machine.centre.at(axis) = std::round(draw.between(-200.0, 200.0) * 1e3) / 1e3;
    machine.backlash.at(axis) = draw.between(0.0, 0.02);
    machine.scale.at(axis) = draw.between(-1e-4, 1e-4);
  }
  const double lag_s = draw.between(0.02, 0.05);
  const double apart_s = draw.between(-1e-3, 1e-3);
  machine.lag_s = {lag_s + 0.5 * apart_s, lag_s - 0.5 * apart_s};
  machine.c0y = draw.between(-1e-4, 1e-4);
  machine.form = draw.between(0.0, 0.003);
  return machine;
}

std::string sheet_of(const DrawnMachine& machine) {
  Draw draw(machine.seed, 2);
  const auto& [x, y] = machine.centre;
  std::string sheet = fmt::format("[start]\nX = {}\nY = {}\n", x, y);
  for (const std::size_t axis : {0U, 1U}) {
    sheet += fmt::format("[machine.axes.{}]\nbacklash = {:.17g}\nservo_gain = {:.17g}\n",
                         "XY"[axis], machine.backlash.at(axis), 0.06 / machine.lag_s.at(axis));
  }
  sheet += fmt::format("[machine.errors]\nC0Y = {:.17g}\n", kMicro * machine.c0y);
  sheet += "EXX = " + written(bent_way(draw, machine, x, machine.scale[0])) + "\n";
  sheet += "EYY = " + written(bent_way(draw, machine, y, machine.scale[1])) + "\n";
  sheet += "EYX = " + written(bent_way(draw, machine, x, 0.0)) + "\n";
  sheet += "EXY = " + written(bent_way(draw, machine, y, 0.0)) + "\n";
  return sheet;
}

std::string circle_of(const DrawnMachine& machine) {
  return fmt::format(
      "%\nO1\nG90 G17 G21 G94\nG0 X{0:.3f} Y{1:.3f}\nG4 P300\nG3 I-{2:.3f} J0. F{3:.3f}\nG4 P300\n"
      "G2 I-{2:.3f} J0.\nG4 P300\nM30\n%\n",
      machine.centre[0] + machine.radius, machine.centre[1], machine.radius,
      60.0 * machine.feed_mm_s);
}

std::vector<NamedTruth> circle_truth(const DrawnMachine& machine) {
  const double omega = machine.feed_mm_s / machine.radius;
  // A first-order lag takes 1 / sqrt(1 + (omega T)^2) of the radius and turns by atan(omega T).
  const auto taken = [&](std::size_t axis) {
    return (1.0 + machine.scale.at(axis)) / std::hypot(1.0, omega * machine.lag_s.at(axis)) - 1.0;
  };
  const double mismatch_s =
      (std::atan(omega * machine.lag_s[0]) - std::atan(omega * machine.lag_s[1])) / omega;
  return {{"backlash_X", 1e3 * machine.backlash[0]},
          {"backlash_Y", 1e3 * machine.backlash[1]},
          {"scale_X", kMicro * taken(0)},
          {"scale_Y", kMicro * taken(1)},
          // C0Y is by the way that the scale of Y reads.
          {"squareness", -kMicro * machine.c0y / (1.0 + machine.scale[1])},
          {"servo_mismatch", 1e3 * mismatch_s}};
}

DrawnBench drawn_bench(std::uint64_t seed) {
  Draw draw(seed, 3);
  DrawnBench bench;
  bench.motion = wavering(draw, kBenchSteps + 1, 0.02);
  bench.bed = wavering(draw, kBenchSteps + 2, 0.03);
  bench.tip = draw.between(-0.005, 0.005);
  bench.noise = draw.between(0.0002, 0.001);
  return bench;
}

std::string sheet_of(const DrawnBench& bench) {
  const auto sensor = [&](char name, double x, double z) {
    return fmt::format(
        "[[sensor]]\nname = \"{}\"\nat = [{}, 0.0, {:.17g}]\nrange = 20.0\nnoise = {:.17g}\n", name,
        x, z, bench.noise);
  };
  return "[control]\nprofile = \"sinumerik-828d\"\n[variables]\nR1 = " +
         fmt::format("{}\nR2 = {}\n", kBenchStep, kBenchSteps) +
         "[start]\nX = 0.0\nY = 0.0\nZ = 110.0\n[machine.errors]\nEZX = " +
         written(by_steps(bench.motion)) +
         "\n[[part]]\nname = \"bed\"\nshape = \"bed\"\nwidth = 200.0\nheight = 300.0\nlength = " +
         fmt::format("{}\nprofile = ", kBenchStep * (kBenchSteps + 1)) +
         written(by_steps(bench.bed)) + "\n" + sensor('A', 0.0, -100.0) +
         // A sensor that stands lower is nearer, which a distance shows with the other sign.
         sensor('B', kBenchStep, -100.0 - bench.tip);
}

}  // namespace g31::testing
