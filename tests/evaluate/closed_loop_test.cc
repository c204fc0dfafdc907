// Machines drawn by chance run through the simulator, and what is evaluated is what was put in:
// every estimate within three of its own standard uncertainties, and none with a bias.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "probe/metrology/two_point.h"
#include "tests/support/drawn_machine.h"
#include "tests/support/effort.h"
#include "tests/support/run_evaluate.h"

namespace g31::closed_loop_test {
namespace {

using evaluate::OptionId;
using testing::EvaluateOutput;
using testing::run_evaluate;
using testing::TemporaryFolder;

/// How far estimates are from the truth, and how far they say that they may be.
class Tally {
 public:
  void add(const std::string& name, double off, double u) {
    offs_[name].push_back(off);
    ++all_;
    inside_ += std::abs(off) <= 3.0 * u ? 1 : 0;
  }

  /// 99 of 100 inside, and each mean within 3.5 of its own standard deviations of 0, which chance
  /// exceeds once in 2,000 times.
  void check() const {
    EXPECT_GE(inside_, 0.99 * all_) << inside_ << " of " << all_;
    for (const auto& [name, offs] : offs_) {
      double sum = 0.0;
      double square = 0.0;
      for (const double off : offs) {
        sum += off;
        square += off * off;
      }
      const double count = static_cast<double>(offs.size());
      const double mean = sum / count;
      const double deviation = std::sqrt((square - count * mean * mean) / (count - 1.0));
      EXPECT_LE(std::abs(mean), 3.5 * deviation / std::sqrt(count)) << name;
    }
  }

 private:
  std::map<std::string, std::vector<double>> offs_;
  double all_ = 0.0;
  double inside_ = 0.0;
};

EvaluateOutput evaluated_circle(const testing::DrawnMachine& machine) {
  const TemporaryFolder folder;
  cli::RunOptions run;
  run.programs = {folder.write("circle.nc", circle_of(machine))};
  run.setups = {folder.write("machine.toml", sheet_of(machine))};
  run.trace = folder.path("trace.csv");
  EXPECT_EQ(testing::run_program(run).exit_code, 0);
  cli::EvaluateOptions options;
  options.kind = "circle";
  options.file = run.trace;
  options.given[OptionId::Radius] = std::to_string(machine.radius);
  return run_evaluate(options);
}

TEST(ClosedLoop, CirclesOfTwoHundredMachinesShowTheirErrors) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= testing::of_many(200); ++seed) {
    const testing::DrawnMachine machine = testing::drawn_machine(seed);
    const EvaluateOutput output = evaluated_circle(machine);
    ASSERT_EQ(output.exit_code, 0) << seed << ": " << output.errors;
    for (const auto& [name, truth] : circle_truth(machine)) {
      tally.add(name, output.value(name) - truth, output.u(name));
    }
  }
  tally.check();
}

/// Nothing but the steps of the record is uncertain on straight ways, and what slow loops leave of
/// the start of the motion behind its first 0.3 s.
TEST(ClosedLoop, OnStraightWaysTheErrorsComeBack) {
  for (std::uint64_t seed = 1; seed <= testing::of_many(20); ++seed) {
    testing::DrawnMachine machine = testing::drawn_machine(seed);
    machine.form = 0.0;
    const EvaluateOutput output = evaluated_circle(machine);
    ASSERT_EQ(output.exit_code, 0) << seed << ": " << output.errors;
    for (const auto& [name, truth] : circle_truth(machine)) {
      EXPECT_LE(std::abs(output.value(name) - truth), 3.0 * output.u(name)) << name << " " << seed;
    }
    EXPECT_LE(output.u("squareness"), 5.0) << "um/m, of " << seed;
  }
}

/// Both ends of the motion are 0, so its line is in the work.
TEST(ClosedLoop, StraightnessOfTwoHundredBenchesIsToldFromTheirBeds) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= testing::of_many(200); ++seed) {
    const testing::DrawnBench bench = testing::drawn_bench(seed);
    const TemporaryFolder folder;
    cli::RunOptions run;
    run.programs = {"parts/library/straightness/step.mpf"};
    run.setups = {folder.write("bench.toml", sheet_of(bench))};
    run.readings = folder.path("bench.csv");
    run.seed = seed;
    ASSERT_EQ(testing::run_program(run).exit_code, 0) << seed;
    cli::EvaluateOptions options;
    options.kind = "straightness";
    options.file = run.readings;
    options.has_curves = true;
    options.given[OptionId::Step] = std::to_string(testing::kBenchStep);
    options.given[OptionId::Sense] = "gap";
    options.given[OptionId::Uncertainty] = std::to_string(bench.noise);
    const EvaluateOutput output = run_evaluate(options);
    ASSERT_EQ(output.exit_code, 0) << seed << ": " << output.errors;
    const std::size_t n = bench.motion.size() - 1;
    const double rise = (bench.motion[n] - bench.motion[0]) / static_cast<double>(n);
    tally.add("delta", output.value("delta") - 1e3 * (bench.tip + rise), output.u("delta"));
    const auto work_at = [&](std::size_t k) {
      return bench.bed[k] - bench.bed[0] - rise * static_cast<double>(k);
    };
    tally.add("parallelism", output.value("parallelism") - 1e3 * work_at(n),
              output.u("parallelism"));
    const auto& curves = output.document.at("curves");
    for (const std::size_t k : {n / 4, n / 2, 3 * n / 4}) {
      const double motion = bench.motion[k] - bench.motion[0] - rise * static_cast<double>(k);
      tally.add("motion", curves.at("motion").at(k).at(1).get<double>() - motion,
                bench.noise * metrology::motion_uncertainty(k, n));
      tally.add("work", curves.at("work").at(k).at(1).get<double>() - work_at(k),
                bench.noise * metrology::work_uncertainty(k, n));
    }
  }
  tally.check();
}

}  // namespace
}  // namespace g31::closed_loop_test
