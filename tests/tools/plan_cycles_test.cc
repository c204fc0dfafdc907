// `g31 plan`: holes of the case study measured by the control's own cycles, and by single touches
// where these do not fit.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/effort.h"
#include "tests/tools/planned_case.h"
#include "tools/session/control.h"

namespace g31::plan_cycles_test {
namespace {

using nlohmann::json;
using testing::CommandOutput;
using testing::ProgramRun;
using testing::row_of;
using testing::run_plan;
using testing::text_of;

const std::string kProduct = testing::kInspected;

class PlanCycles : public testing::PlannedCase {};

// Holes by what the control has of its own: two touches each by O9010, two times four by CYCLE977.
TEST_F(PlanCycles, MeasuresHolesByTheCyclesOfTheControl) {
  for (const std::string& control : testing::some_of(session::control_names())) {
    SCOPED_TRACE(control);
    const bool is_sinumerik = control == "sinumerik-828d";
    ASSERT_EQ(plan({kProduct, "--stock", "box", "--control", control}).exit_code, 0);
    const json plan = document();
    const std::string program = text_of(out(is_sinumerik ? "INSPECT.MPF" : "inspect.nc"));
    const std::string call = is_sinumerik ? "CYCLE977(" : "G65 P9010 ";
    std::size_t calls = 0;
    for (std::size_t at = program.find(call); at != program.npos; at = program.find(call, at + 1)) {
      ++calls;
    }
    if (control == "brother") {  // O9010 needs IF ... THEN
      EXPECT_EQ(calls, 0U);
      EXPECT_EQ(plan.at("proof").at("touches"), 40);
      const std::string why = row_of(plan.at("features"), "F3").at("by_points");
      EXPECT_NE(why.find("this control has no THEN"), why.npos) << why;
      EXPECT_NE(program.find("(POINT BY POINT: O9010 DOES NOT RUN HERE"), program.npos);
      continue;
    }
    EXPECT_EQ(calls, is_sinumerik ? 4U : 8U);
    EXPECT_EQ(plan.at("proof").at("touches"), 48);
    EXPECT_LT(plan.at("proof").at("largest_deviation"), 1e-6);
    for (const json& feature : plan.at("features")) {
      const bool is_hole = feature.at("kind") == "blind_hole";
      EXPECT_EQ(feature.value("cycle", ""), !is_hole ? "" : is_sinumerik ? "CYCLE977" : "O9010");
      EXPECT_FALSE(feature.contains("by_points"));
    }
  }
}

TEST_F(PlanCycles, MeasuresHolesPointByPointWhereThatIsWanted) {
  for (const char* const control : {"fanuc-30i", "828D"}) {
    ASSERT_EQ(
        plan({kProduct, "--stock", "box", "--control", control, "--point-by-point"}).exit_code, 0);
    EXPECT_EQ(document().at("proof").at("touches"), 40);
    for (const json& feature : document().at("features")) {
      EXPECT_FALSE(feature.contains("cycle")) << feature;
      const bool is_hole = feature.at("kind").get<std::string>().ends_with("hole");
      EXPECT_EQ(feature.value("by_points", ""), is_hole ? "as asked for" : "") << feature;
    }
  }
}

// A shop's sheet says what its control knows of the probe.
TEST_F(PlanCycles, MeasuresHolesByACycleOnlyWhereTheProbeIsCalibrated) {
  const std::string rest =
      "[work_offsets.G54]\nX = 0.0\nY = 0.0\nZ = -300.0\n[probe]\nlength = 120.0\n"
      "ball_diameter = 6.0\n";
  const std::string fanuc = "[tools.1]\nlength = 120.0\n";
  const std::string siemens =
      "[control]\nprofile = \"sinumerik-828d\"\n[tools.1]\nlength = 120.0\n";
  const std::string triggers =
      "[variables]\n\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]\" = -3.001\n"
      "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]\" = 3.001\n"
      "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]\" = -2.999\n";
  const std::string last = "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]\" = 3.001\n";
  const std::pair<std::string, std::string> cases[] = {
      {fanuc, "#515, the ball of O9010, has no value in the sheet"},
      {fanuc + "[variables]\n\"#515\" = 5.0\n", "#515 is 5, the ball 6 mm"},
      {fanuc + "[variables]\n\"#515\" = 6.001\n", ""},
      {siemens + "radius = 3.0\n" + triggers + last, "tool 1 is of type 0"},
      {siemens + "type = 710.0\n" + triggers + last, "tool 1 has the radius 0, the ball 3 mm"},
      {siemens + "type = 710.0\nradius = 3.0\n" + triggers, "PLUS_DIR_AX2[0]"},
      {siemens + "type = 710.0\nradius = 3.0\n" + triggers + last, ""},
  };
  for (const auto& [sheet, why] : cases) {
    SCOPED_TRACE(sheet);
    const std::string path = folder_.write("shop.toml", sheet + rest);
    const CommandOutput output = plan({kProduct, "--stock", "box", "--setup", path});
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const json feature = row_of(document().at("features"), "F5");
    EXPECT_EQ(feature.contains("cycle"), why.empty()) << feature;
    EXPECT_NE(feature.value("by_points", "").find(why), std::string::npos) << feature;
    EXPECT_EQ(output.out.find("point by point: ") == std::string::npos, why.empty()) << output.out;
  }
  // Of the last one: what the control takes for the ball is in what it measures.
  const json measured = row_of(document().at("measures"), "F5.Y");
  const ProgramRun run = run_plan(out("INSPECT.MPF"), out("setup.toml"), json::array({measured}));
  EXPECT_NEAR(run.variables.at(measured.at("variable")), 16.0, 1e-6);
}

// In a hole of 6.04 mm facets are touched obliquely: a note, which names the program where it will
// be.
TEST_F(PlanCycles, NotesOfItsRunNameTheProgramInItsFolder) {
  const std::string narrow = changed_product({{"(83.,", "(78.02,"}, {",8.)", ",3.02)"}});
  const CommandOutput output = plan({narrow, "--stock", "box"});
  ASSERT_EQ(output.exit_code, 1) << output.errors;  // the ball does not get to its floor
  EXPECT_NE(output.errors.find(out("inspect.nc") + ":"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("[PRB316]"), std::string::npos) << output.errors;
  EXPECT_EQ(output.errors.find(".g31-"), std::string::npos) << output.errors;
}

/// "proven on product.step: 48 touches in 208 s of machine time, ..."
double machine_time_s(const std::string& summary) {
  const std::size_t end = summary.find(" s of machine time");
  return end == std::string::npos ? 0.0 : std::stod(summary.substr(summary.rfind(' ', end - 1)));
}

// The hole F5 0.04 too wide and shifted by 0.3; F3 0.03 too deep: each in its measure alone, also
// where the touches across are on chords.
TEST_F(PlanCycles, FindsTheErrorsOfHolesByTheCyclesAndPointByPoint) {
  const std::string machined = changed_product({{"(83.,", "(83.32,"},
                                                {"(75.,85.", "(75.3,85."},
                                                {",8.)", ",8.02)"},
                                                {",-18.)", ",-18.03)"}});
  const std::map<std::string, double> errors = {
      {"F5.X", 0.04}, {"F5.Y", 0.04}, {"F5.X.place", 0.3}, {"F3.Z", 0.03}};
  for (const auto& [control, by_points] :
       {std::pair("fanuc-30i", false), std::pair("828D", false), std::pair("haas", false),
        std::pair("fanuc-30i", true), std::pair("828D", true), std::pair("brother", false)}) {
    SCOPED_TRACE(std::string(control) + (by_points ? ", point by point" : ""));
    std::vector<std::string> words = {kProduct,      "--stock",       "box",
                                      "--tolerance", "0.005",         "--control",
                                      control,       "--as-machined", machined};
    if (by_points) {
      words.emplace_back("--point-by-point");
    }
    const CommandOutput output = plan(words);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const json made = document();
    EXPECT_GT(machine_time_s(output.out), 0.0) << output.out;
    EXPECT_LT(machine_time_s(output.out), 600.0) << output.out;
    for (const json& row : made.at("as_machined").at("measures")) {
      const auto error = errors.find(row.at("id"));
      const bool is_wrong = error != errors.end();
      EXPECT_EQ(row.at("verdict"), is_wrong ? "bad" : "good") << row;
      EXPECT_NEAR(row.at("deviation"), is_wrong ? error->second : 0.0, 1e-3) << row;
    }
  }
}

}  // namespace
}  // namespace g31::plan_cycles_test
