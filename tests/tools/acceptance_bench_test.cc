// The studies of parts/library/acceptance find what their sheets put in.

#include <cmath>
#include <iterator>
#include <ostream>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/run_program.h"
#include "tests/support/run_study.h"
#include "tests/support/temporary_folder.h"

namespace g31::acceptance_bench_test {
namespace {

struct Bench {
  const char* study;
  double facets_mm;  ///< what the facets of its part may take, or a program that rounds to 1e-6 mm
};

/// What ctest shows of it.
void PrintTo(const Bench& bench, std::ostream* out) {
  *out << bench.study;
}

class AcceptanceBench : public ::testing::TestWithParam<Bench> {};

TEST_P(AcceptanceBench, FindsWhatIsPutIn) {
  cli::StudyOptions options;
  options.study = std::string("parts/library/acceptance/") + GetParam().study + ".toml";
  const testing::StudyOutput output = testing::study_document(options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const auto document = nlohmann::json::parse(output.out);
  int checked = 0;
  for (const auto& [name, result] : document["points"][0]["results"].items()) {
    const double n = result["n"].get<double>();
    const double scatter =
        n > 1.0 ? result["standard_deviation"].get<double>() / std::sqrt(n) : 0.0;
    EXPECT_NEAR(result["bias"].get<double>(), 0.0, 4.0 * scatter + GetParam().facets_mm) << name;
    ++checked;
  }
  EXPECT_GE(checked, 2);
}

// The quick ones come first.
constexpr Bench kBenches[] = {{"location", 0.0},
                              {"tip_offset", 0.0},
                              {"ring_2d", 2e-6},
                              {"sphere_3d", 2e-6},
                              {"repeatability", 0.0}};
INSTANTIATE_TEST_SUITE_P(
    Studies, AcceptanceBench,
    ::testing::ValuesIn(std::span(kBenches).first(testing::of_many(std::size(kBenches)))),
    [](const auto& named) { return std::string(named.param.study); });

/// The parts lie elsewhere, so nothing is measured, whatever the programs make of the ends of their
/// moves: the least, the greatest, sums that are compared with 0.
TEST(AcceptanceBench, MeasuresNothingWithoutAPart) {
  const char* const kJobs[][2] = {
      {"parts/library/acceptance/repeatability.nc", "parts/library/acceptance/bench.toml"},
      {"parts/library/acceptance/ring_2d.nc", "parts/library/acceptance/bench.toml"},
      {"parts/library/acceptance/sphere_3d.nc", "parts/library/acceptance/bench.toml"}};
  testing::TemporaryFolder folder;
  const std::string elsewhere =
      folder.write("elsewhere.toml", "[[part]]\nshape = \"block\"\nat = [9000.0, 0.0, 0.0]\n");
  for (const auto& [program, sheet] : kJobs) {
    cli::RunOptions options;
    options.programs = {program};
    options.setups = {sheet, elsewhere};
    const testing::RunOutput output = testing::run_program(options);
    EXPECT_EQ(output.exit_code, 1) << program;
    EXPECT_NE(output.errors.find("[PRB301]"), std::string::npos) << program << output.errors;
  }
}

}  // namespace
}  // namespace g31::acceptance_bench_test
