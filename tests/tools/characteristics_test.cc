// [[characteristic]]: what a program measures, beside what the simulated part truly is.

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/page/write_page.h"

namespace g31::characteristics_test {
namespace {

using nlohmann::json;
using testing::g31;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr double kAccuracy = 1e-9;  // mm

std::string text_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

RunOutput ring_with(const std::vector<std::string>& assignments) {
  const std::string folder = "parts/library/ring_gauge/";
  cli::RunOptions options;
  options.programs = {folder + "measure_ring.nc"};
  options.setups = {folder + "ring.toml", folder + "late_probe.toml", folder + "diameters.toml"};
  options.assignments = assignments;
  return run_program(options);
}

// The ring is 39.996; 50 mm/min for 4 ms are 3.33 um too far at each wall, unless they are taken
// off.
TEST(Characteristics, OfTheRingAreItsTrueSizeAndWhatTheProbeAdds) {
  const double overtravel = 50.0 / 60.0 * 0.004;
  for (const bool is_calibrated : {false, true}) {
    SCOPED_TRACE(is_calibrated);
    const std::string amount = fmt::format("{}", is_calibrated ? -overtravel : 0.0);
    const RunOutput output = ring_with({"#517=" + amount, "#518=" + amount});
    EXPECT_EQ(output.exit_code, 0) << output.errors;
    const json& rows = output.document.at("characteristics");
    ASSERT_EQ(rows.size(), 2U);
    const double error = is_calibrated ? 0.0 : 2.0 * overtravel;
    for (const json& row : rows) {
      EXPECT_EQ(row.at("unit"), "mm");
      EXPECT_EQ(row.at("nominal"), 40.0);
      EXPECT_EQ(row.at("true"), 39.996);
      EXPECT_EQ(row.at("verdict"), "good");
      EXPECT_NEAR(row.at("actual"), 39.996 + error, kAccuracy);
      EXPECT_NEAR(row.at("deviation"), -0.004 + error, kAccuracy);
      EXPECT_NEAR(row.at("measuring_error"), error, kAccuracy);
    }
    EXPECT_EQ(rows[0].at("name"), "Bore of the ring, X");
    EXPECT_EQ(rows[1].at("variable"), "#179");
  }
}

constexpr const char* kProgram = "O1\n#500=39.989\n#501=90.25\n#502=1.5748\nM30\n";

RunOutput run_with(const std::string& rows, const std::string& program = kProgram) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("a.nc", program)};
  options.setups = {folder.write(
      "sheet.toml", "[[part]]\nname = \"ring\"\nshape = \"ring\"\nbore = 40.004\n" + rows)};
  return run_program(options);
}

// Worked out by the shape: 40.004 + 40 outside, walls of 20; and where the sheet puts the part.
TEST(Characteristics, AreOfWhatAShapeWorksOutAndWhereAPartIs) {
  const RunOutput output = run_with(
      "at = [101.5, -7.25, 3.0]\nrotate_deg = [0.0, 0.0, 1.5]\n"
      "[[part]]\nname = \"ring.2\"\nshape = \"plug\"\non = \"G55\"\nat = [1.0, 2.0, 3.0]\n"
      "[work_offsets.G55]\nX = 300.0\nY = 20.0\nZ = -5.0\n"
      "[[characteristic]]\nname = \"a\"\nvariable = \"#500\"\ntrue = \"ring.outer_diameter\"\n"
      "[[characteristic]]\nname = \"b\"\nvariable = \"#500\"\ntrue = \"ring.wall\"\n"
      "[[characteristic]]\nname = \"c\"\nvariable = \"#500\"\ntrue = \"ring.radius\"\n"
      "unit = \"um\"\n"
      "[[characteristic]]\nname = \"d\"\nvariable = \"#500\"\ntrue = \"ring.at.Y\"\n"
      "[[characteristic]]\nname = \"e\"\nvariable = \"#500\"\ntrue = \"ring.2.at.X\"\n"
      "[[characteristic]]\nname = \"f\"\nvariable = \"#500\"\ntrue = \"ring.2.foot_diameter\"\n");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const json& rows = output.document.at("characteristics");
  const double truths[] = {80.004, 20.0, 20002.0, -7.25, 301.0, 50.0};
  ASSERT_EQ(rows.size(), std::size(truths));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i].at("true").get<double>(), truths[i], 1e-9) << rows[i].at("name");
  }
  EXPECT_NEAR(rows[3].at("measuring_error").get<double>(), 39.989 + 7.25, 1e-12);
}

