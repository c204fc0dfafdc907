// What stands beside drawings: results to the digits that they are known to, names of curves.

#include "tools/evaluate/charts.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace g31::evaluate::charts_test {
namespace {

Quantity quantity(const char* unit, double value, std::optional<double> u) {
  Quantity made;
  made.name = "q";
  made.unit = unit;
  made.value = value;
  made.u = u;
  return made;
}

TEST(Charts, ShowResultsToTheSecondDigitOfTheirUncertainty) {
  struct Case {
    Quantity quantity;
    const char* fact;
  };
  const Case kCases[] = {{quantity("mm", -0.00047782034, 0.0007), "q -0.00048 mm (u 0.0007)"},
                         {quantity("mm", -1.6917164e-06, 0.00048), "q 0 mm (u 0.00048)"},
                         {quantity("mm", 4.7498664e-08, 8.4e-08), "q 0.000000047 mm (u 8.4e-08)"},
                         {quantity("mm", 49.985237, std::nullopt), "q 49.985237 mm"},
                         {quantity("um", -3.99123, 0.28), "q -3.99 µm (u 0.28)"},
                         {quantity("um/m", 85.687, 22.0), "q 85.69 µm/m (u 22)"},
                         {quantity("um", 10.1142, std::nullopt), "q 10.11 µm"}};
  for (const Case& c : kCases) {
    Evaluation evaluation;
    evaluation.results = {c.quantity};
    EXPECT_EQ(facts_of(evaluation), std::vector<std::string>{c.fact});
  }
}

// Four colours: a second four are dashed, more have no name.
TEST(Charts, NameTheCurvesThatCanBeToldApart) {
  std::vector<Curve> curves(10);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    curves[i].name = std::to_string(i);
  }
  const auto traces = deviation_traces(curves, {});
  ASSERT_EQ(traces.size(), curves.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    EXPECT_EQ(traces[i].name, i < 8 ? std::to_string(i) : std::string());
    EXPECT_EQ(traces[i].colour, i % 4);
    EXPECT_EQ(traces[i].style,
              i >= 4 && i < 8 ? plot::CurveStyle::Dashed : plot::CurveStyle::Marked);
  }
}

}  // namespace
}  // namespace g31::evaluate::charts_test
