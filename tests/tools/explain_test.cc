// `g31 explain` as a command: text, document, exit codes.

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/explain_command.h"

namespace g31::cli::explain_test {
namespace {

struct Output {
  ExitCode code;
  std::string text;
  std::string errors;
};

Output explain(const ExplainOptions& options) {
  const auto said = testing::captured([&] { return explain_command(options); });
  return {static_cast<ExitCode>(said.exit_code), said.out, said.errors};
}

TEST(ExplainCommand, PrintsTheEntry) {
  const Output output = explain({.topics = {"#5063"}, .control = "haas"});
  EXPECT_EQ(output.code, ExitCode::Completed);
  EXPECT_EQ(output.errors, "");
  EXPECT_EQ(output.text,
            "#5063 (system variable)\n"
            "  position latched by the last skip move, work coordinates, tool offset included, "
            "axis n; in a "
            "tilted plane its coordinates, less #5081 and on the tip\n"
            "    here: Z\n"
            "    numbers: #5061 to #5080\n"
            "    unit: mm or inch, whichever is in force; degrees of A, B and C\n"
            "    access: read only\n");
}

TEST(ExplainCommand, KnowsTheFamilyOfANumberedName) {
  const Output output = explain({.topics = {"R12", "R[5]", "G520"}, .control = "sinumerik-828d"});
  EXPECT_EQ(output.code, ExitCode::Completed);
  EXPECT_EQ(output.text.find("R0 to R999 (variable)\n"), 0U);
  EXPECT_NE(output.text.find("G505 (G code)\n"), std::string::npos);
}

TEST(ExplainCommand, KnowsEvaluationsAndWhatTheySay) {
  const Output output = explain({.topics = {"circle", "spike_X", "squareness"}});
  EXPECT_EQ(output.code, ExitCode::Completed);
  EXPECT_EQ(output.text.find("circle (evaluation)\n"), 0U);
  EXPECT_NE(output.text.find("    command: g31 evaluate circle FILE.csv\n"), std::string::npos);
  EXPECT_NE(output.text.find("    --radius R: "), std::string::npos);
  EXPECT_NE(output.text.find("    hysteresis: "), std::string::npos);
  EXPECT_EQ(output.text.find("    --side A: "), std::string::npos);
  EXPECT_NE(output.text.find("spike_* (result of an evaluation)\n"), std::string::npos);
  EXPECT_NE(output.text.find("squareness (result of an evaluation)\n"), std::string::npos);
}

TEST(ExplainCommand, TakesTheWordAlarmAndItsNumberAsOneTopic) {
  const Output output = explain({.topics = {"alarm", "112", "G31"}});
  EXPECT_EQ(output.code, ExitCode::Completed);
  EXPECT_EQ(output.text.substr(0, 28), "112 DIVIDED BY ZERO (alarm)\n");
  EXPECT_NE(output.text.find("G31 (G code)\n"), std::string::npos);
}

TEST(ExplainCommand, WritesADocument) {
  const Output output = explain({.topics = {"G31", "#500"}, .control = "meldas", .json = "-"});
  const auto document = nlohmann::json::parse(output.text);
  EXPECT_EQ(document["schema"], "g31.explain/1");
  EXPECT_EQ(document["control"], "meldas");
  ASSERT_EQ(document["entries"].size(), 2U);
  EXPECT_EQ(document["entries"][0]["kind"], "G code");
  EXPECT_EQ(document["entries"][0]["facts"]["in force"], "in its own block only");
  EXPECT_EQ(document["entries"][1]["name"], "#500");
}

TEST(ExplainCommand, KnowsWhatTheShippedSinumerikProgramsSayOfThemselves) {
  const Output output = explain(
      {.topics = {"cycle978", "_OVR[4]", "alarm", "61301", "61103"}, .control = "sinumerik-828d"});
  EXPECT_EQ(output.code, ExitCode::Completed) << output.errors;
  EXPECT_EQ(output.text.find("CYCLE978 (program)\n  One point of a surface across an axis. The "),
            0U);
  EXPECT_NE(output.text.find("1 the additive one of DL=S_DLNUM"), std::string::npos);
  EXPECT_NE(output.text.find("takes the additive one over.\n    form: CYCLE978(INT S_MVAR"),
            std::string::npos);
  const std::size_t results = output.text.find("_OVR[1000] (global variable)\n");
  ASSERT_NE(results, std::string::npos);
  EXPECT_NE(output.text.find("    [4]: measured value", results), std::string::npos);
  EXPECT_EQ(output.text.find("    [5]:", results), std::string::npos) << "not asked for";
  EXPECT_NE(output.text.find("61301 probe does not switch (alarm)\n  nothing was touched"),
            std::string::npos);
  EXPECT_NE(output.text.find("61103 Number of holes is zero (alarm)\n"), std::string::npos);
  const Output all = explain({.topics = {"_OVI"}, .control = "sinumerik-828d"});
  EXPECT_NE(all.text.find("    [2]:"), std::string::npos);
  EXPECT_NE(all.text.find("    [9]:"), std::string::npos);
}

TEST(ExplainCommand, NamesTheControlThatKnowsATopic) {
  const Output output = explain({.topics = {"CYCLE977"}, .control = "fanuc-16i"});
  EXPECT_EQ(output.code, ExitCode::BadUsage);
  EXPECT_EQ(output.errors,
            "g31: error: fanuc-16i does not know 'CYCLE977', --control sinumerik-828d does\n");
  const Output near = explain({.topics = {"CYCLE9777"}, .control = "sinumerik-828d"});
  EXPECT_NE(near.errors.find("did you mean 'CYCLE977'?"), std::string::npos) << near.errors;
}

TEST(ExplainCommand, LooksInAllControlsWhereNoneIsNamed) {
  for (const char* const topic : {"61301", "CYCLE974", "_OVR[5]", "54740", "S_TSA"}) {
    const Output output = explain({.topics = {topic}});
    EXPECT_EQ(output.code, ExitCode::Completed) << topic << output.errors;
    EXPECT_NE(output.text.find("    control: sinumerik-828d\n"), std::string::npos) << output.text;
  }
  const Output both = explain({.topics = {"G54"}});
  EXPECT_EQ(both.text.find("sinumerik"), std::string::npos) << "the default's own comes first";
}

TEST(ExplainCommand, KnowsDataAndParametersAsMessagesAndScreensHaveThem) {
  const auto of_828d = [](const char* topic) {
    return explain({.topics = {topic}, .control = "sinumerik-828d"});
  };
  for (const auto& [topic, name] : {std::pair("SD54607", "54607 $SNS_MEA_WP_POS_DEV_AX1 ("),
                                    std::pair("md51740", "51740 $MNS_MEA_FUNCTION_MASK ("),
                                    std::pair("$SNS_MEA_FUNCTION_MASK", "54740 "),
                                    std::pair("S_TSA", "S_TSA (parameter of measuring cycles)"),
                                    std::pair("TZL", "S_TZL (parameter of measuring cycles)")}) {
    EXPECT_NE(of_828d(topic).text.find(name), std::string::npos) << topic << of_828d(topic).text;
  }
  const Output variants = of_828d("S_MVAR");
  EXPECT_NE(variants.text.find("    of CYCLE: 977\n"), std::string::npos) << variants.text;
  EXPECT_EQ(of_828d("SD61301").code, ExitCode::BadUsage) << "an alarm is no datum";
}

/// Every alarm number in the shipped programs has an entry with a title and something to do.
TEST(ExplainCommand, KnowsEveryAlarmOfTheMeasuringCycles) {
  std::set<std::string> numbers;
  const std::regex kRaised("_MC_ALARM\\((6[0-9]{4})\\)");
  for (const auto& entry : std::filesystem::directory_iterator("macros/sinumerik")) {
    const std::string text = testing::text_of(entry.path().string());
    for (std::sregex_iterator at(text.begin(), text.end(), kRaised), end; at != end; ++at) {
      numbers.insert((*at)[1]);
    }
  }
  EXPECT_GE(numbers.size(), 20U);
  for (const std::string& number : numbers) {
    const Output output = explain({.topics = {number}, .control = "sinumerik-828d"});
    EXPECT_EQ(output.code, ExitCode::Completed) << output.errors;
    EXPECT_EQ(output.text.find("no more is known"), std::string::npos) << output.text;
  }
}

TEST(ExplainCommand, NamesWhatIsNearToAnUnknownTopic) {
  const Output near = explain({.topics = {"WHILLE", "G31"}});
  EXPECT_EQ(near.code, ExitCode::BadUsage);
  EXPECT_EQ(near.errors, "g31: error: nothing is known about 'WHILLE', did you mean 'WHILE'?\n");
  EXPECT_NE(near.text.find("G31"), std::string::npos) << "the known topic is explained";
  const Output far = explain({.topics = {"zzzzzzzzzz"}});
  EXPECT_EQ(far.errors,
            "g31: error: nothing is known about 'zzzzzzzzzz': write #5061, G31, ATAN, GOTO, "
            "'alarm 112' or 6001.1\n");
}

TEST(ExplainCommand, RefusesAnUnknownControl) {
  const Output output = explain({.topics = {"G31"}, .control = "hass"});
  EXPECT_EQ(output.code, ExitCode::Setup);
  EXPECT_EQ(output.text, "");
  EXPECT_NE(output.errors.find("did you mean 'haas'?"), std::string::npos);
}

}  // namespace
}  // namespace g31::cli::explain_test