// The offset turns the part that lies on it by 30 degrees more.
TEST(Characteristics, AreOfAnglesThatAnOffsetMakes) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("a.mpf", "R1=31.25\nM30\n")};
  options.setups = {folder.write(
      "a.toml",
      "[[part]]\nname = \"p\"\nshape = \"block\"\non = \"G55\"\nrotate_deg = [0.0, 0.0, 1.5]\n"
      "[work_offsets.G55]\nX = 300.0\nrotate_deg = [0.0, 0.0, 30.0]\n"
      "[[characteristic]]\nname = \"a\"\nvariable = \"R1\"\nunit = \"deg\"\n"
      "true = \"p.rotate_deg.Z\"\n")};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const json& row = output.document.at("characteristics").at(0);
  EXPECT_NEAR(row.at("true").get<double>(), 31.5, 1e-9);
  EXPECT_NEAR(row.at("measuring_error").get<double>(), -0.25, 1e-9);
}

// How a part is turned; between sides of a prism; how many of them.
TEST(Characteristics, AreOfAnglesOfAPart) {
  const RunOutput output = run_with(
      "rotate_deg = [2.0, -3.0, 90.1]\n"
      "[[part]]\nname = \"nut\"\nshape = \"prism\"\nsides = 5\non = \"G55\"\n"
      "rotate_deg = [0.0, 0.0, 1.5]\nat = [200.0, 0.0, 0.0]\n"
      "[work_offsets.G55]\nX = 300.0\n"
      "[[characteristic]]\nname = \"a\"\nvariable = \"#501\"\nunit = \"deg\"\nnominal = 90.0\n"
      "tolerance = 0.5\ntrue = \"ring.rotate_deg.Z\"\n"
      "[[characteristic]]\nname = \"b\"\nvariable = \"#501\"\nunit = \"deg\"\n"
      "true = \"ring.rotate_deg.Y\"\n"
      "[[characteristic]]\nname = \"c\"\nvariable = \"#501\"\nunit = \"deg\"\n"
      "true = \"ring.rotate_deg.X\"\n"
      "[[characteristic]]\nname = \"d\"\nvariable = \"#501\"\nunit = \"deg\"\n"
      "true = \"nut.rotate_deg.Z\"\n"
      "[[characteristic]]\nname = \"e\"\nvariable = \"#501\"\nunit = \"deg\"\n"
      "true = \"nut.corner_angle\"\n"
      "[[characteristic]]\nname = \"f\"\nvariable = \"#501\"\nunit = \"none\"\n"
      "true = \"nut.sides\"\n");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const json& rows = output.document.at("characteristics");
  const double truths[] = {90.1, -3.0, 2.0, 1.5, 108.0, 5.0};
  ASSERT_EQ(rows.size(), std::size(truths));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i].at("true").get<double>(), truths[i], 1e-9) << rows[i].at("name");
    EXPECT_NEAR(rows[i].at("measuring_error").get<double>(), 90.25 - truths[i], 1e-9);
  }
}

TEST(Characteristics, OutOfToleranceAreAFindingAtTheirPlace) {
  const RunOutput output = run_with(
      "[[characteristic]]\nname = \"Bore\"\nvariable = \"#0500\"\nnominal = 40.0\n"
      "tolerance = 0.01\ntrue = \"ring.bore\"\n");
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.errors.find("sheet.toml:7:12: error: not as expected: Bore (#500): expected 40 "
                               "-0.01 +0.01 mm, got 39.989 mm [PRB701]"),
            std::string::npos)
      << output.errors;
  EXPECT_NE(output.errors.find("= the part is out, or what measures it: "), std::string::npos);
  const json& row = output.document.at("characteristics").at(0);
  EXPECT_EQ(row.at("verdict"), "bad");
  EXPECT_NEAR(row.at("measuring_error"), 39.989 - 40.004, 1e-12);
}

