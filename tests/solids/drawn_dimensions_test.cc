// Dimensions of AP242, written into the example's STEP text by hand as ISO 10303-47 and 10303-242
// have them: they become nominal sizes and tolerances of the plan.

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "parts/features/recognise.h"
#include "parts/solids/removal.h"
#include "probe/planning/plan_inspection.h"
#include "tests/support/temporary_folder.h"

namespace g31::drawn_dimensions_test {
namespace {

/// The entities of a STEP text by their numbers.
class StepText {
 public:
  StepText() {
    std::ifstream file("parts/library/inspection/product.step", std::ios::binary);
    text_.assign(std::istreambuf_iterator<char>(file), {});
    const std::regex entity(R"(#(\d+) = ([^;]*);)");
    for (std::sregex_iterator it(text_.begin(), text_.end(), entity), end; it != end; ++it) {
      entities_[std::stoi((*it)[1])] = std::regex_replace((*it)[2].str(), std::regex("\\s+"), "");
    }
  }

  /// The face of a plane across an axis at a place, or of a cylinder of a radius about a place.
  [[nodiscard]] int face(const std::string& surface, const std::string& with) const {
    for (const auto& [number, text] : entities_) {
      std::smatch match;
      static const std::regex kFace(R"(ADVANCED_FACE\('',\(.*\),#(\d+),\.[TF]\.\))");
      if (!std::regex_match(text, match, kFace)) {
        continue;
      }
      const std::string& shape = entities_.at(std::stoi(match[1]));
      static const std::regex kAxis(R"(\w+\('',#(\d+).*\))");
      if (!shape.starts_with(surface) || !std::regex_match(shape, match, kAxis)) {
        continue;
      }
      const std::string& axis = entities_.at(std::stoi(match[1]));
      static const std::regex kPlacement(R"(AXIS2_PLACEMENT_3D\('',#(\d+),#(\d+),.*\))");
      if (std::regex_match(axis, match, kPlacement) &&
          (entities_.at(std::stoi(match[1])) + entities_.at(std::stoi(match[2])) + shape)
                  .find(with) != std::string::npos) {
        return number;
      }
    }
    ADD_FAILURE() << "no " << surface << " with " << with;
    return 0;
  }

  /// With more entities before the end.
  [[nodiscard]] std::string with(const std::string& entities) const {
    std::string text = text_;
    return text.insert(text.rfind("ENDSEC;"), entities);
  }

