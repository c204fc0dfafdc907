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

// Four colours: a second four are dashed, more have no name; points of all are marked.
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
              i >= 4 && i < 8 ? plot::CurveStyle::DashedMarked : plot::CurveStyle::Marked);
  }
}

TEST(Charts, NameALineByItsPlaceToAMicrometre) {
  const auto traces = deviation_traces({{"y_3.96452875838653", {}}, {"y_-0.0001", {}}}, {});
  EXPECT_EQ(traces[0].name, "y = 3.965 mm");
  EXPECT_EQ(traces[1].name, "y = 0 mm");
}

TEST(Evaluation, IsLedByWhatAnswersIt) {
  struct Case {
    Kind kind;
    std::vector<Quantity> results;
    std::vector<std::string> leads;
  };
  const Case kCases[] = {
      {Kind::Square,
       {{"corner_error_1", -3.0, "um"}, {"corner_error_max", -3.0, "um"}, {"side", 40.0, "mm"}},
       {"corner_error_max"}},
      {Kind::Diagonal,
       {{"error_X", 1.0, "um"}, {"error_Y", -2.0, "um"}, {"error_Y_on", -9.0, "um"}},
       {"error_Y"}},
      {Kind::Straightness,
       {{"delta", 7.0, "um"}, {"motion_straightness", 2.0, "um"}, {"work_straightness", 3.0, "um"}},
       {"motion_straightness", "work_straightness"}},
      {Kind::Circle,
       {{"radial_error_max", 1.0, "um"}, {"circular_error", std::nullopt, "um"}},
       {"radial_error_max"}},
      {Kind::Flatness, {}, {}},
  };
  for (const Case& c : kCases) {
    Evaluation evaluation;
    evaluation.kind = c.kind;
    evaluation.results = c.results;
    std::vector<std::string> names;
    for (const Quantity* const quantity : leading(evaluation)) {
      names.push_back(quantity->name);
    }
    EXPECT_EQ(names, c.leads) << info(c.kind).word;
  }
}

}  // namespace
}  // namespace g31::evaluate::charts_test