TEST(Characteristics, AreInTheirUnitAndWithinTheirOwnLimits) {
  const RunOutput output = run_with(
      // Limits of one sign, and the values at them.
      "[[characteristic]]\nname = \"fit\"\nvariable = \"#500\"\nnominal = 39.98\n"
      "tolerance = [0.009, 0.03]\n"
      "[[characteristic]]\nname = \"angle\"\nvariable = \"#501\"\nnominal = 90.0\nunit = \"deg\"\n"
      "tolerance = [-0.25, 0.25]\n"
      "[[characteristic]]\nname = \"inches\"\nvariable = \"#502\"\nnominal = 1.5748\n"
      "unit = \"inch\"\ntrue = \"ring.bore\"\n"
      "[[characteristic]]\nname = \"vacant\"\nvariable = \"#503\"\nunit = \"none\"\n");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const json& rows = output.document.at("characteristics");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].at("verdict"), "good") << "39.98 + 0.009 is 39.989";
  EXPECT_EQ(rows[1].at("verdict"), "good");
  EXPECT_EQ(rows[1].at("true"), nullptr);
  EXPECT_NEAR(rows[2].at("true"), 40.004 / 25.4, 1e-12);
  EXPECT_EQ(rows[2].at("verdict"), "reported");
  EXPECT_EQ(rows[2].at("tolerance"), nullptr);
  EXPECT_EQ(rows[3].at("verdict"), "missing");
  EXPECT_EQ(rows[3].at("actual"), nullptr);
}

TEST(Characteristics, ThatAreNotReachedAreNoGoodOnes) {
  const RunOutput output = run_with(
      "[[characteristic]]\nname = \"Bore\"\nvariable = \"#503\"\nnominal = 40.0\n"
      "tolerance = 0.01\n");
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.errors.find("got no number"), std::string::npos) << output.errors;
}

// A SINUMERIK's variables are 0 before anything is measured, which is a good deviation.
TEST(Characteristics, AreWhatTheRunHasWrittenNotWhatStoodThereBefore) {
  const std::string rows =
      "[control]\nprofile = \"sinumerik-828d\"\n"
      "[[characteristic]]\nname = \"top\"\nvariable = \"R16\"\nnominal = 0.0\ntolerance = 0.02\n"
      "[[characteristic]]\nname = \"side\"\nvariable = \"_ovr[21]\"\nnominal = 0.0\n"
      "tolerance = 0.02\n";
  const struct {
    const char* program;
    const char* top;
    const char* side;
  } cases[] = {
      {"M30\n", "missing", "missing"},
      {"R16=0\n_OVR[21]=0\nM30\n", "good", "good"},
      {"R[16]=0.01\nM30\n", "good", "missing"},
      {"R17=16\nR[R17]=0\n_OVR[20]=0\nM30\n", "good", "missing"},
      {"_OVR[21]=0\nR16=1/0\nM30\n", "missing", "good"},
      {"_OVR[0]=SET(1,2)\nR16=0.03\nM30\n", "bad", "missing"},
  };
  for (const auto& given : cases) {
    SCOPED_TRACE(given.program);
    const TemporaryFolder folder;
    const auto sheet = folder.write("sheet.toml", rows);
    const auto output =
        g31({"run", folder.write("P.MPF", given.program), "-s", sheet, "--json", "-"});
    const json found = json::parse(output.out).at("characteristics");
    EXPECT_EQ(found.at(0).at("verdict"), given.top);
    EXPECT_EQ(found.at(1).at("verdict"), given.side);
    const bool is_missed =
        output.errors.find("the run has written no number to ") != std::string::npos;
    EXPECT_EQ(is_missed, found.at(0).at("actual").is_null() || found.at(1).at("actual").is_null());
  }
}

