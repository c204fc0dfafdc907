// `g31 explain` beyond the controls: sheets, shapes, studies, codes, exit codes, models, search by
// words.

#include "tools/manual/manual.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/analysis/finding.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/source/diagnostic.h"
#include "parts/artefacts/artefact.h"
#include "parts/artefacts/worked_out.h"
#include "tests/support/captured.h"
#include "tools/cli/explain_command.h"
#include "tools/evaluate/data_error.h"
#include "tools/manual/entries.h"
#include "tools/review/setup_rules.h"
#include "tools/setup/true_sizes.h"
#include "tools/setup/value_words.h"
#include "tools/study/study_keys.h"

namespace g31::manual::manual_test {
namespace {

cli::ExitCode exit_code_of_last;

/// What `g31 explain` prints, standard error behind it.
std::string printed(const cli::ExplainOptions& options) {
  const auto said = testing::captured([&] { return explain_command(options); });
  exit_code_of_last = static_cast<cli::ExitCode>(said.exit_code);
  return said.out + said.errors;
}

std::string explained(const std::string& topic) {
  return printed({.topics = {topic}});
}

bool is_known(const std::string& topic) {
  return !manual::explain(topic, session::default_control()).empty();
}

std::size_t count_of(const runtime::Entries& entries, std::string_view kind) {
  return static_cast<std::size_t>(std::ranges::count(entries, kind, &runtime::Entry::kind));
}

/// Every row of every table: one entry, with a text, and nothing left of a format.
TEST(Manual, HasEveryRowOfEveryTable) {
  const runtime::Entries all = manual::everything(session::default_control());
  const auto fanuc_profiles = fanuc::profiles().size();
  EXPECT_EQ(count_of(all, "section of a set-up sheet"), setup::section_rows().size());
  EXPECT_EQ(count_of(all, "key of a set-up sheet"), setup::key_rows().size());
  EXPECT_EQ(count_of(all, "shape of a part"), parts::shapes().size());
  EXPECT_EQ(count_of(all, "size of a shape"), parts::shape_sizes().size());
  EXPECT_EQ(count_of(all, "what a shape works out"), parts::worked_out().size());
  EXPECT_EQ(count_of(all, "place of a part"), setup::true_places().size());
  EXPECT_EQ(count_of(all, "section of a study file"), study::study_sections().size());
  EXPECT_EQ(count_of(all, "key of a study file"), study::study_keys().size());
  EXPECT_EQ(count_of(all, "message of g31"), source::diagnostics().size());
  EXPECT_EQ(count_of(all, "error of a sheet"), setup::setup_error_rows().size());
  EXPECT_EQ(count_of(all, "finding of g31 setup"), review::setup_rules().size());
  EXPECT_EQ(count_of(all, "rule of g31 check"), analysis::rules().size());
  EXPECT_EQ(count_of(all, "error of a record"), evaluate::data_error_rows().size());
  EXPECT_EQ(count_of(all, "control"), fanuc_profiles + 1);
  const std::set<std::string> kCodes = {"message of g31", "error of a sheet",
                                        "finding of g31 setup", "rule of g31 check",
                                        "error of a record"};
  for (const runtime::Entry& entry : all) {
    SCOPED_TRACE(entry.kind + " " + entry.name);
    EXPECT_FALSE(entry.name.empty());
    EXPECT_EQ(entry.text.find("{}"), std::string::npos);
    EXPECT_NE(entry.text, "...");
    EXPECT_FALSE(kCodes.contains(entry.kind) && entry.text.empty());
  }
  EXPECT_GE(setup::key_rows().size(), 150U) << "the tables are there at all";
}

/// What is listed is also found by its name, as a user writes it.
TEST(Manual, FindsEveryRowByItsName) {
  for (const setup::SectionRow& row : setup::section_rows()) {
    EXPECT_TRUE(is_known(std::string(row.path))) << row.path;
    EXPECT_TRUE(is_known(std::string(row.example))) << row.example;
  }
  for (const setup::KeyRow& row : setup::key_rows()) {
    if (row.name_form == setup::NameForm::Exact) {
      EXPECT_TRUE(is_known(std::string(row.name))) << row.name;
      const std::string_view path = setup::row_of(row.section).path;
      EXPECT_TRUE(is_known(std::string(path) + "." + std::string(row.name))) << path << row.name;
    }
    EXPECT_FALSE(row.text.empty()) << row.name;
    EXPECT_FALSE(row.default_text.empty()) << row.name;
    EXPECT_FALSE(row.example.empty()) << row.name;
  }
  for (const parts::Shape& shape : parts::shapes()) {
    EXPECT_TRUE(is_known(std::string(shape.name))) << shape.name;
    EXPECT_NE(shape.text.find("origin"), std::string_view::npos) << shape.name;
  }
  for (const runtime::Entry& entry : all_code_entries()) {
    EXPECT_EQ(code_entries(entry.name).size(), 1U) << entry.name;
  }
}

TEST(Manual, SaysWhatAKeyTakes) {
  EXPECT_EQ(explained("probe.length"),
            "[probe] length (key of a set-up sheet)\n"
            "  spindle gauge line to ball centre: where the ball really is\n"
            "    value: a number\n"
            "    unit: mm\n"
            "    at most: 1000000 in size\n"
            "    without it: 120\n"
            "    for example: length = 120.0\n");
  EXPECT_NE(explained("machine.axes.X.travel").find("[machine.axes.X] travel (key"),
            std::string::npos);
  EXPECT_NE(explained("start.X").find("machine coordinate of the axis at the start"),
            std::string::npos);
  const std::string several = explained("length");
  EXPECT_NE(several.find("[probe] length"), std::string::npos);
  EXPECT_NE(several.find("[tools.99] length"), std::string::npos);
}

TEST(Manual, SaysWhichKeysASectionHas) {
  const std::string text = explained("[probe]");
  EXPECT_EQ(text.find("[probe] (section of a set-up sheet)\n  the touch probe in the spindle; "),
            0U);
  EXPECT_NE(text.find("    ball_diameter: diameter of the stylus ball (mm)\n"), std::string::npos);
  EXPECT_NE(text.find("    [[probe.ball]]: "), std::string::npos);
}

TEST(Manual, SaysSizesAndOriginOfAShape) {
  const std::string text = explained("ring");
  EXPECT_EQ(text.find("ring (shape of a part)\n  ring gauge: origin on the axis of the bore in the "
                      "top face, material from z = 0 to -height\n"),
            0U);
  EXPECT_NE(text.find("    bore: diameter of the bore; 39.996 if not given\n"), std::string::npos);
  EXPECT_NE(explained("ring.bore").find("bore of shape ring"), std::string::npos);
  EXPECT_NE(explained("part.bore").find("bore of shape ring"), std::string::npos);
  EXPECT_NE(explained("ring.wall").find("thickness between bore and outside"), std::string::npos);
  EXPECT_NE(explained("at.X").find("machine coordinate X of the part's origin"), std::string::npos);
}

TEST(Manual, KnowsCodesOnEveryControl) {
  for (const char* const control : {"", "haas", "sinumerik-828d"}) {
    const std::string text =
        printed({.topics = {"prb301", "SET103", "NC005", "DAT101"}, .control = control});
    EXPECT_EQ(exit_code_of_last, cli::ExitCode::Completed) << text;
    EXPECT_NE(text.find("PRB301 (message of g31)"), std::string::npos);
    EXPECT_NE(
        text.find("SET103 (error of a sheet)\n  unknown key ... in ..., ...\n    what to do: "),
        std::string::npos)
        << text;
  }
}

TEST(Manual, KnowsExitCodes) {
  for (const cli::ExitCodeRow& row : cli::exit_codes()) {
    const std::string number = std::to_string(static_cast<int>(row.code));
    const std::string expected =
        "exit " + number + " (exit code)\n  " + std::string(row.text) + "\n";
    EXPECT_EQ(explained("exit " + number), expected);
    EXPECT_EQ(printed({.topics = {"exit", "code", number}}), expected);
  }
}

/// Names on plates and in manuals, and the profile that the README and profile.cc give them.
TEST(Manual, KnowsModelsOfControls) {
  struct Model {
    const char* name;
    const char* profile;
  };
  constexpr Model kModels[] = {{"0i-MF", "fanuc-30i"},
                               {"0i-MF Plus", "fanuc-30i"},
                               {"0i-mc", "fanuc-0i"},
                               {"Fanuc 31i-B5", "fanuc-30i"},
                               {"HAAS", "haas"},
                               {"FANUC-0I", "fanuc-0i"},
                               {"828D", "sinumerik-828d"},
                               {"M700V", "meldas"},
                               {"21i-MB", "fanuc-16i"},
                               {"Brother C00", "brother"},
                               {"SINUMERIK 828D", "sinumerik-828d"}};
  for (const Model& model : kModels) {
    const auto control = session::control_named(model.name);
    ASSERT_TRUE(control) << model.name << ": " << control.error();
    EXPECT_EQ(session::name_of(control.value()), model.profile) << model.name;
    EXPECT_NE(explained(model.name).find(std::string(model.profile) + " (control)"),
              std::string::npos);
  }
  for (const char* const other : {"sinumerik-840d", "heidenhain", "0i", "0i-TF", ""}) {
    EXPECT_FALSE(session::control_named(other)) << other;
  }
  EXPECT_NE(explained("fanuc-30i").find("covers: 0i-MD, 0i-MF, 0i-D, 0i-F, 30i, 31i, 32i\n"),
            std::string::npos);
}

TEST(Manual, FindsByWords) {
  const std::string skip = explained("skip");
  EXPECT_EQ(exit_code_of_last, cli::ExitCode::Completed);
  EXPECT_EQ(skip.find("'skip' is found in:\n"), 0U) << skip;
  EXPECT_NE(skip.find("  G31 (G code): "), std::string::npos);
  EXPECT_NE(skip.find("  PRB301 (message of g31): "), std::string::npos);
  const std::string ball = explained("ball");
  EXPECT_NE(
      ball.find("  [probe] ball_diameter (key of a set-up sheet): diameter of the stylus ball\n"),
      std::string::npos)
      << ball;
  const std::string both = explained("stylus BALL");
  EXPECT_LT(both.size(), ball.size());
  EXPECT_NE(both.find("[probe] ball_diameter"), std::string::npos);
  const std::string text = printed({.topics = {"G31"}, .search = true});
  EXPECT_EQ(text.find("'G31' is found in:\n  G31 (G code): "), 0U) << "names first";
}

TEST(Manual, SuggestsKeysAndShapes) {
  EXPECT_NE(explained("ball_diamter").find("did you mean 'ball_diameter'?"), std::string::npos);
  EXPECT_EQ(exit_code_of_last, cli::ExitCode::BadUsage);
  EXPECT_NE(explained("spheer").find("did you mean 'sphere'?"), std::string::npos);
}

/// Numbers on both sides of each range, once more as the comments of keys.h have them.
TEST(ValueWords, RangesAreThoseOfTheWords) {
  using setup::Limit;
  using setup::number_within;
  EXPECT_FALSE(number_within(Limit::Positive, 0.0));
  EXPECT_TRUE(number_within(Limit::Positive, 1e-12));
  EXPECT_TRUE(number_within(Limit::NotNegative, 0.0));
  EXPECT_FALSE(number_within(Limit::NotNegative, -1e-12));
  EXPECT_FALSE(number_within(Limit::Bit, 0.5));
  EXPECT_FALSE(number_within(Limit::DigitalInput, 65.0));
  EXPECT_TRUE(number_within(Limit::DigitalInput, 1015.0));
  EXPECT_TRUE(number_within(Limit::SensorWord, 135.0));
  EXPECT_FALSE(number_within(Limit::SensorWord, 136.0));
  EXPECT_FALSE(number_within(Limit::TipAngle, 0.0));
  EXPECT_TRUE(number_within(Limit::TipAngle, 180.0));
  EXPECT_TRUE(number_within(Limit::Any, -1e300));
  EXPECT_EQ(setup::choices_of(Limit::IncrementSystem),
            (std::vector<std::string>{"IS-A", "IS-B", "IS-C"}));
  EXPECT_TRUE(setup::choices_of(Limit::ProgramSwitch).empty());
}

}  // namespace
}  // namespace g31::manual::manual_test
