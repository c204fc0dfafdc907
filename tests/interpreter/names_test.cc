// Names of variables, parameters in expressions, and conditions joined by words and symbols
// (MB-072, MB-075, MB-104, MB-105, MB-350).

#include <optional>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::names_test {
namespace {

using testing::ControlRun;

TEST(Names, SetvnNamesCommonVariablesOnBothSides) {
  ControlRun run(
      "fanuc-30i",
      "SETVN 510[TOOL_NO, work_no]\n[#TOOL_NO]=7\n#511=[#Work_No]+8\n[#work_no]=[#WORK_NO]*2");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.value("#510"), 7.0);
  EXPECT_EQ(run.value("#511"), 16.0);
}

TEST(Names, ANamedVariableIsAValueOfAWordAndAJumpTarget) {
  ControlRun run("fanuc-30i", "SETVN 510[T]\n[#T]=20\nGOTO[#T]\n#100=1\nN20 G0 X[#T] Y-[#T]");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.value("#100"), std::nullopt);
  EXPECT_EQ(run.value("#5001"), 20.0);
  EXPECT_EQ(run.value("#5002"), -20.0);
}

struct AlarmCase {
  const char* why;
  const char* control;
  const char* program;
  int alarm;
};

TEST(Names, WhatIsNoNameIsAnAlarm) {
  const AlarmCase cases[] = {
      {"never given", "fanuc-30i", "#100=[#NOBODY]", 1098},
      {"given behind its use", "fanuc-30i", "#100=[#T]\nSETVN 510[T]", 1098},
      {"a local variable cannot be named", "fanuc-30i", "SETVN 1[T]", 115},
      {"a digit first", "fanuc-30i", "SETVN 510[1T]", 1139},
      {"32 letters", "fanuc-30i", "SETVN 510[ABCDEFGHIJKLMNOPQRSTUVWXYZABCDEF]", 1139},
      {"no brackets", "fanuc-30i", "SETVN 510 T", 1139},
      {"an index for a variable of one number", "fanuc-30i", "SETVN 510[T]\n#100=[#T[1]]", 1099},
      {"a system name without its index", "fanuc-30i", "#100=[#_ABSMT]", 1099},
      {"an index too large", "fanuc-30i", "#100=[#_ABSMT[21]]", 1099},
      {"the 16i shows names on its screen only", "fanuc-16i", "SETVN 510[T]\n#100=[#T]", 114},
  };
  for (const AlarmCase& each : cases) {
    EXPECT_EQ(ControlRun(each.control, each.program).alarm(), each.alarm) << each.why;
  }
}

TEST(Names, SystemNamesStandForTheirNumbers) {
  ControlRun run(
      "fanuc-30i",
      "[#_UO[3]]=1\n#100=#1103\n[#_WZG55[2]]=12.5\n#101=#5242\n[#_WZP2[3]]=-4.\n#102=#7023\n"
      "#103=[#_PRTSA]\nG0 X5.\n#104=[#_ABSIO[1]]");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.value("#100"), 1.0);
  EXPECT_EQ(run.value("#101"), 12.5);
  EXPECT_EQ(run.value("#102"), -4.0);
  EXPECT_EQ(run.value("#103"), 0.0);
  EXPECT_EQ(run.value("#104"), 5.0);
}

TEST(Parameters, PrmReadsValuesBitsAndAxes) {
  runtime::ControlSetup setup;
  setup.parameters = {
      {"6004.0", 1.0}, {"6004.1", 1.0}, {"3410", 0.05}, {"1240.Z", -120.0}, {"5114", 1.5}};
  ControlRun run("fanuc-30i",
                 "#100=PRM[6004]\n#101=PRM[6004,1]\n#102=PRM[6004,2]\n#103=PRM[3410]\n"
                 "#104=PRM[1240]/[3]\n#105=PRM[1240]/[1]\n#106=PRM[6004,0]/[2]+1\n#107=PRM[5114]*2",
                 setup);
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.value("#100"), 3.0);  // bits 0 and 1
  EXPECT_EQ(run.value("#101"), 1.0);
  EXPECT_EQ(run.value("#102"), 0.0);
  EXPECT_EQ(run.value("#103"), 0.05);
  EXPECT_EQ(run.value("#104"), -120.0);
  EXPECT_EQ(run.value("#105"), 0.0);
  EXPECT_EQ(run.value("#106"), 2.0);
  EXPECT_EQ(run.value("#107"), 3.0);
}