TEST(Characteristics, OfVariablesThatAreKeptOverPowerOffAreThoseOfThisRun) {
  const TemporaryFolder folder;
  const auto sheet =
      folder.write("sheet.toml",
                   "[control]\nprofile = \"fanuc-30i\"\nvariables_file = \"kept.vars\"\n"
                   "[[characteristic]]\nname = \"top\"\nvariable = \"#703\"\nnominal = 0.0\n"
                   "tolerance = 0.02\n");
  const auto exit_code_of = [&](const char* block) {
    return g31({"run", folder.write("p.nc", std::string("%\nO1\n") + block + "\nM30\n%\n"), "-s",
                sheet})
        .exit_code;
  };
  EXPECT_EQ(exit_code_of("#703=0.01"), 0);
  EXPECT_EQ(exit_code_of("#702=0"), 1) << "what the run before has left";
  EXPECT_EQ(exit_code_of("#703=0.01"), 0) << "the same value once more";
}

TEST(Characteristics, AreToldBehindWhatEndedTheProgramAndItsDetails) {
  const TemporaryFolder folder;
  const auto sheet = folder.write("sheet.toml",
                                  "[[characteristic]]\nname = \"top\"\nvariable = \"#503\"\n"
                                  "nominal = 0.0\ntolerance = 0.02\n");
  const auto program = folder.write("p.nc", "%\nO1\nG65P2A5.\nM30\nO2\n#3000=1(OFF)\nM99\n%\n");
  const auto output = g31({"run", program, "-s", sheet});
  EXPECT_EQ(output.exit_code, 3);
  const std::size_t locals = output.errors.find("= with #1 = 5");
  const std::size_t status = output.errors.find("not as expected: status");
  ASSERT_NE(locals, std::string::npos) << output.errors;
  ASSERT_NE(status, std::string::npos) << output.errors;
  EXPECT_LT(locals, status) << output.errors;
  EXPECT_NE(output.errors.find("\nerror: not as expected: status"), std::string::npos)
      << "no row of the sheet says it:\n"
      << output.errors;
}

TEST(Characteristics, ThatCannotBeAreRefused) {
  const std::string whole = "[[characteristic]]\nname = \"B\"\nvariable = \"#500\"\n";
  const struct {
    std::string rows;
    const char* says;
    int exit_code;
  } kCases[] = {
      {"[[characteristic]]\nname = \"B\"\n", "a characteristic needs variable [SET121]", 2},
      {"[[characteristic]]\nvariable = \"#500\"\n", "a characteristic needs name [SET121]", 2},
      {whole + "tolerance = 0.1\n", "characteristic.tolerance needs nominal [SET121]", 2},
      {whole + "nominal = 1.0\ntolerance = -0.1\n", "it should be 0 or more, or [lower, upper]", 2},
      {whole + "nominal = 1.0\ntolerance = [0.1, -0.1]\n", "[lower, upper]", 2},
      {whole + "nominal = 1.0\ntolerance = [0.1, 0.2, 0.3]\n", "[lower, upper]", 2},
      {whole + "nominal = 1e10\n", "it should be 1000000000 that of unit at most", 2},
      {whole + "unit = \"ell\"\n", "it should be \"mm\", \"um\", \"inch\", \"deg\" or \"none\"", 2},
      {whole + "true = \"ring\"\n",
       "it should be \"ring.bore\", \"ring.outer_diameter\", \"ring.height\", \"ring.sagitta\", "
       "\"ring.radius\", \"ring.wall\", \"ring.at.X\"",
       2},
      {whole + "true = \"rung.bore\"\n", "is \"rung.bore\", it should be \"ring.bore\"", 2},
      {whole + "true = \"ring.bor\"\n", "is \"ring.bor\", it should be \"ring.bore\"", 2},
      {whole + "true = \"ring.wal\"\n", "is \"ring.wal\", it should be \"ring.wall\"", 2},
      {whole + "true = \"ring.at\"\n", "or \"ring.rotate_deg.Z\"", 2},
      {whole + "true = \"ring.\"\n", "is \"ring.\", it should be \"ring.bore\", ", 2},
      {whole + "true = \"\"\n", "", 2},
      {whole + "unit = \"deg\"\ntrue = \"ring.bore\"\n",
       "a unit of length where true says the size of a part [SET105]", 2},
      {whole + "true = \"ring.rotate_deg.Z\"\n",
       "characteristic.unit is \"mm\", it should be \"deg\" where true says an angle of a part", 2},
      {whole + "unit = \"none\"\ntrue = \"ring.rotate_deg.X\"\n",
       "is \"none\", it should be \"deg\" where true says an angle of a part [SET105]", 2},
      {whole + "unit = \"deg\"\ntrue = \"ring.rotate_deg.C\"\n", "\"ring.rotate_deg.X\"", 2},
      {"[[characteristic]]\nname = \"B\"\nvariable = \"5x\"\n",
       "it should be a variable like #500, R1 or _OVR[0] [SET105]", 2},
      {"[[characteristic]]\nname = \"B\"\nvariable = \"#99999\"\n",
       "#99999 cannot be read on this control [SET126]", 2},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.rows);
    const RunOutput output = run_with(c.rows);
    EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    EXPECT_NE(output.errors.find("sheet.toml:"), std::string::npos) << output.errors;
  }
}

