// Three sensors over the bed of parts/library/straightness: what their tips stand out by checks
// itself.  Two along the shaft of parts/library/cylindricity.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"

namespace g31::three_sensors_test {
namespace {

using evaluate::OptionId;
using testing::TemporaryFolder;

constexpr double kFirstUm = 2.57;
constexpr double kSecondUm = 1.04;
constexpr double kNoiseUm = 1.0;
constexpr double kSteps = 50.0;

nlohmann::json results_with(std::uint64_t seed, double noise_mm) {
  const TemporaryFolder folder;
  std::string noise;
  for (const char* const sensor :
       {"A\"\nat = [0.0, 0.0, -100.0]", "B\"\nat = [100.0, 0.0, -100.00257]",
        "C\"\nat = [200.0, 0.0, -100.00361]"}) {
    noise += "[[sensor]]\nrange = 20.0\nname = \"" + std::string(sensor) +
             "\nnoise = " + std::to_string(noise_mm) + "\n";
  }
  const std::string library = "parts/library/straightness/";
  cli::RunOptions run;
  run.programs = {library + "step.mpf"};
  run.setups = {library + "bed.toml", library + "sinumerik.toml",
                noise_mm == kNoiseUm * 1e-3 ? library + "three_sensors.toml"
                                            : folder.write("sensors.toml", noise)};
  run.readings = folder.path("bed.csv");
  run.seed = seed;
  EXPECT_EQ(testing::run_program(run).exit_code, 0);
  cli::EvaluateOptions options;
  options.kind = "straightness";
  options.given[OptionId::Step] = "100";
  options.given[OptionId::Sense] = "gap";
  const auto output = testing::evaluate_text(testing::text_of(run.readings), options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  return output.document["results"];
}

double value_of(const nlohmann::json& results, const char* name) {
  return results[name]["value"].get<double>();
}

TEST(ThreeSensors, CloseWithoutNoise) {
  const auto results = results_with(0, 0.0);
  EXPECT_NEAR(value_of(results, "delta_1"), kFirstUm, 1e-6);
  EXPECT_NEAR(value_of(results, "delta_2"), kSecondUm, 1e-6);
  EXPECT_NEAR(value_of(results, "delta"), kFirstUm + kSecondUm, 1e-6);
  EXPECT_NEAR(value_of(results, "delta_closure"), 0.0, 1e-6);
  EXPECT_NEAR(value_of(results, "motion_straightness"), 31.0, 1e-6);
}

/// A slope is the mean of the differences of N pairs of readings, N / 2 over double steps.  The
/// paper's 2.57 + 1.04 against 3.81 is off by as much.
TEST(ThreeSensors, ScatterAsTheirReadingsDo) {
  const double single = kNoiseUm * std::sqrt(2.0 / kSteps);
  const double twice = kNoiseUm * std::sqrt(2.0 / (kSteps / 2.0));
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto results = results_with(seed, kNoiseUm * 1e-3);
    EXPECT_NEAR(value_of(results, "delta_1"), kFirstUm, 4.0 * single);
    EXPECT_NEAR(value_of(results, "delta_2"), kSecondUm, 4.0 * single);
    EXPECT_NEAR(value_of(results, "delta"), kFirstUm + kSecondUm, 4.0 * twice);
    EXPECT_NEAR(value_of(results, "delta_closure"), 0.0, 4.0 * (single + twice));
    EXPECT_NE(value_of(results, "delta_closure"), 0.0);
  }
}

/// The profile at places 10, 60, .. 310 reaches from 2.5 um inside, at 210, to 3.3 um outside, at
/// 110; facets stand off by 0.05 um at most.  Neither the slide's 14 um nor the 11 um that the
/// shaft is off the axis enter, nor what B reads more than A.
TEST(Shaft, IsToldFromTheMotionAlongIt) {
  const TemporaryFolder folder;
  const std::string library = "parts/library/cylindricity/";
  for (const char* const program : {"turn.nc", "turn.mpf"}) {
    cli::RunOptions run;
    run.programs = {library + program};
    run.setups = {library + "shaft.toml"};
    run.readings = folder.path("shaft.csv");
    EXPECT_EQ(testing::run_program(run).exit_code, 0);
    cli::EvaluateOptions options;
    options.kind = "cylindricity";
    options.given[OptionId::Step] = "50";
    options.given[OptionId::Sense] = "gap";
    options.given[OptionId::Diameters] = library + "diameters.csv";
    const auto output = testing::evaluate_text(testing::text_of(run.readings), options);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const auto& results = output.document["results"];
    EXPECT_NEAR(value_of(results, "cylindricity_minimum_zone"), 5.8, 0.05) << program;
    EXPECT_NEAR(value_of(results, "cylindricity_least_squares"), 5.8, 0.05) << program;
    EXPECT_NEAR(value_of(results, "radius"), 30.0 + 0.00076, 1e-4) << program;
  }
}

}  // namespace
}  // namespace g31::three_sensors_test
