#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/setup/assignment.h"
#include "tools/setup/name_list.h"

namespace g31::setup::setup_names_test {
namespace {

using Names = std::vector<std::string>;

TEST(SetupAssignment, TakesNameAndValue) {
  struct Case {
    const char* text;
    const char* name;
    std::optional<double> value;
  };
  const Case kCases[] = {
      {"#500=1.5", "#500", 1.5},
      {"#0500=-.5", "#500", -0.5},
      {"R1=2", "R1", 2.0},
      {"R007=2.", "R7", 2.0},
      {"_OVR[0]=0", "_OVR[0]", 0.0},
      {"_OVR[ 007 ] = +3e-3 ", "_OVR[7]", 0.003},
      {"$P_UIFR[1, X, TR]=4", "$P_UIFR[1,X,TR]", 4.0},
      {"_VAR01=1", "_VAR01", 1.0},
      {"#_OFST[3]=1", "#_OFST[3]", 1.0},
      {"#500=", "#500", std::nullopt},
      {" R1 =  ", "R1", std::nullopt},
      {"#1=0.1", "#1", 0.1},
      {"#1=9007199254740993", "#1", 9007199254740992.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto result = parse_assignment(c.text);
    ASSERT_TRUE(result.ok()) << result.error();
    EXPECT_EQ(result.value().name, c.name);
    EXPECT_EQ(result.value().value, c.value);
  }
}

TEST(SetupAssignment, SaysWhatIsWrong) {
  struct Case {
    const char* text;
    const char* reason;
  };
  const Case kCases[] = {
      {"", " has no = : write NAME=VALUE, for example #500=1.5"},
      {"#500", "#500 has no = : write NAME=VALUE, for example #500=1.5"},
      {"500=1", "\"500\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"=1", "\"\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#=1", "\"#\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#1234567890=1", "\"#1234567890\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"_A[=1", "\"_A[\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"_A[]=1", "\"_A[]\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"_A[1,]=1", "\"_A[1,]\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"_A[1]]=1", "\"_A[1]]\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#500=1,5", "\"1,5\" is not a number: write #500=1.5, or #500= for null"},
      {"#500=abc", "\"abc\" is not a number: write #500=1.5, or #500= for null"},
      {"#500=nan", "\"nan\" is not a number: write #500=1.5, or #500= for null"},
      {"#500=inf", "\"inf\" is not a number: write #500=1.5, or #500= for null"},
      {"#500=1e999", "\"1e999\" is not a number: write #500=1.5, or #500= for null"},
      {"#500=+-1", "\"+-1\" is not a number: write #500=1.5, or #500= for null"},
      {"#500=0x10", "\"0x10\" is not a number: write #500=1.5, or #500= for null"},
      {"#500==1", "\"=1\" is not a number: write #500=1.5, or #500= for null"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto result = parse_assignment(c.text);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error(), c.reason);
  }
}

TEST(SetupNameList, TakesNamesAndRanges) {
  struct Case {
    const char* text;
    Names names;
  };
  const Case kCases[] = {
      {"#100", {"#100"}},
      {"#0100", {"#100"}},
      {"#100-#103,#5061", {"#100", "#101", "#102", "#103", "#5061"}},
      {"#9-#11", {"#9", "#10", "#11"}},
      {"#099 - #0101", {"#99", "#100", "#101"}},
      {"#7-#7", {"#7"}},
      {"R1-R2,_OVR[9]-_OVR[10],$P_UIFR[1,X,TR]",
       {"R1", "R2", "_OVR[9]", "_OVR[10]", "$P_UIFR[1,X,TR]"}},
      {"$P_UIFR[1,X,TR]-$P_UIFR[2,X,TR]", {"$P_UIFR[1,X,TR]", "$P_UIFR[2,X,TR]"}},
      {"_A[1,8]-_A[1,9]", {"_A[1,8]", "_A[1,9]"}},
      {"_A[18]-_A[21]", {"_A[18]", "_A[19]", "_A[20]", "_A[21]"}},
      {"_X[-1]", {"_X[-1]"}},
      {"#2,#1-#3,#2", {"#2", "#1", "#3"}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto result = parse_name_list(c.text);
    ASSERT_TRUE(result.ok()) << result.error();
    EXPECT_EQ(result.value(), c.names);
  }
}

TEST(SetupNameList, SaysWhatIsWrong) {
  struct Case {
    const char* text;
    const char* reason;
  };
  const Case kCases[] = {
      {"", "\"\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#1,,#2", "\"\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#1,", "\"\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#100-149", "\"149\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#1-", "\"\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"#1-#2-#3", "\"#1-#2-#3\" has more than one minus sign: write FIRST-LAST"},
      {"#100-R200", "#100-R200 is not a range: its names may differ in only one number"},
      {"R1-#9", "R1-#9 is not a range: its names may differ in only one number"},
      {"_A[1]-_B[2]", "_A[1]-_B[2] is not a range: its names may differ in only one number"},
      {"_A[1,1]-_A[2,2]",
       "_A[1,1]-_A[2,2] is not a range: its names may differ in only one number"},
      {"_A[1]-_A[X]", "_A[1]-_A[X] is not a range: its names may differ in only one number"},
      {"_V01-_V09", "_V01-_V09 is not a range: its names may differ in only one number"},
      {"#5-#4", "#5-#4 runs backwards: write #4-#5"},
      {"#1-#100001", "more than 100000 names: make the ranges smaller"},
      {"#0-#999999999", "more than 100000 names: make the ranges smaller"},
      {"_A[1", "\"_A[1\" is not the name of a variable: write #500, R1 or _OVR[0]"},
      {"_A]1,2", "\"_A]1,2\" is not the name of a variable: write #500, R1 or _OVR[0]"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto result = parse_name_list(c.text);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error(), c.reason);
  }
}

TEST(SetupNameList, HoldsAsManyNamesAsItSays) {
  const auto result = parse_name_list("#1-#100000,#5");
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.value().size(), kMostNames);
  EXPECT_EQ(result.value().back(), "#100000");
}

}  // namespace
}  // namespace g31::setup::setup_names_test