/// Figures of a page that is small enough for plain text.
json figures_in(const std::string& page) {
  const std::string begin = R"(<script type="application/json" id="g31-figures">)";
  const std::size_t from = page.find(begin) + begin.size();
  return json::parse(page.substr(from, page.find("</script>", from) - from));
}

class CharacteristicPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!page::read_assets()) {
      GTEST_SKIP() << "the page's script was not built: node and npm are not here";
    }
  }

  /// The page of four touches from the middle, towards +X, -X, +Y and -Y.
  std::string page_of(const std::string& part, const std::string& rows) {
    const std::string sheet =
        "[start]\nZ = 150.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\n"
        "stem_diameter = 2.0\ntrigger_delay_s = 0.004\n[[part]]\n" +
        part + "at = [0.0, 0.0, 20.0]\n" + rows;
    const std::string program =
        "O7\nG90 G0 X0. Y0.\nG1 Z115. F2000.\n"
        "G31 X60. F300.\n#101=#5061\nG0 X0.\nG31 X-60. F300.\n#102=#5061\nG0 X0.\n"
        "G31 Y60. F300.\n#103=#5062\nG0 Y0.\nG31 Y-60. F300.\n#104=#5062\nG0 Y0.\n"
        "#160=#101-#102+6.\n#161=#103-#104+6.\nM30\n";
    output_ = g31({"run", folder_.write("a.nc", program), "-s", folder_.write("a.toml", sheet),
                   "--report", folder_.path("a.html")});
    return text_in(folder_.path("a.html"));
  }

  TemporaryFolder folder_;
  testing::CommandOutput output_;
};

constexpr const char* kRows =
    "[[characteristic]]\nname = \"along X\"\nvariable = \"#160\"\nnominal = {}\n"
    "tolerance = [-0.02, 0.05]\ntrue = \"p.{}\"\n"
    "[[characteristic]]\nname = \"along Y\"\nvariable = \"#161\"\nnominal = {}\n"
    "tolerance = 0.1\ntrue = \"p.{}\"\n";

// 300 mm/min for 4 ms are 20 um too deep, in the part's own deviation of half of true less nominal.
TEST_F(CharacteristicPage, SplitsAWhiskerOfABoreIntoPartAndMeasurement) {
  const std::string page = page_of("name = \"p\"\nshape = \"ring\"\nbore = 39.996\n",
                                   fmt::format(fmt::runtime(kRows), 40.0, "bore", 40.0, "bore"));
  EXPECT_EQ(output_.exit_code, 0) << output_.errors;
  const json figures = figures_in(page);
  const json& touches = figures.at("touch");
  ASSERT_EQ(touches.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(touches[i].at("part_deviation"), -0.002, 1e-12) << "a smaller bore is less deep";
    EXPECT_NEAR(touches[i].at("deviation"), 0.020, 1e-6);
    EXPECT_NEAR(touches[i].at("limits").at(0), i < 2 ? -0.01 : -0.05, 1e-12);
    EXPECT_NEAR(touches[i].at("limits").at(1), i < 2 ? 0.025 : 0.05, 1e-12);
  }
  // Measured is 39.996 + 0.040, in the columns' order.
  EXPECT_NE(page.find(R"(data-l="Measured">40.036</td>)"), std::string::npos);
  EXPECT_NE(page.find(R"(data-l="True size">39.996</td>)"), std::string::npos);
  EXPECT_NE(page.find(R"(data-l="Measuring error">+40.0 µm</td>)"), std::string::npos);
  EXPECT_NE(page.find(R"(<span class="">+36.0 µm</span>)"), std::string::npos);
  EXPECT_NE(page.find("along X and along Y are in tolerance."), std::string::npos);
}

