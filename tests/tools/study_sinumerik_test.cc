// `g31 study` of programs of a SINUMERIK: results by the names of its variables.

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/measuring_run.h"
#include "tests/support/run_study.h"

namespace g31::testing::study_sinumerik_test {
namespace {

using nlohmann::json;

/// A study of "part.mpf" with "sheet.toml".
class SinumerikStudy {
 public:
  SinumerikStudy(const std::string& program, const std::string& sheet) {
    folder_.write("part.mpf", program);
    folder_.write("sheet.toml", sheet);
  }

  /// @param head  further lines of [study]; @param tail  tables behind it
  [[nodiscard]] cli::StudyOptions options(const std::string& head, const std::string& tail) const {
    cli::StudyOptions made;
    made.study =
        folder_.write("study.toml", "[study]\nprogram = \"part.mpf\"\nsetup = \"sheet.toml\"\n" +
                                        head + "\n" + tail);
    return made;
  }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

/// The results of every run, in turn.
std::vector<std::vector<double>> results_in(const StudyOutput& output) {
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::vector<std::vector<double>> all;
  const json document = json::parse(output.out);
  for (const json& row : document.at("rows")) {
    all.push_back(row.at("results").get<std::vector<double>>());
  }
  return all;
}

TEST(SinumerikStudy, ComputesWithRParametersAndResults) {
  const SinumerikStudy study("R10=R5*R5\n_OVR[4]=R5+R6\n_OVI[2]=977\nM30\n",
                             "[variables]\nR5 = 3.0\nR6 = 4.0\n");
  const StudyOutput output = study_document(study.options(
      "",
      "[results.sum]\nvalue = \"_OVR[4]\"\n[results.less]\nvalue = \"R10 - _OVR[4] + _OVI[2]\"\n"
      "[[vary]]\nkey = \"variables.R5\"\nvalues = [3.0, 5.0]\n"));
  EXPECT_EQ(results_in(output),
            (std::vector<std::vector<double>>{{7.0, 979.0}, {9.0, 25.0 - 9.0 + 977.0}}));
  EXPECT_EQ(json::parse(output.out).at("study").at("control"), "sinumerik-828d");
}

TEST(SinumerikStudy, ReadsLocalVariablesOfTheMainProgram) {
  const SinumerikStudy study("DEF REAL DIA=1, LIST[3]\nLIST[2]=R5\nDIA=LIST[2]*2\nM30\n",
                             "[variables]\nR5 = 3.0\n");
  const StudyOutput output =
      study_document(study.options("", "[results.a]\nvalue = \"DIA + LIST[2]\"\n"));
  EXPECT_EQ(results_in(output), (std::vector<std::vector<double>>{{9.0}}));
}

TEST(SinumerikStudy, KeepsWhatAProgramBeforeLeaves) {
  const SinumerikStudy study("DEF REAL SUM\nSUM=$SNS_MEA_WP_BALL_DIAM[0]+R1\nM30\n", "");
  study.folder().write("calibrate.mpf", "$SNS_MEA_WP_BALL_DIAM[0]=5.5\nR1=1\nM30\n");
  const StudyOutput output = study_document(
      study.options("before = \"calibrate.mpf\"\n", "[results.a]\nvalue = \"SUM\"\n"));
  EXPECT_EQ(results_in(output), (std::vector<std::vector<double>>{{6.5}}));
}

TEST(SinumerikStudy, MeasuresAHoleOfEachSizeWithAnyNumberOfThreads) {
  const SinumerikStudy study("T1 M6\nG54 D1\nG0 X0 Y0 Z20\nZ-5\nCYCLE977(1,,,1,40,,,2,5)\nM30\n",
                             std::string(kMeasuringSheet) + kCalibrated +
                                 part("ring", 100.0, 50.0, -300.0, "bore = 40.0"));
  cli::StudyOptions options =
      study.options("repeats = 3\n",
                    "[results.diameter]\nvalue = \"_OVR[4]\"\n"
                    "[[vary]]\nkey = \"part.ring.bore\"\nvalues = [40.0, 40.5]\n"
                    "[[vary]]\nkey = \"probe.repeatability_mm\"\nvalues = [0.0, 0.001]\n");
  options.threads = 1;
  const StudyOutput one = study_document(options);
  const auto results = results_in(one);
  ASSERT_EQ(results.size(), 12U);
  for (std::size_t run = 0; run < results.size(); ++run) {
    const double bore = run < 6 ? 40.0 : 40.5;
    const bool scatters = run / 3 % 2 == 1;
    EXPECT_NEAR(results[run][0], bore, scatters ? 0.02 : 1e-6) << run;
  }
  EXPECT_NE(results[3][0], results[4][0]) << "the probe scatters";
  options.threads = 3;
  EXPECT_EQ(study_document(options).out, one.out);
}

TEST(SinumerikStudy, RefusesWhatIsNoNumber) {
  struct Case {
    const char* value;
    const char* message;
  };
  const Case kCases[] = {{"#100", "a result reads #100"},
                         {"NOSUCHGUD[3]", "a result reads NOSUCHGUD[3]"},
                         {"_OVS_TNAME", "a result reads _OVS_TNAME: it is a text"}};
  const SinumerikStudy study("R1=1\nM30\n", "");
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.value);
    const StudyOutput output =
        run_study(study.options("", std::string("[results.a]\nvalue = \"") + c.value + "\"\n"));
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(c.message), std::string::npos) << output.errors;
  }
}

}  // namespace
}  // namespace g31::testing::study_sinumerik_test