 private:
  std::string text_;
  std::map<int, std::string> entities_;
};

/// A distance of two faces: shape aspects of the part with their faces, a location between them, a
/// value, limits.
std::string distance(int first_face, int second_face, double value, double lower, double upper) {
  return fmt::format(
      "#1001 = SHAPE_ASPECT('','',#4,.T.);\n#1002 = SHAPE_ASPECT('','',#4,.T.);\n"
      "#1003 = GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1001,#10,#{});\n"
      "#1004 = GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1002,#10,#{});\n"
      "#1005 = DIMENSIONAL_LOCATION('linear distance','',#1001,#1002);\n"
      "#1006 = ( LENGTH_MEASURE_WITH_UNIT() MEASURE_REPRESENTATION_ITEM() "
      "MEASURE_WITH_UNIT(LENGTH_MEASURE({:.3f}),#893) REPRESENTATION_ITEM('nominal value') );\n"
      "#1007 = SHAPE_DIMENSION_REPRESENTATION('',(#1006),#892);\n"
      "#1008 = DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1005,#1007);\n"
      "#1009 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({:.3f}),#893);\n"
      "#1010 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({:.3f}),#893);\n"
      "#1011 = TOLERANCE_VALUE(#1009,#1010);\n#1012 = PLUS_MINUS_TOLERANCE(#1011,#1005);\n",
      first_face, second_face, value, lower, upper);
}

/// A diameter without limits, in inches.
std::string diameter(int face, double value) {
  return fmt::format(
      "#1101 = SHAPE_ASPECT('','',#4,.T.);\n"
      "#1103 = GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1101,#10,#{});\n"
      "#1105 = DIMENSIONAL_SIZE(#1101,'diameter');\n"
      "#1120 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
      "#1121 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#893);\n"
      "#1122 = ( CONVERSION_BASED_UNIT('INCH',#1121) LENGTH_UNIT() NAMED_UNIT(#1120) );\n"
      "#1106 = ( LENGTH_MEASURE_WITH_UNIT() MEASURE_REPRESENTATION_ITEM() "
      "MEASURE_WITH_UNIT(LENGTH_MEASURE({:.15f}),#1122) REPRESENTATION_ITEM('nominal value') );\n"
      "#1107 = SHAPE_DIMENSION_REPRESENTATION('',(#1106),#892);\n"
      "#1108 = DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1105,#1107);\n",
      face, value);
}

TEST(DrawnDimensions, AreNominalSizesAndTolerances) {
  const StepText step;
  const testing::TemporaryFolder folder;
  // The width of the pocket F6, 40 +0.02 -0.01; the diameter of the hole F3, 20 mm in inches.
  const std::string text = step.with(
      distance(step.face("PLANE", "(90.,"), step.face("PLANE", "(130.,"), 40.0, -0.01, 0.02) +
      diameter(step.face("CYLINDRICAL_SURFACE", "(30.,85.,"), 20.0 / 25.4));
  const auto removal = parts::removal_of(folder.write("product.step", text), {});
  ASSERT_TRUE(removal.ok()) << removal.error();
  ASSERT_EQ(removal.value().dimensions.size(), 2U);
  auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
  part.dimensions = removal.value().dimensions;
  probe::PlanningOptions options;
  options.tolerance = probe::Tolerance{-0.5, 0.5};
  const auto plan = probe::plan_inspection(
      part, removal.value().product_P, options,
      [](const probe::PlannedPoint&, double) { return std::optional<std::string>(); });
  int drawn = 0;
  for (const probe::PlannedMeasure& measure : plan.measures) {
    ASSERT_TRUE(measure.tolerance.has_value());
    if (measure.id == "F6.X") {
      ++drawn;
      EXPECT_EQ(measure.nominal, 40.0);
      EXPECT_NEAR(measure.tolerance->lower, -0.01, 1e-12);
      EXPECT_NEAR(measure.tolerance->upper, 0.02, 1e-12);
    } else {
      EXPECT_EQ(measure.tolerance->upper, 0.5) << measure.id;
    }
    if (measure.id == "F3.X" || measure.id == "F3.Y") {
      ++drawn;
      EXPECT_NEAR(measure.nominal, 20.0, 1e-9);
    }
  }
  EXPECT_EQ(drawn, 3);
}

/// A diameter of F3 that applies to a composite of its face, with the values of a representation
/// and what stands beside them.
std::string composite(int face, const std::string& values, const std::string& beside) {
  const auto length = [](int number, double value, const std::string& name) {
    return fmt::format(
        "#{} = ( LENGTH_MEASURE_WITH_UNIT() MEASURE_REPRESENTATION_ITEM() "
        "MEASURE_WITH_UNIT(LENGTH_MEASURE({:.3f}),#893) REPRESENTATION_ITEM('{}') );\n",
        number, value, name);
  };
  return fmt::format(
             "#1200 = COMPOSITE_SHAPE_ASPECT('','',#4,.F.);\n"
             "#1201 = SHAPE_ASPECT('','',#4,.T.);\n"
             "#1202 = SHAPE_ASPECT_RELATIONSHIP('','',#1200,#1201);\n"
             "#1203 = GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1201,#10,#{});\n"
             "#1204 = DIMENSIONAL_SIZE(#1200,'diameter');\n"
             "#1205 = SHAPE_DIMENSION_REPRESENTATION('',({}),#892);\n"
             "#1206 = DIMENSIONAL_CHARACTERISTIC_REPRESENTATION(#1204,#1205);\n",
             face, values) +
         length(1207, 20.0, "nominal value") + length(1208, 20.2, "upper limit") +
         length(1209, 19.9, "lower limit") + beside;
}

TEST(DrawnDimensions, OfCompositesAndWithLimitsAreTaken) {
  const StepText step;
  const testing::TemporaryFolder folder;
  const int face = step.face("CYLINDRICAL_SURFACE", "(30.,85.,");
  const std::string plus_minus =
      "#1210 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(-0.1),#893);\n"
      "#1211 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.2),#893);\n"
      "#1212 = TOLERANCE_VALUE(#1210,#1211);\n#1213 = PLUS_MINUS_TOLERANCE(#1212,#1204);\n";
  struct Case {
    const char* what;
    std::string text;
    double nominal;
    double lower;
    double upper;
  };
  const Case kCases[] = {
      {"plus-minus", composite(face, "#1207", plus_minus), 20.0, -0.1, 0.2},
      {"limits", composite(face, "#1207,#1208,#1209", ""), 20.0, -0.1, 0.2},
      {"limits alone", composite(face, "#1208,#1209", ""), 20.05, -0.15, 0.15},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    const auto removal = parts::removal_of(folder.write("product.step", step.with(c.text)), {});
    ASSERT_TRUE(removal.ok()) << removal.error();
    ASSERT_EQ(removal.value().dimensions.size(), 1U);
    const parts::DrawnDimension& dimension = removal.value().dimensions.front();
    EXPECT_EQ(dimension.faces.size(), 1U);
    EXPECT_NEAR(dimension.nominal_mm, c.nominal, 1e-12);
    ASSERT_TRUE(dimension.lower_mm && dimension.upper_mm);
    EXPECT_NEAR(*dimension.lower_mm, c.lower, 1e-12);
    EXPECT_NEAR(*dimension.upper_mm, c.upper, 1e-12);
  }
  const std::string half = composite(face, "#1207,#1208", "");
  const auto removal = parts::removal_of(folder.write("product.step", step.with(half)), {});
  ASSERT_TRUE(removal.ok()) << removal.error();
  EXPECT_TRUE(removal.value().dimensions.empty()) << "one limit alone";
}

TEST(DrawnDimensions, WithoutAnyThereAreNone) {
  const auto removal = parts::removal_of("parts/library/inspection/product.step", {});
  ASSERT_TRUE(removal.ok()) << removal.error();
  EXPECT_TRUE(removal.value().dimensions.empty());
}

}  // namespace
}  // namespace g31::drawn_dimensions_test