TEST_F(CharacteristicPage, TellsTheWallsOfTwoSizesApart) {
  const std::string page =
      page_of("name = \"p\"\nshape = \"pocket\"\nlength = 60.01\nwidth = 39.98\n",
              fmt::format(fmt::runtime(kRows), 60.0, "length", 40.0, "width"));
  const json figures = figures_in(page);
  const json& touches = figures.at("touch");
  ASSERT_EQ(touches.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(touches[i].at("part_deviation"), i < 2 ? 0.005 : -0.01, 1e-12) << i;
  }
}

TEST_F(CharacteristicPage, HasNoPartOfAWhiskerWhereTheWallIsOfAnotherSize) {
  const std::string page =
      page_of("name = \"p\"\nshape = \"pocket\"\nlength = 60.0\nwidth = 40.0\n",
              "[[characteristic]]\nname = \"deep\"\nvariable = \"#160\"\nnominal = 15.0\n"
              "true = \"p.depth\"\n");
  const json figures = figures_in(page);
  for (const json& touch : figures.at("touch")) {
    EXPECT_FALSE(touch.contains("part_deviation"));
  }
}

// From outside towards the middle: a larger boss stands further out.
TEST_F(CharacteristicPage, SplitsAWhiskerOfABossTheOtherWay) {
  const std::string sheet =
      "[start]\nZ = 150.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\nstem_diameter = 2.0\n"
      "[[part]]\nname = \"p\"\nshape = \"plug\"\ndiameter = 30.01\nat = [0.0, 0.0, 20.0]\n"
      "[[characteristic]]\nname = \"boss\"\nvariable = \"#160\"\nnominal = 30.0\n"
      "tolerance = [0.0, 0.02]\ntrue = \"p.diameter\"\n";
  const std::string program =
      "O7\nG90 G0 X-40. Y0.\nG1 Z115. F2000.\nG31 X0. F300.\n#101=#5061\nG0 X-40.\nG0 Z140.\n"
      "G0 X40.\nG1 Z115. F2000.\nG31 X0. F300.\n#160=#5061-#101-6.\nM30\n";
  output_ = g31({"run", folder_.write("a.nc", program), "-s", folder_.write("a.toml", sheet),
                 "--report", folder_.path("a.html")});
  EXPECT_EQ(output_.exit_code, 0) << output_.errors;
  const json figures = figures_in(text_in(folder_.path("a.html")));
  const json& touches = figures.at("touch");
  ASSERT_EQ(touches.size(), 2U);
  for (const json& touch : touches) {
    EXPECT_NEAR(touch.at("part_deviation"), -0.005, 1e-12);
    EXPECT_NEAR(touch.at("limits").at(0), -0.01, 1e-12);
    EXPECT_NEAR(touch.at("limits").at(1), 0.0, 1e-12);
  }
}

