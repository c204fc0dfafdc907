// The studies of parts/library/acceptance find what their sheets put in.

#include <cmath>
#include <iterator>
#include <ostream>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/run_study.h"

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

}  // namespace
}  // namespace g31::acceptance_bench_test