TEST(Parameters, PrmOfNothingIsAnAlarm) {
  EXPECT_EQ(ControlRun("fanuc-30i", "#100=PRM[-1]").alarm(), 119);
  EXPECT_EQ(ControlRun("fanuc-30i", "#100=PRM[6004,8]").alarm(), 119);
  EXPECT_EQ(ControlRun("fanuc-30i", "#100=PRM[1240]/[7]").alarm(), 119);
  EXPECT_EQ(ControlRun("fanuc-16i", "#100=PRM[6004]").alarm(), 113);
}

struct LogicCase {
  const char* condition;
  bool holds;
};

/// #1 = 1, #2 = 2
constexpr LogicCase kWordCases[] = {
    {"[[#1EQ1]AND[#2EQ2]]", true},
    {"[[#1EQ1]AND[#2EQ3]]", false},
    {"[[#1EQ0]OR[#2EQ2]]", true},
    {"[[#1EQ0]OR[#2EQ0]]", false},
    {"[[#1EQ1]XOR[#2EQ2]]", false},
    {"[[#1EQ1]XOR[#2EQ3]]", true},
    {"[[#1LT#2]AND[#2GT0]AND[#1NE#0]]", true},
    {"[[#1EQ0]OR[[#2EQ2]AND[#1EQ1]]]", true},
    {"[[[#1EQ0]OR[#2EQ2]]AND[#1EQ0]]", false},
};

constexpr LogicCase kSymbolCases[] = {
    {"[#1EQ1&&#2EQ2]", true},  {"[#1EQ1&&#2EQ3]", false},        {"[#1EQ0||#2EQ2]", true},
    {"[#1EQ0||#2EQ0]", false}, {"[#1EQ1&&#2EQ2&&#1LT#2]", true},
};

std::string asking(const char* condition) {
  return std::string("#1=1\n#2=2\n#100=0\nIF") + condition + "GOTO10\nGOTO20\nN10#100=1\nN20";
}

TEST(Conditions, WordsJoinThemWithParameter6006) {
  runtime::ControlSetup joins;
  joins.parameters = {{"6006.0", 1.0}};
  for (const LogicCase& each : kWordCases) {
    ControlRun run("fanuc-16i", asking(each.condition), joins);
    EXPECT_EQ(run.alarm(), 0) << each.condition;
    EXPECT_EQ(run.value("#100"), each.holds ? 1.0 : 0.0) << each.condition;
    EXPECT_EQ(ControlRun("fanuc-16i", asking(each.condition)).alarm(), 114) << each.condition;
  }
}

TEST(Conditions, SymbolsJoinThemOnMazak) {
  for (const LogicCase& each : kSymbolCases) {
    ControlRun run("mazatrol-iso", asking(each.condition));
    EXPECT_EQ(run.alarm(), 0) << each.condition;
    EXPECT_EQ(run.value("#100"), each.holds ? 1.0 : 0.0) << each.condition;
    EXPECT_EQ(ControlRun("fanuc-16i", asking(each.condition)).alarm(), 114) << each.condition;
  }
}

TEST(Conditions, AJunctionOfNumbersIsNone) {
  EXPECT_EQ(ControlRun("fanuc-16i", "IF[#1AND3]GOTO10\nN10").alarm(), 125);
  EXPECT_EQ(ControlRun("fanuc-16i", "#100=[#1EQ1]AND[#2EQ2]").alarm(), 114);
}

}  // namespace
}  // namespace g31::names_test