// Two touches of a wall 30 mm apart: the rise of the contacts over 30 is the angle of the wall.
TEST_F(CharacteristicPage, HasTheTrueAngleOfAWallBesideTheMeasuredOne) {
  const std::string sheet =
      "[start]\nZ = 150.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\nstem_diameter = 2.0\n"
      "[[part]]\nname = \"p\"\nshape = \"block\"\nat = [0.0, 0.0, 20.0]\n"
      "rotate_deg = [0.0, 0.0, 1.25]\n"
      "[[characteristic]]\nname = \"edge\"\nvariable = \"#160\"\nnominal = 1.2\n"
      "tolerance = 0.1\nunit = \"deg\"\ntrue = \"p.rotate_deg.Z\"\n";
  const std::string program =
      "O7\nG90 G0 X-15. Y-60.\nG1 Z115. F2000.\nG31 Y0. F300.\n#101=#5062\nG0 Y-60.\nG0 X15.\n"
      "G31 Y0. F300.\n#102=#5062\nG0 Y-60.\n#160=ATAN[#102-#101]/[30.]\nM30\n";
  output_ = g31({"run", folder_.write("a.nc", program), "-s", folder_.write("a.toml", sheet),
                 "--report", folder_.path("a.html"), "--json", folder_.path("a.json")});
  EXPECT_EQ(output_.exit_code, 0) << output_.errors;
  const json document = json::parse(text_in(folder_.path("a.json")));
  const json& row = document.at("characteristics").at(0);
  EXPECT_EQ(row.at("true"), 1.25);
  EXPECT_NEAR(row.at("measuring_error").get<double>(), 0.0, 1e-6);
  const std::string page = text_in(folder_.path("a.html"));
  EXPECT_NE(page.find(R"(data-l="True size">1.25</td>)"), std::string::npos);
  EXPECT_NE(page.find(R"(data-l="Measuring error">0.00 deg</td>)"), std::string::npos);
  const json figures = figures_in(page);
  EXPECT_FALSE(figures.at("touch").at(0).contains("part_deviation")) << "an angle is no size";
}

// From outside at X40 and from inside at X15: the wall of 40 - 15 is 25 less the wall's true 24.98.
TEST_F(CharacteristicPage, SplitsAWhiskerOfAWallThatAShapeWorksOut) {
  const std::string sheet =
      "[start]\nZ = 150.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\nstem_diameter = 2.0\n"
      "[[part]]\nname = \"p\"\nshape = \"ring\"\nbore = 30.04\nouter_diameter = 80.0\n"
      "at = [0.0, 0.0, 20.0]\n"
      "[[characteristic]]\nname = \"wall\"\nvariable = \"#160\"\nnominal = 25.0\n"
      "tolerance = 0.05\ntrue = \"p.wall\"\n"
      "[[characteristic]]\nname = \"place\"\nvariable = \"#161\"\nnominal = 0.0\n"
      "true = \"p.at.X\"\n";
  const std::string program =
      "O7\nG90 G0 X0. Y0.\nG1 Z115. F2000.\nG31 X60. F300.\n#101=#5061+3.\nG0 X0.\nG31 X-60. "
      "F300.\n"
      "#102=#5061-3.\nG0 X0.\nG0 Z140.\nG0 X60.\n"
      "G1 Z115. F2000.\nG31 X0. F300.\n#160=#5061-3.-#101\n#161=[#101+#102]/2.\nG0 X60.\nG0 "
      "Z140.\nM30\n";
  output_ = g31({"run", folder_.write("a.nc", program), "-s", folder_.write("a.toml", sheet),
                 "--report", folder_.path("a.html"), "--json", folder_.path("a.json")});
  EXPECT_EQ(output_.exit_code, 0) << output_.errors;
  const json document = json::parse(text_in(folder_.path("a.json")));
  const json& rows = document.at("characteristics");
  EXPECT_NEAR(rows[0].at("true").get<double>(), 24.98, 1e-12);
  EXPECT_NEAR(rows[0].at("measuring_error").get<double>(), 0.0, 1e-6);
  EXPECT_NEAR(rows[1].at("measuring_error").get<double>(), 0.0, 1e-6);
  const json figures = figures_in(text_in(folder_.path("a.html")));
  const json& touches = figures.at("touch");
  ASSERT_EQ(touches.size(), 3U);
  // A wall 0.02 too thin lies 0.01 deeper on either side of it.
  EXPECT_NEAR(touches[0].at("part_deviation"), 0.01, 1e-9);
  EXPECT_NEAR(touches[2].at("part_deviation"), 0.01, 1e-9);
  EXPECT_FALSE(touches[1].contains("part_deviation")) << "the bore itself is no wall, nor a place";
}

}  // namespace
}  // namespace g31::characteristics_test
