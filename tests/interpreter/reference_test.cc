// What `g31 explain` says about topics, as users write them.

#include <algorithm>

#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/explain/explain.h"
#include "interpreter/dialects/fanuc/vocabulary/alarms.h"

namespace g31::fanuc::reference::reference_test {
namespace {

const Profile& control(std::string_view name) {
  return *find_profile(name);
}

std::string fact(const Entry& entry, std::string_view name) {
  for (const Fact& fact : entry.facts) {
    if (fact.name == name) {
      return fact.value;
    }
  }
  return "";
}

TEST(Explain, TakesTopicsAsUsersWriteThem) {
  struct Case {
    const char* topic;
    const char* control;
    const char* kind;
    const char* name;
  };
  const Case kCases[] = {
      {"#5061", "fanuc-16i", "system variable", "#5061"},
      {" #0 ", "fanuc-16i", "variable", "#0"},
      {"#33", "fanuc-16i", "local variable", "#33"},
      {"#100-#149", "fanuc-16i", "common variable", "#100 to #149"},
      {"#500-999", "fanuc-16i", "common variable", "#500 to #999"},
      {"#30057.25", "haas", "system variable", "#30057250"},
      {"#3101", "fanuc-30i", "system variable", "#3101"},
      {"G31", "fanuc-16i", "G code", "G31"},
      {"g1", "fanuc-16i", "G code", "G01"},
      {"G54.1", "fanuc-16i", "G code", "G54.1"},
      {"m99", "fanuc-16i", "M code", "M99 Pn Lk"},
      {"PS0112", "fanuc-16i", "alarm", "112 DIVIDED BY ZERO"},
      {"alarm  112", "fanuc-16i", "alarm", "112 DIVIDED BY ZERO"},
      {"P283", "fanuc-16i", "alarm", "283 DIVIDED BY ZERO"},
      {"283", "meldas", "alarm", "283 DIVIDED BY ZERO"},
      {"3091", "fanuc-16i", "alarm", "3091 MACRO ALARM"},
      {"1091", "haas", "alarm", "1091 MACRO ALARM"},
      {"MC3001", "fanuc-30i", "alarm", "3001 MACRO ALARM"},
      {"6001.1", "fanuc-16i", "parameter", "6001.1"},
      {"parameter 3410", "fanuc-16i", "parameter", "3410"},
      {"6055", "fanuc-16i", "parameter", "6050 to 6059"},
      {"atan", "fanuc-16i", "function", "ATAN[a], ATAN[y]/[x]"},
      {"SQ", "fanuc-16i", "function", "SQRT[a]"},
      {"dprnt", "fanuc-16i", "statement", "DPRNT"},
      {"WH", "fanuc-16i", "statement", "WHILE [condition] DO m"},
      {"EQ", "fanuc-16i", "statement", "a EQ b"},
      {"Haas", "fanuc-16i", "control", "haas"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.topic);
    const Entries found = explain(c.topic, control(c.control));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, c.kind);
    EXPECT_EQ(found[0].name, c.name);
    EXPECT_FALSE(found[0].text.empty());
    EXPECT_EQ(found[0].text.find("{}"), std::string::npos);
  }
}

TEST(Explain, SaysWhichAxisOffsetOrGroupANumberIs) {
  struct Case {
    const char* topic;
    const char* control;
    const char* here;
  };
  const Case kCases[] = {
      {"#5063", "fanuc-16i", "Z"},
      {"#5204", "fanuc-16i", "external offset, A"},
      {"#5243", "fanuc-16i", "G55, Z"},
      {"#7021", "fanuc-16i", "G54.1 P2, X"},
      {"#19982", "fanuc-16i", "G54.1 P300, Y"},
      {"#2703", "fanuc-16i", "G56"},
      {"#11050", "fanuc-16i", "offset 50"},
      {"#4014", "fanuc-16i", "group 14"},
      {"#5070", "fanuc-16i", "axis 10"},
      {"#2450", "haas", "offset 50"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.topic);
    const Entries found = explain(c.topic, control(c.control));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(fact(found[0], "here"), c.here);
  }
}

TEST(Explain, KnowsNothingOfWhatAControlLacks) {
  struct Case {
    const char* topic;
    const char* control;
  };
  const Case kCases[] = {{"#3101", "fanuc-16i"}, {"#200", "fanuc-16i"}, {"#2806", "meldas"},
                         {"G20", "brother"},     {"G999", "haas"},      {"", "haas"},
                         {"#", "haas"},          {"#9-#3", "haas"},     {"6001.9", "haas"},
                         {"G", "haas"},          {"alarm", "haas"},     {"PSX", "haas"}};
  for (const Case& c : kCases) {
    EXPECT_TRUE(explain(c.topic, control(c.control)).empty()) << c.topic;
  }
}

TEST(Explain, ShowsAnAlarmByItsNumberOnEveryFamily) {
  const Entries found = explain("1128", control("fanuc-16i"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(fact(found[0], "Fanuc 16i"), "128");
  EXPECT_EQ(fact(found[0], "Fanuc 30i"), "1128");
  EXPECT_EQ(fact(found[0], "MELDAS"), "231");
  EXPECT_EQ(explain("alarm 115", control("fanuc-16i")).size(), 2U) << "read protected counts, too";
}

TEST(Explain, NamesTheGroupNumberOfTheControl) {
  EXPECT_EQ(fact(explain("G56", control("fanuc-16i")).at(0), "shown by"), "#4014");
  EXPECT_EQ(fact(explain("G56", control("meldas")).at(0), "shown by"), "#4012");
}

TEST(Explain, KnowsTheOffsetNumbersOfEachMemory) {
  struct Case {
    const char* topic;
    const char* control;
    const char* fact;  ///< nullptr: the text itself
    const char* text;
  };
  const char* const kWear = "tool length offset n (H), wear";
  const char* const kGeometry = "tool length offset n (H), geometry";
  const char* const kTurned = "with parameter 6000.3 = 1";
  const Case kCases[] = {
      {"#2001", "fanuc-16i", nullptr, kWear},
      {"#2001", "fanuc-16i", "here", "offset 1"},
      {"#2001", "fanuc-16i", "with offset_memory = \"A\"", "tool offset n, memory A"},
      {"#2001", "fanuc-16i", "with offset_memory = \"B\"", ""},
      {"#2001", "fanuc-16i", kTurned, kGeometry},
      {"#2201", "fanuc-30i", nullptr, kGeometry},
      {"#2201", "fanuc-30i", kTurned, kWear},
      {"#2450", "fanuc-16i", kTurned, "cutter radius offset n (D), geometry"},
      {"#10007", "fanuc-16i", nullptr, kWear},
      {"#10007", "fanuc-16i", "here", "offset 7"},
      {"#11999", "fanuc-16i", nullptr, kGeometry},
      {"#12001", "fanuc-16i", nullptr, "cutter radius offset n (D), wear"},
      {"#13001", "fanuc-16i", nullptr, "cutter radius offset n (D), geometry"},
      {"#2001", "haas", nullptr, kGeometry},
      {"#2201", "haas", nullptr, kWear},
      {"#2401", "haas", nullptr, "cutter diameter n (D), geometry"},
      {"#2001", "meldas", nullptr, kGeometry},
      {"#2001", "meldas", kTurned, ""},
      {"#16001", "meldas", nullptr, "cutter radius offset n (D), geometry"},
  };
  for (const Case& c : kCases) {
    const Entries found = explain(c.topic, control(c.control));
    ASSERT_EQ(found.size(), 1U) << c.topic << " on " << c.control;
    EXPECT_EQ(c.fact == nullptr ? found[0].text : fact(found[0], c.fact), c.text)
        << c.topic << " on " << c.control;
  }
}

TEST(Explain, EverythingHoldsEveryRowOnce) {
  for (const Profile& profile : profiles()) {
    const Entries all = everything(profile);
    const auto count = [&](std::string_view kind) {
      return static_cast<std::size_t>(std::ranges::count(all, kind, &Entry::kind));
    };
    EXPECT_EQ(count("alarm"), fanuc::alarms().size()) << profile.name;
    EXPECT_EQ(count("parameter"), parameter_rows().size()) << profile.name;
    EXPECT_EQ(count("system variable"), SystemVariableIndex(profile.variables).rows().size());
    const auto own = std::ranges::count_if(
        g_codes(), [&](const fanuc::GCode& code) { return fanuc::has_g_code(profile, code); });
    EXPECT_EQ(count("G code"), static_cast<std::size_t>(own)) << profile.name;
    EXPECT_EQ(count("control"), profiles().size());
  }
}

TEST(Explain, NamesTheNearestTopic) {
  EXPECT_EQ(nearest_topic("ATANN"), "ATAN");
  EXPECT_EQ(nearest_topic("dprint"), "DPRNT");
  EXPECT_EQ(nearest_topic("#123456789"), std::nullopt);
}

}  // namespace
}  // namespace g31::fanuc::reference::reference_test
