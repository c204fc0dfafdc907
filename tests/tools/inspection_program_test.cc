// Inspection programs of plans made by hand run on every control over parts whose sizes are known.

#include "tools/plan/inspection_program.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/run_program.h"
#include "tools/plan/judgement.h"

namespace g31::plan::inspection_program_test {
namespace {

using probe::Characteristic;
using probe::InspectionPlan;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr double kRadius = 3.0;

Point turned(const Point& p, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  return {p.x() * std::cos(angle) - p.y() * std::sin(angle),
          p.x() * std::sin(angle) + p.y() * std::cos(angle), p.z()};
}

/// A plan of a part whose axes are turned by an angle.
struct PlanMaker {
  double angle_deg = 0.0;
  InspectionPlan plan = {};

  std::size_t point(const Point& at, const Point& normal) {
    const double off = kRadius + (normal.z() > 0.5 ? 10.0 : 3.0);
    const Point at_P = turned(at, angle_deg);
    const Point normal_P = turned(normal, angle_deg);
    plan.points.push_back({fmt::format("P{}", plan.points.size() + 1), at_P, normal_P,
                           Point(at_P + off * normal_P), ""});
    return plan.points.size() - 1;
  }

  void measure(const std::string& id, Characteristic what, double nominal, const Point& direction,
               const std::array<std::size_t, 2>& points, double origin = 0.0) {
    plan.measures.push_back({id, plan.features.size() - 1, 'X', what, nominal,
                             probe::Tolerance{-0.1, 0.1}, points[0], points[1],
                             turned(direction, angle_deg), origin});
  }
};

/// The pocket of the shape of that name, 60 x 40 x 15 in a block of 80 x 60.
InspectionPlan pocket_plan(double angle_deg = 0.0) {
  const Point x = Point::UnitX();
  const Point y = Point::UnitY();
  PlanMaker maker{angle_deg};
  maker.plan.features = {"F1 closed pocket (milled)"};
  const auto west = maker.point({-30.0, 2.0, -7.0}, x);
  const auto east = maker.point({30.0, 2.0, -7.0}, -x);
  const auto south = maker.point({-1.5, -20.0, -7.0}, y);
  const auto north = maker.point({-1.5, 20.0, -7.0}, -y);
  const auto floor = maker.point({4.0, 0.0, -15.0}, Point::UnitZ());
  const auto top = maker.point({34.5, 0.0, 0.0}, Point::UnitZ());
  const auto side = maker.point({40.0, 0.0, -7.0}, x);
  maker.plan.points[west].moved = "5 mm aside: a (clamp) \xC3\xA4";
  maker.measure("F1.X", Characteristic::Size, 60.0, x, {west, east});
  maker.measure("F1.X.place", Characteristic::Place, 40.0, x, {west, east}, -40.0);
  maker.measure("F1.Y", Characteristic::Size, 40.0, -y, {north, south});
  maker.measure("F1.Y.place", Characteristic::Place, -30.0, -y, {south, north}, 30.0);
  maker.measure("F1.Z", Characteristic::Size, 15.0, Point::UnitZ(), {floor, top});
  maker.measure("F1.wall", Characteristic::Size, 10.0, x, {east, side});
  maker.measure("F1.Z.place", Characteristic::Place, 492.5, Point::UnitZ(), {floor, top}, -500.0);
  return maker.plan;
}

bool is_sinumerik(std::string_view profile) {
  return profile == "sinumerik-828d";
}

ProgramOptions options_for(std::string_view profile) {
  ProgramOptions options;
  options.language = is_sinumerik(profile) ? ProgramLanguage::Sinumerik : ProgramLanguage::Fanuc;
  options.has_metric_code = profile != "brother";
  options.product = "pocket.stl";
  options.ball_radius_mm = kRadius;
  options.clear_z_P = 30.0;
  options.tip_below_centre_mm = kRadius;
  if (is_sinumerik(profile)) {
    options.tool = 1;
  }
  return options;
}

/// @param length  of the probe in the tool table
std::string sheet(const std::string& part, double length = 123.0) {
  return fmt::format(
      "[machine]\nstopping = \"ideal\"\n[start]\nX = 0.0\nY = 0.0\nZ = 0.0\n"
      "[work_offsets.G54]\nX = 317.125\nY = -151.75\nZ = -300.5\n"
      "[tools.1]\nlength = {}\nradius = 3.0\n[probe]\nball_diameter = 6.0\nlength = 120.0\n"
      "[[part]]\non = \"G54\"\n{}",
      length, part);
}

struct Inspected : RunOutput {
  std::string printed;
};

Inspected inspected(const InspectionProgram& program, std::string_view profile,
                    const std::string& sheet_text) {
  const TemporaryFolder folder;
  cli::RunOptions run;
  run.programs = {folder.write(is_sinumerik(profile) ? "INSPECT.MPF" : "inspect.nc", program.text)};
  run.setups = {folder.write("sheet.toml", sheet_text)};
  run.control = std::string(profile);
  for (const PrintedMeasure& measure : program.measures) {
    run.prints.push_back(measure.variable);
  }
  Inspected output{testing::run_program(run), ""};
  if (output.document.is_object()) {
    const auto& files = output.document.at("files");
    output.printed = is_sinumerik(profile) ? files.value("INSPECT_LOG", "")
                                           : output.document.at("output").get<std::string>();
  }
  return output;
}

std::vector<Measure> to_judge(const InspectionPlan& plan, const InspectionProgram& program) {
  std::vector<Measure> measures;
  for (std::size_t m = 0; m < plan.measures.size(); ++m) {
    measures.push_back({plan.measures[m].id, program.measures[m].name, plan.measures[m].nominal,
                        plan.measures[m].tolerance});
  }
  return measures;
}

/// What is measured is within 1e-6 mm of it in the variables, and printed to the last digit.
void expect_values(const InspectionPlan& plan, std::string_view profile,
                   const std::string& sheet_text, const std::vector<double>& expected) {
  SCOPED_TRACE(profile);
  const InspectionProgram program = inspection_program(plan, options_for(profile));
  const Inspected output = inspected(program, profile, sheet_text);
  ASSERT_EQ(output.exit_code, 0) << output.errors << program.text;
  EXPECT_EQ(output.document["diagnostics"].size(), 0U) << output.errors;
  const Judgement judgement = judged(to_judge(plan, program), output.printed);
  for (std::size_t m = 0; m < expected.size(); ++m) {
    SCOPED_TRACE(plan.measures[m].id);
    const std::string& variable = program.measures[m].variable;
    EXPECT_NEAR(output.document["variables"].value(variable, -1.0), expected[m], 1e-6);
    EXPECT_EQ(judgement.measures[m].verdict, Verdict::Good) << output.printed;
  }
}

/// 0.05 right of where it should be, 0.03 in front, 0.01 high, and of other sizes.
constexpr const char* kPocket =
    "shape = \"pocket\"\nlength = 60.012\nwidth = 39.9876\ndepth = 15.0234\nwall = 9.99\n"
    "at = [0.05, -0.03, 0.01]\n";
/// X, its place, Y, its place (against Y), Z, the wall, the middle of floor and top.
const std::vector<double> kPocketIs = {
    60.012, 40.05, 39.9876, -29.97, 15.0234, 9.99, 500.0 + 0.01 - 15.0234 / 2.0};

/// Under the sanitizers the first and the fifth.
constexpr std::string_view kProfiles[] = {"sinumerik-828d", "fanuc-0i",    "fanuc-16i",
                                          "haas",           "fanuc-30i",   "brother",
                                          "meldas",         "mazatrol-iso"};

/// Three measures share a wall, two of them with the other one.
TEST(InspectionProgram, MeasuresAPocketOnEveryControl) {
  for (const std::string_view profile : testing::some_of(kProfiles)) {
    expect_values(pocket_plan(), profile, sheet(kPocket), kPocketIs);
  }
}

/// The part is turned about its origin, which lies 0.05 and -0.03 off along its own axes.  The last
/// angle has more digits than a number of a control.
TEST(InspectionProgram, MeasuresAPocketTurnedByAnyAngle) {
  for (const double angle : {30.0, 45.0, 90.0, -123.456789012}) {
    SCOPED_TRACE(angle);
    const Point at = turned({0.05, -0.03, 0.01}, angle);
    const std::string part = fmt::format(
        "shape = \"pocket\"\nlength = 60.012\nwidth = 39.9876\ndepth = 15.0234\nwall = 9.99\n"
        "at = [{}, {}, {}]\nrotate_deg = [0.0, 0.0, {:.12f}]\n",
        at.x(), at.y(), at.z(), angle);
    for (const std::string_view profile : testing::some_of(kProfiles)) {
      expect_values(pocket_plan(angle), profile, sheet(part), kPocketIs);
    }
  }
}

/// What both control families know of a probe without errors.
std::string calibration(std::string_view profile) {
  return is_sinumerik(profile) ? "type = 710.0\n[machine_data]\n"
                                 "\"$SNS_MEA_WP_BALL_DIAM[0]\" = 6.0\n"
                                 "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]\" = -3.0\n"
                                 "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]\" = 3.0\n"
                                 "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]\" = -3.0\n"
                                 "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]\" = 3.0\n"
                               : "[variables]\n\"#515\" = 6.0\n";
}

std::string calibrated_sheet(std::string_view profile, const std::string& part) {
  std::string text = sheet(part);
  const std::string before = "[probe]";
  return text.insert(text.find(before), calibration(profile));
}

/// A hole or a boss of 40 mm about the origin, whose wall is touched at z = -7.
InspectionPlan round_plan(bool is_boss, const std::string& by_points = "") {
  const double side = is_boss ? -1.0 : 1.0;
  const Point x = Point::UnitX();
  const Point y = Point::UnitY();
  PlanMaker maker;
  maker.plan.features = {is_boss ? "F1 boss" : "F1 through hole"};
  const auto west = maker.point({-20.0, 0.0, -7.0}, side * x);
  const auto east = maker.point({20.0, 0.0, -7.0}, -side * x);
  const auto south = maker.point({0.0, -20.0, -7.0}, side * y);
  const auto north = maker.point({0.0, 20.0, -7.0}, -side * y);
  maker.measure("F1.X", Characteristic::Size, 40.0, x, {west, east});
  maker.measure("F1.X.place", Characteristic::Place, 50.0, x, {west, east}, -50.0);
  maker.measure("F1.Y", Characteristic::Size, 40.0, y, {south, north});
  maker.measure("F1.Y.place", Characteristic::Place, 0.0, y, {south, north});
  for (auto& measure : maker.plan.measures) {
    measure.tolerance = probe::Tolerance{-1.0, 1.0};
  }
  maker.plan.rounds = {{.feature = 0,
                        .centre_P = {0.0, 0.0, -7.0},
                        .diameter_mm = 40.0,
                        .is_standing = is_boss,
                        .approach_mm = 3.0,
                        .points = {west, east, south, north},
                        .measures = {0, 1, 2, 3},
                        .by_points = by_points}};
  return maker.plan;
}

/// A facet is at most this far from the true circle.
constexpr double kSagitta = 1e-6;

/// 0.4 beside its place, 0.3 in front of it and 0.02 too large; `expect_values` wants a millionth,
/// which facets do not have where they are not touched at their corners.
void expect_circle(const InspectionPlan& plan, std::string_view profile, const std::string& part,
                   const std::vector<double>& expected) {
  SCOPED_TRACE(profile);
  const InspectionProgram program = inspection_program(plan, options_for(profile));
  const Inspected output = inspected(program, profile, calibrated_sheet(profile, part));
  ASSERT_EQ(output.exit_code, 0) << output.errors << program.text;
  for (std::size_t m = 0; m < expected.size(); ++m) {
    EXPECT_NEAR(output.document["variables"].value(program.measures[m].variable, -1.0), expected[m],
                4.0 * kSagitta + 1e-6)
        << plan.measures[m].id;
  }
}

std::string round_part(bool is_boss) {
  return fmt::format("{}\nsagitta = {:.7f}\nat = [0.4, -0.3, 0.0]\n",
                     is_boss ? "shape = \"cylinder\"\ndiameter = 40.02"
                             : "shape = \"ring\"\nbore = 40.02\nouter_diameter = 60.0",
                     kSagitta);
}

/// A cycle finds the diameter although the circle is not where it should be, and so do single
/// touches, which are on chords.
TEST(InspectionProgram, MeasuresRoundWallsByTheCyclesOfTheControl) {
  for (const bool is_boss : {false, true}) {
    SCOPED_TRACE(is_boss);
    for (const std::string_view profile : testing::some_of(kProfiles)) {
      expect_circle(round_plan(is_boss, "for the test"), profile, round_part(is_boss),
                    {40.02, 50.4, 40.02, -0.3});
      if (profile != "brother") {
        expect_circle(round_plan(is_boss), profile, round_part(is_boss),
                      {40.02, 50.4, 40.02, -0.3});
      }
    }
  }
}

TEST(InspectionProgram, CallsTheCycleOfTheControl) {
  const auto text = [](std::string_view profile, const InspectionPlan& plan) {
    return inspection_program(plan, options_for(profile)).text;
  };
  const std::string fanuc = text("fanuc-30i", round_plan(false));
  for (const char* const block :
       {"(P1 P2 P3 P4 BY O9010, THE MACRO OF G100)", "G65 P9010 U-20. R-10. Z-10. A9.\n#114=#168\n",
        "G65 P9010 V20. R-10. Z-10. A9.\n#117=#183\n"}) {
    EXPECT_NE(fanuc.find(block), std::string::npos) << block << fanuc;
  }
  const std::string sinumerik = text("sinumerik-828d", round_plan(true));
  // From the clear height, at which the tip is at 27, down by 37 mm.
  for (const char* const block :
       {"CYCLE977(2,,,1,40.,,,3.,3.,90.,-37.)\n; F1.X: nominal 40.\nR10=_OVR[4]\n",
        "CYCLE977(2,,,1,40.,,,3.,3.,,-37.)\n; F1.X.place: nominal 50.\n"
        "R11=_OVR[5]+50.\n"}) {
    EXPECT_NE(sinumerik.find(block), std::string::npos) << block << sinumerik;
  }
  const std::string by_points = text("fanuc-30i", round_plan(false, "a (clamp)"));
  EXPECT_EQ(by_points.find("P9010"), std::string::npos);
  EXPECT_NE(by_points.find("(POINT BY POINT: A -CLAMP-)"), std::string::npos) << by_points;
}

/// Of the touches that come in a run, O9010 counts its second one, CYCLE977 its second pair.
TEST(InspectionProgram, KnowsWhichTouchesItsContactsAreOf) {
  const InspectionPlan plan = round_plan(false);
  const auto fanuc = inspection_program(plan, options_for("fanuc-30i"));
  EXPECT_EQ(fanuc.touches, 8U);
  EXPECT_EQ(fanuc.touches_of_points, (std::vector<std::size_t>{1, 3, 5, 7}));
  const auto sinumerik = inspection_program(plan, options_for("sinumerik-828d"));
  EXPECT_EQ(sinumerik.touches, 8U);
  EXPECT_EQ(sinumerik.touches_of_points, (std::vector<std::size_t>{2, 3, 7, 6}));
}

/// A hole of 47 mm: its wall is 3.5 mm behind where the touches end.
TEST(InspectionProgram, NamesARoundWallThatIsNotThere) {
  const std::string wide = "shape = \"ring\"\nbore = 47.0\nouter_diameter = 80.0\n";
  for (const std::string_view profile : {"fanuc-30i", "sinumerik-828d"}) {
    SCOPED_TRACE(profile);
    const InspectionProgram program = inspection_program(round_plan(false), options_for(profile));
    const Inspected output = inspected(program, profile, calibrated_sheet(profile, wide));
    EXPECT_EQ(output.exit_code, 3) << output.errors;
    const std::string alarm = output.document["alarm"].dump();
    EXPECT_NE(alarm.find(is_sinumerik(profile) ? "61301" : "P1 IS NOT TOUCHED"), std::string::npos)
        << output.errors;
  }
}

/// The floor is 4 mm lower than the plan has it, 1 mm behind the end of its touch.
TEST(InspectionProgram, NamesAFloorThatIsNotThere) {
  for (const std::string_view profile : testing::some_of(kProfiles)) {
    SCOPED_TRACE(profile);
    const InspectionProgram program = inspection_program(pocket_plan(), options_for(profile));
    const Inspected output =
        inspected(program, profile, sheet("shape = \"pocket\"\ndepth = 19.0\n"));
    EXPECT_EQ(output.exit_code, 3);
    const std::string alarm = output.document["alarm"].dump();
    EXPECT_NE(alarm.find(is_sinumerik(profile) ? "P5 is not touched" : "P5 IS NOT TOUCHED"),
              std::string::npos)
        << output.errors;
    EXPECT_EQ(output.printed.find("F1-Z"), std::string::npos) << output.printed;
  }
}

/// Nobody has milled the pocket.
TEST(InspectionProgram, StopsBeforeWhatIsInTheWay) {
  for (const std::string_view profile : testing::some_of(kProfiles)) {
    SCOPED_TRACE(profile);
    const InspectionProgram program = inspection_program(pocket_plan(), options_for(profile));
    const Inspected output = inspected(
        program, profile, sheet("shape = \"block\"\nlength = 80.0\nwidth = 60.0\nheight = 30.0\n"));
    EXPECT_EQ(output.exit_code, 3) << output.errors;
    const std::string alarm = output.document["alarm"].dump();
    EXPECT_NE(alarm.find(is_sinumerik(profile) ? "in the way to P1" : "IN THE WAY TO P1"),
              std::string::npos)
        << output.errors;
  }
}

}  // namespace
}  // namespace g31::plan::inspection_program_test
