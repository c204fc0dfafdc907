// `g31 study`: what a study varies beyond the values that the sheet has, and what shares no parts.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_study.h"
#include "tests/support/temporary_folder.h"

namespace g31::study_vary_test {
namespace {

using nlohmann::json;
using testing::study_document;
using testing::StudyOutput;
using testing::TemporaryFolder;

/// Touches the face X+ of a block: #501 is where the ball's centre stood, seen from G54.
const char* const kTouch =
    "%\nO1\nG90 G54 G00 X60. Y0.\nG43 H1 Z-10.\nG31 X20. F100.\n#501=#5061\nG00 X60.\nM30\n%\n";

const char* const kHead =
    "[control]\nprofile = \"fanuc-30i\"\n"
    "[work_offsets.G54]\nX = 10.0\nY = 0.0\nZ = -300.0\n[tools.1]\nlength = 120.0\n"
    "[probe]\nball_diameter = 6.0\nlength = 120.0\n";

/// The values of `result` with each of the listed values in turn.
std::vector<double> readings(const std::string& program, const std::string& sheet,
                             const std::string& result, const std::string& vary) {
  const TemporaryFolder folder;
  folder.write("p.nc", program);
  folder.write("sheet.toml", sheet);
  cli::StudyOptions options;
  options.study =
      folder.write("study.toml", fmt::format("[study]\nprogram = \"p.nc\"\nsetup = \"sheet.toml\"\n"
                                             "[results.r]\nvalue = \"{}\"\n[[vary]]\n{}",
                                             result, vary));
  const StudyOutput output = study_document(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::vector<double> values;
  if (output.exit_code == 0) {
    const json document = json::parse(output.out);
    for (const json& row : document.at("rows")) {
      values.push_back(row.at("results").at(0));
    }
  }
  return values;
}

void expect_near(const std::vector<double>& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(values[i], expected[i], 1e-9) << "value " << i;
  }
}

TEST(StudyVary, ANameThatTheSheetHasNotComesWithItsFirstKey) {
  expect_near(readings("%\nO1\n#101=#5241\nM30\n%\n", kHead, "#101",
                       "key = \"work_offsets.G55.X\"\nvalues = [100.0, 101.0]\n"),
              {100.0, 101.0});
  expect_near(readings("%\nO1\nG43 H2 Z0.\n#101=#5083\nM30\n%\n", kHead, "#101",
                       "key = \"tools.2.length\"\nvalues = [70.0, 71.5]\n"),
              {70.0, 71.5});
}

TEST(StudyVary, APartOnAnOffsetGoesAlongWithIt) {
  const std::string sheet =
      std::string(kHead) +
      "[[part]]\nname = \"b\"\nshape = \"block\"\nlength = 60.0\non = \"G54\"\n";
  const double face = 30.0 + 3.0;
  expect_near(
      readings(kTouch, sheet, "#501", "key = \"work_offsets.G54.X\"\nvalues = [5.0, 10.0, 0.0]\n"),
      {face, face, face});
  expect_near(
      readings(kTouch, sheet, "#501", "key = \"work_offsets.EXT.X\"\nvalues = [0.0, 4.0]\n"),
      {face, face});
  for (const double value : readings(
           kTouch, sheet, "#501",
           "key = \"work_offsets.G54.X\"\ndistribution = \"uniform\"\nlow = 5.0\nhigh = 15.0\n")) {
    EXPECT_NEAR(value, face, 1e-9);
  }
}

// One that lies on the machine stays where it is.
TEST(StudyVary, APartOnTheMachineDoesNot) {
  const std::string sheet = std::string(kHead) +
                            "[[part]]\nname = \"b\"\nshape = \"block\"\nlength = 60.0\n"
                            "at = [10.0, 0.0, -300.0]\n";
  expect_near(
      readings(kTouch, sheet, "#501", "key = \"work_offsets.G54.X\"\nvalues = [10.0, 5.0, 12.0]\n"),
      {33.0, 38.0, 31.0});
}

// The second probe, 100 mm beside the first, touches a block whose face X+ is at 142.
// Numbers beside the varied one are those of the sheet, or the documented ones.
TEST(StudyVary, OneNumberOfAListThatTheSheetHasNot) {
  expect_near(readings(kTouch,
                       std::string(kHead) + "[[part]]\nname = \"b\"\nshape = \"block\"\n"
                                            "height = 40.0\non = \"G54\"\n",
                       "#501", "key = \"part.b.at.X\"\nvalues = [0.0, 0.5]\n"),
              {33.0, 33.5});
  const TemporaryFolder folder;
  folder.write("p.nc", "O1\nM30\n");
  folder.write("sheet.toml", kHead);
  for (const std::string& key :
       {std::string("probe.at.X"), std::string("believed.axes.A.centre.Y")}) {
    cli::StudyOptions options;
    options.study =
        folder.write("study.toml",
                     "[study]\nprogram = \"p.nc\"\nsetup = \"sheet.toml\"\n[results.r]\nvalue = "
                     "\"#101\"\n[[vary]]\nkey = \"" +
                         key + "\"\nvalues = [0.0, 0.5]\n");
    const StudyOutput output = study_document(options);
    EXPECT_EQ(output.exit_code, 2) << key << output.errors;
    EXPECT_NE(output.errors.find("whose other numbers stay"), std::string::npos) << output.errors;
  }
}

TEST(StudyVary, TheBallOfTheSecondProbe) {
  const std::string sheet = std::string(kHead) +
                            "[probe.second]\nat = [100.0, 0.0, 0.0]\nball_diameter = 6.0\n"
                            "[[part]]\nname = \"far\"\nshape = \"block\"\nlength = 60.0\n"
                            "at = [112.0, 0.0, -300.0]\n";
  const double face = 142.0 - 100.0 - 10.0;
  expect_near(readings(kTouch, sheet, "#501",
                       "key = \"probe.second.ball_diameter\"\nvalues = [6.0, 20.0]\n"),
              {face + 3.0, face + 10.0});
}

}  // namespace
}  // namespace g31::study_vary_test
