// What is wrong with a study file is said with its place, before anything runs.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tests/support/run_study.h"

namespace g31::study_errors_test {
namespace {

using testing::run_study;
using testing::StudyOutput;
using testing::TemporaryFolder;

class StudyErrors : public ::testing::Test {
 protected:
  StudyErrors() {
    folder_.write("p.nc", "%\nO1\n#101= #501\nM30\n%\n");
    folder_.write("s.toml",
                  "[variables]\n\"#501\" = 3.0\n[[part]]\nname = \"plug\"\nshape = "
                  "\"plug\"\n[probe]\n");
  }

  StudyOutput run(const std::string& text) {
    cli::StudyOptions options;
    options.study = folder_.write("study.toml", text);
    return run_study(options);
  }

  TemporaryFolder folder_;
};

constexpr const char* kHead = "[study]\nprogram = \"p.nc\"\nsetup = \"s.toml\"\n";
constexpr const char* kResult = "[results.a]\nvalue = \"#101\"\n";

struct FileCase {
  const char* name;
  std::string text;
  const char* place;  ///< line and column
  const char* message;
};

void expect_refused(const FileCase& c, const StudyOutput& output) {
  SCOPED_TRACE(c.name);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find(std::string("study.toml") + c.place), std::string::npos)
      << output.errors;
  EXPECT_NE(output.errors.find(std::string("error: ") + c.message), std::string::npos)
      << output.errors;
  EXPECT_EQ(output.out, "");
}

TEST_F(StudyErrors, TheRunsOfAStudyAreOnOneControl) {
  folder_.write("haas.toml", "[control]\nprofile = \"haas\"\n");
  folder_.write("same.toml", "[control]\nprofile = \"fanuc-16i\"\n");
  const std::string head = std::string(kHead) + kResult;
  for (const char* const vary : {"key = \"control.profile\"\nvalues = [\"fanuc-16i\", \"haas\"]\n",
                                 "key = \"setup\"\nvalues = [\"same.toml\", \"haas.toml\"]\n"}) {
    const StudyOutput output = run(head + "[[vary]]\n" + vary);
    EXPECT_EQ(output.exit_code, 5) << output.errors;
    EXPECT_NE(output.errors.find("the runs of a study are on one control, here on fanuc-16i and "
                                 "haas; write a study for each"),
              std::string::npos)
        << output.errors;
    EXPECT_EQ(output.out, "");
    const std::string named = "control = \"haas\"\n";
    EXPECT_EQ(run(kHead + named + kResult + "[[vary]]\n" + vary).exit_code, 0);
  }
  EXPECT_EQ(
      run(head + "[[vary]]\nkey = \"setup\"\nvalues = [\"same.toml\", \"s.toml\"]\n").exit_code, 0)
      << "without a name it is that of the program";
}

TEST_F(StudyErrors, OfKeysHavePlaceReasonAndWhatWouldBeRight) {
  const std::string head = kHead;
  const std::string good = head + kResult;
  const FileCase kCases[] = {
      {"no TOML", "[study\n", ":1:", "this is not TOML"},
      {"an unknown section", good + "[stdy]\n",
       ":6:2:", "unknown key stdy in the study file, did you mean study?"},
      {"an unknown key", head + "repeat = 3\n" + kResult,
       ":4:1:", "unknown key repeat in [study], did you mean repeats?"},
      {"a key of the wrong type", head + "repeats = \"3\"\n" + kResult,
       ":4:11:", "repeats is a string, it should be a whole number"},
      {"no run at all", head + "repeats = 0\n" + kResult,
       ":4:11:", "repeats is 0, it should be greater than 0"},
      {"an unknown table", head + "table = \"sumary\"\n" + kResult,
       ":4:9:", "table is \"sumary\", it should be \"summary\" or \"readings\" or \"comparison\""},
      {"a certain confidence", head + "confidence = 100\n" + kResult,
       ":4:14:", "confidence is 100, it should be below 100"},
      {"no program", "[study]\n[results.a]\nvalue = \"#1\"\n", ":1:2:", "[study] needs program"},
      {"no [study]", kResult, ":1:1:", "[study] needs program"},
      {"no result", kHead, ":1:1:", "the study needs a result"},
      {"an expected value beyond all", good + "expected = 1e308\n",
       ":6:12:", "expected is 1e+308, it should be 1000000000 that of unit at most"},
      {"a published value beyond all", good + "published = [3.0, -2e9]\n",
       ":6:19:", "published is -2000000000, it should be 1000000000 that of unit at most"},
      {"a result without value", head + "[results.a]\nunit = \"mm\"\n",
       ":4:10:", "[results.a] needs value"},
      {"a result that is no formula", head + "[results.a]\nvalue = \"#101 +\"\n", ":5:9:",
       "#101 + is not a result: at character 7: a variable, a number or a bracket is expected"},
  };
  for (const FileCase& c : kCases) {
    expect_refused(c, run(c.text));
  }
}

TEST_F(StudyErrors, OfVariationsThatSayMoreThanTakesEffect) {
  const std::string good = std::string(kHead) + kResult;
  const FileCase kCases[] = {
      {"one variable in two spellings",
       good + "[[vary]]\nkey = \"variables.#100\"\nvalues = [1.0]\n[[vary]]\n"
              "key = \"variables.#0100\"\nvalues = [7.0]\n",
       ":10:7:", "this variation is a second one of variables.#100"},
      {"a place and one of its numbers",
       good + "[[vary]]\nkey = \"part.plug.at.X\"\nvalues = [1.0]\n[[vary]]\n"
              "key = \"part.plug.at\"\nvalues = [[1.0, 2.0, 3.0]]\n",
       ":10:7:", "this variation is a second one of part.plug.at.X"},
      {"a width that nothing takes",
       good + "[[vary]]\nkey = \"probe.length\"\ndistribution = \"normal\"\nmean = 1.0\n"
              "deviation = 0.1\nlow = 0.5\n",
       ":11:7:", "this variation has low, which a normal distribution does not take"},
      {"a mean beside a list",
       good + "[[vary]]\nkey = \"probe.length\"\nvalues = [1.0]\nmean = 1.0\n",
       ":9:8:", "this variation has mean, which a list of values does not take"},
      {"a value twice", good + "[[vary]]\nkey = \"probe.length\"\nvalues = [50.0, 50.0]\n",
       ":8:17:", "this variation has two values called 50"},
      {"a label twice",
       good + "[[vary]]\nkey = \"probe.length\"\nvalues = [50.0, 51.0]\n"
              "labels = [\"a\", \"a\"]\n",
       ":8:17:", "this variation has two values called a"}};
  for (const FileCase& c : kCases) {
    expect_refused(c, run(c.text));
  }
}

TEST_F(StudyErrors, OfVariationsHavePlaceReasonAndWhatWouldBeRight) {
  const std::string head = kHead;
  const std::string good = head + kResult;
  const FileCase kCases[] = {
      {"a variation of nothing", good + "[[vary]]\nkey = \"probe.ball_diameter\"\n",
       ":6:1:", "this variation has neither values nor a distribution"},
      {"two ways to vary",
       good + "[[vary]]\nkey = \"probe.length\"\nvalues = [1.0]\ndistribution = "
              "\"normal\"\n",
       ":6:1:", "this variation has both values and a distribution"},
      {"one key twice",
       good +
           "[[vary]]\nkey = \"probe.length\"\nvalues = [50.0]\n[[vary]]\nkey = \"probe.length\"\n"
           "distribution = \"uniform\"\nlow = 1.0\nhigh = 2.0\n",
       ":10:7:", "this variation is a second one of probe.length"},
      {"no values", good + "[[vary]]\nkey = \"probe.length\"\nvalues = []\n",
       ":8:10:", "values is an empty array, it should be an array of values"},
      {"an unknown section of the sheet",
       good + "[[vary]]\nkey = \"prob.length\"\nvalues = [1.0]\n", ":7:7:",
       "prob.length cannot be varied: no section of a set-up sheet begins like this, did "
       "you mean probe?"},
      {"an unknown key of the sheet", good + "[[vary]]\nkey = \"probe.lenght\"\nvalues = [1.0]\n",
       ":7:7:", "probe.lenght cannot be varied: probe has no key lenght, did you mean length?"},
      {"a value that the key does not take",
       good + "[[vary]]\nkey = \"probe.ball_diameter\"\nvalues = [6.0, -1.0]\n",
       ":8:16:", "probe.ball_diameter is -1, it should be greater than 0"},
      {"an unknown part", good + "[[vary]]\nkey = \"part.plog.diameter\"\nvalues = [30.0]\n",
       ":8:11:", "part.plog.diameter cannot be varied: there is no part plog, did you mean plug?"},
      {"a size that the shape has not",
       good + "[[vary]]\nkey = \"part.plug.bore\"\nvalues = [30.0]\n",
       ":8:11:", "part.plug.bore cannot be varied: shape plug has no size bore"},
      {"a name that is none", good + "[[vary]]\nkey = \"work_offsets.G53.X\"\nvalues = [30.0]\n",
       ":7:7:",
       "work_offsets.G53.X cannot be varied: G53 is not a name in [work_offsets], did you mean "
       "G54?"},
      {"labels that are too few",
       good + "[[vary]]\nkey = \"probe.length\"\nvalues = [1.0, 2.0]\nlabels = [\"a\"]\n",
       ":9:10:", "this variation has 1 labels for 2 values"},
      {"a normal distribution without width",
       good + "[[vary]]\nkey = \"probe.length\"\ndistribution = \"normal\"\nmean = 1.0\n",
       ":8:16:", "a normal distribution needs deviation"},
      {"a uniform distribution upside down",
       good +
           "[[vary]]\nkey = \"probe.length\"\ndistribution = \"uniform\"\nlow = 2.0\nhigh = 1.0\n",
       ":9:7:", "this variation has its low end above the high one"},
      {"a text that is drawn",
       good +
           "[[vary]]\nkey = \"probe.seats\"\ndistribution = \"uniform\"\nlow = 1.0\nhigh = 2.0\n",
       ":7:7:", "probe.seats cannot be varied: it takes no number of a range; list its values"},
      {"a comparison of three",
       head + "table = \"comparison\"\n" + kResult +
           "[[vary]]\nkey = \"probe.length\"\nvalues = [1.0, 2.0, 3.0]\n",
       ":4:9:", "table is \"comparison\" of 3 set-ups, it should be of two"},
      {"too many runs", head + "repeats = 100000000\n" + kResult,
       ":1:2:", "the number of runs is 100000000, it should be 10000000 at most"},
  };
  for (const FileCase& c : kCases) {
    expect_refused(c, run(c.text));
  }
}

TEST_F(StudyErrors, OfWhatAStudyNamesComeBeforeItsRuns) {
  struct Case {
    const char* name;
    std::string text;
    const char* message;
    int exit_code;
  };
  const std::string head = kHead;
  const Case kCases[] = {
      {"no such program", "[study]\nprogram = \"q.nc\"\n" + std::string(kResult),
       "cannot read the program", 2},
      {"no such sheet", "[study]\nprogram = \"p.nc\"\nsetup = \"t.toml\"\n" + std::string(kResult),
       "cannot read the file: no such file", 2},
      {"no such control", head + "control = \"fanuc-16\"\n" + kResult,
       "unknown control 'fanuc-16', did you mean 'fanuc-16i'?", 5},
      {"a variable that the control has not", head + "[results.a]\nvalue = \"#99999\"\n",
       "a result reads #99999: #99999 cannot be read on this control", 2},
      {"a sheet of a list that is not there",
       head + kResult + "[[vary]]\nkey = \"setup\"\nvalues = [\"s.toml\", \"u.toml\"]\n",
       "cannot read the file: no such file", 2},
      {"a shape whose sizes do not fit",
       head + kResult + "[[vary]]\nkey = \"part.plug.foot_diameter\"\nvalues = [1.0]\n", "plug", 5},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const StudyOutput output = run(c.text);
    EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
    EXPECT_NE(output.errors.find(c.message), std::string::npos) << output.errors;
    EXPECT_EQ(output.out, "");
  }
}

TEST_F(StudyErrors, ADrawnValueThatTheKeyDoesNotTakeEndsItsRunOnly) {
  const StudyOutput output =
      run(std::string(kHead) + "repeats = 40\n" + kResult +
          "[[vary]]\nkey = \"probe.repeatability_mm\"\ndistribution = \"normal\"\nmean = "
          "0.001\ndeviation = 0.001\n");
  EXPECT_EQ(output.exit_code, 5);
  EXPECT_NE(output.errors.find("runs ended with setup"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("probe.repeatability_mm was drawn as -"), std::string::npos)
      << output.errors;
}

TEST_F(StudyErrors, OfTheCommandLine) {
  struct Case {
    const char* name;
    cli::StudyOptions options;
    const char* message;
  };
  const std::string study = folder_.write("good.toml", std::string(kHead) + kResult);
  cli::StudyOptions none;
  cli::StudyOptions shard;
  shard.study = study;
  shard.shard = "1/2";
  cli::StudyOptions third_of_two = shard;
  third_of_two.shard = "3/2";
  third_of_two.json = folder_.path("a.json");
  cli::StudyOptions both;
  both.study = study;
  both.json = "-";
  both.csv = "-";
  cli::StudyOptions merge_and_study;
  merge_and_study.study = study;
  merge_and_study.merge = {"a.json"};
  cli::StudyOptions nowhere;
  nowhere.study = study;
  nowhere.json = folder_.path("no/such/folder.json");
  const Case kCases[] = {
      {"nothing to do", none, "a study file is missing"},
      {"a shard that goes nowhere", shard, "--shard needs --json FILE"},
      {"part 3 of 2", third_of_two, "--shard 3/2: write i/n"},
      {"two documents on standard output", both, "--json and --csv cannot both be standard output"},
      {"merging while running", merge_and_study, "--merge takes shards only"},
      {"a folder that is not there", nowhere, "cannot write"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const StudyOutput output = run_study(c.options);
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(c.message), std::string::npos) << output.errors;
  }
}

/// A tetrahedron of 10 mm, the last `missing` of its four facets left out.
std::string tetrahedron(int missing) {
  const char* const kFacets[] = {
      "vertex 0 0 0 vertex 0 10 0 vertex 10 0 0", "vertex 0 0 0 vertex 10 0 0 vertex 0 0 10",
      "vertex 0 0 0 vertex 0 0 10 vertex 0 10 0", "vertex 10 0 0 vertex 0 10 0 vertex 0 0 10"};
  std::string text = "solid t\n";
  for (int i = 0; i < 4 - missing; ++i) {
    text += std::string("facet normal 0 0 0 outer loop ") + kFacets[i] + " endloop endfacet\n";
  }
  return text + "endsolid t\n";
}

TEST_F(StudyErrors, OfMeshesAreFindingsOfEveryRun) {
  folder_.write("s.toml",
                "[variables]\n\"#501\" = 3.0\n[[part]]\nfile = \"t.stl\"\n[probe]\n"
                "[start]\nZ = 300.0\n");
  folder_.write("t.stl", tetrahedron(0));
  const StudyOutput whole = run(std::string(kHead) + kResult);
  EXPECT_EQ(whole.exit_code, 0) << whole.errors;
  EXPECT_EQ(whole.errors, "");
  folder_.write("t.stl", tetrahedron(1));
  const StudyOutput open = run(std::string(kHead) + kResult);
  EXPECT_EQ(open.exit_code, 1) << open.errors;
  EXPECT_NE(open.errors.find("in the mesh of a part: 3 of 't'"), std::string::npos) << open.errors;
  EXPECT_NE(open.errors.find("[PRB511]"), std::string::npos) << open.errors;
}

}  // namespace
}  // namespace g31::study_errors_test
