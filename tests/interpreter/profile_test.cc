// What controls of the family do differently (section 15 of the Macro B semantics), program by
// program.

#include "interpreter/dialects/fanuc/vocabulary/profile.h"

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::fanuc::profile_test {
namespace {

using testing::ControlRun;

struct Case {
  const char* name;
  const char* control;
  const char* program;
  int alarm;
};

TEST(Profile, NumbersItsAlarms) {
  const Case kCases[] = {
      {"division by zero", "fanuc-16i", "#1=1/0", 112},
      {"on the 30i", "fanuc-30i", "#1=1/0", 112},
      {"on MELDAS", "meldas", "#1=1/0", 283},
      {"on Mazak", "mazatrol-iso", "#1=1/0", 283},
      {"an impossible calculation on MELDAS", "meldas", "#1=SQRT[-1]", 282},
      {"a missing block on MELDAS", "meldas", "GOTO 77", 231},
      {"a missing program on MELDAS", "meldas", "G65P77", 232},
      {"G31 without feed on MELDAS", "meldas", "G31X1.", 603},
      {"G67 without G66 is ignored", "fanuc-16i", "G67", 0},
      {"but not on the 30i", "fanuc-30i", "G67", 1100},
      {"nor on MELDAS", "meldas", "G67", 276},
      {"#3000 adds 3000", "fanuc-16i", "#3000=91(X)", 3091},
      {"up to 4095 on the 30i", "fanuc-30i", "#3000=4095(X)", 7095},
      {"Haas adds 1000", "haas", "#3000=91(X)", 1091},
      {"Brother adds 9000", "brother", "#3000=91(X)", 9091},
      {"MELDAS always says 277", "meldas", "#3000=91(X)", 277},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun(c.control, c.program).alarm(), c.alarm);
  }
}

TEST(Profile, NumbersG31InCutterCompensation) {
  EXPECT_EQ(number_of(AlarmId::SkipNotAllowed, AlarmNumbers::Series16i), 35);
  EXPECT_EQ(number_of(AlarmId::SkipNotAllowed, AlarmNumbers::Meldas), 608);
}

TEST(Profile, SaysWhatAlarmTheProgramMade) {
  const ControlRun meldas("meldas", "#3000=91(CHECK PROBE)");
  ASSERT_TRUE(meldas.outcome().alarm.has_value());
  EXPECT_EQ(meldas.outcome().alarm->text, "CHECK PROBE");
  EXPECT_EQ(meldas.outcome().alarm->detail, "91");
  runtime::ControlSetup plain;
  plain.parameters["6008.1"] = 1.0;
  EXPECT_EQ(ControlRun("fanuc-30i", "#3000=91(X)", plain).alarm(), 91);
  EXPECT_EQ(ControlRun("fanuc-16i", "#3000=91(X)", plain).alarm(), 3091)
      << "the 16i has no such bit";
}

TEST(Profile, HasItsLoops) {
  const Case kCases[] = {
      {"three on Fanuc", "fanuc-16i", "WHILE[#1LT1]DO3\n#1=1\nEND3", 0},
      {"not four", "fanuc-16i", "WHILE[#1LT1]DO4\n#1=1\nEND4", 126},
      {"never nought", "meldas", "WHILE[#1LT1]DO0\n#1=1\nEND0", 293},
      {"four on Brother", "brother", "WHILE[#1LT1]DO4\n#1=1\nEND4", 0},
      {"not five", "brother", "WHILE[#1LT1]DO5\n#1=1\nEND5", 126},
      {"127 on MELDAS", "meldas", "WHILE[#1LT1]DO127\n#1=1\nEND127", 0},
      {"not 128", "meldas", "WHILE[#1LT1]DO128\n#1=1\nEND128", 293},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun(c.control, c.program).alarm(), c.alarm);
  }
}

TEST(Profile, TakesExpressionsWithoutBracketsOrNot) {
  EXPECT_EQ(ControlRun("fanuc-16i", "#1=5\nG0X#1+10").alarm(), 9);
  ControlRun meldas("meldas", "#1=5\nG0X#1+10*2Y-#1+1Z[#1]-7");
  EXPECT_EQ(meldas.machine().log(), (std::vector<std::string>{"move 25.000 -4.000 -2.000 rapid"}));
}

/// DO1 DO2 ... each leaving after one round.
std::string nested_loops(int depth) {
  std::string program;
  for (int n = 1; n <= depth; ++n) {
    program += "WHILE[#" + std::to_string(n) + "LT1]DO" + std::to_string(n) + "\n";
  }
  for (int n = depth; n >= 1; --n) {
    program += "#" + std::to_string(n) + "=1\nEND" + std::to_string(n) + "\n";
  }
  return program;
}

TEST(Profile, NestsItsLoops) {
  EXPECT_EQ(ControlRun("fanuc-16i", nested_loops(3)).alarm(), 0);
  EXPECT_EQ(ControlRun("brother", nested_loops(4)).alarm(), 0);
  EXPECT_EQ(ControlRun("meldas", nested_loops(27)).alarm(), 0);
  EXPECT_EQ(ControlRun("meldas", nested_loops(28)).alarm(), 293);
}

TEST(Profile, HasItsStatementsAndCodes) {
  const Case kCases[] = {
      {"THEN on Fanuc", "fanuc-16i", "IF[1EQ1]THEN#1=1", 0},
      {"no THEN on Brother", "brother", "IF[1EQ1]THEN#1=1", 125},
      {"GOTO on Brother", "brother", "IF[1EQ1]GOTO9\nN9", 0},
      {"no G20 on Brother", "brother", "G20", 10},
      {"no G21 on Brother", "brother", "G21", 10},
      {"nine digits on the 16i", "fanuc-16i", "#1=123456789", 3},
      {"and on the 0i", "fanuc-0i", "#1=123456789", 3},
      {"and on the 30i", "fanuc-30i", "#1=123456789", 0},
      {"POW on the 30i only", "haas", "#1=POW[2,3]", 113},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun(c.control, c.program).alarm(), c.alarm);
  }
}

/// O11 calls O12 calls ..., `depth` of them, by G65 or by M98.
std::string call_chain(const std::string& call, int depth) {
  std::string programs = call + "P11\nM30\n";
  for (int n = 1; n <= depth; ++n) {
    programs += "O" + std::to_string(10 + n) + "\n" +
                (n < depth ? call + "P" + std::to_string(11 + n) : "#100=1") + "\nM99\n";
  }
  return programs + "O99";
}

TEST(Profile, NestsItsCalls) {
  struct Depth {
    const char* control;
    const char* call;
    int deepest;
    int alarm;
  };
  const Depth kCases[] = {
      {"fanuc-16i", "G65", 4, 77}, {"fanuc-30i", "G65", 5, 122}, {"meldas", "G65", 4, 273},
      {"brother", "G65", 4, 77},   {"fanuc-16i", "M98", 4, 77},  {"fanuc-30i", "M98", 10, 77},
      {"meldas", "M98", 8, 230},   {"brother", "M98", 8, 77},    {"haas", "G65", 9, 77},
      {"haas", "M98", 9, 77},
  };
  for (const Depth& c : kCases) {
    SCOPED_TRACE(std::string(c.control) + " " + c.call);
    EXPECT_EQ(ControlRun(c.control, call_chain(c.call, c.deepest)).alarm(), 0);
    EXPECT_EQ(ControlRun(c.control, call_chain(c.call, c.deepest + 1)).alarm(), c.alarm);
  }
}

TEST(Profile, StartsASubprogramInItsMiddle) {
  const std::string body = "M30\nO7\n#100=1\nN5#101=1\nM99\nO99";
  ControlRun fanuc("fanuc-30i", "M98P7Q5\n" + body);
  EXPECT_EQ(fanuc.value("#100"), std::nullopt);
  EXPECT_EQ(fanuc.value("#101"), 1.0);
  ControlRun meldas("meldas", "M98P7H5\n" + body);
  EXPECT_EQ(meldas.value("#100"), std::nullopt);
  EXPECT_EQ(meldas.value("#101"), 1.0);
}

TEST(Profile, TakesTheFeedOfASkipMove) {
  ControlRun fanuc("fanuc-16i", "F50.\nG31X1.F100.");
  EXPECT_EQ(fanuc.value("#4109"), 100.0);
  ControlRun meldas("meldas", "F50.\nG31X1.F100.\nG31X2.");
  EXPECT_EQ(meldas.value("#4109"), 50.0);
  EXPECT_EQ(meldas.machine().log(), (std::vector<std::string>{"skip 1.000 0.000 0.000 F100",
                                                              "skip 2.000 0.000 0.000 F50"}));
  runtime::ControlSetup setup;
  setup.parameters["1174"] = 30.0;
  const ControlRun preset("meldas", "F50.\nG31X1.", setup);
  EXPECT_EQ(preset.machine().log(), (std::vector<std::string>{"skip 1.000 0.000 0.000 F30"}));
  setup.parameters["1178"] = 40.0;
  const ControlRun steps("meldas", "F50.\nG31.2X1.\nG31.3X2.\nG31.2X3.F60.", setup);
  EXPECT_EQ(steps.machine().log(),
            (std::vector<std::string>{"skip 1.000 0.000 0.000 F40", "skip 2.000 0.000 0.000 F50",
                                      "skip 3.000 0.000 0.000 F60"}));
}

TEST(Profile, MakesIntegersForLogic) {
  ControlRun fanuc("fanuc-16i", "#100=1.7OR4");
  EXPECT_EQ(fanuc.value("#100"), 6.0);
  ControlRun haas("haas", "#100=1.7OR4");
  EXPECT_EQ(haas.value("#100"), 5.0);
}

TEST(Profile, PrintsItsWay) {
  struct Print {
    const char* name;
    const char* control;
    const char* program;
    int alarm;
    const char* output;
  };
  const Print kCases[] = {
      {"Haas widens", "haas", "#1=123.456\nDPRNT[X#1[12]]", 0, "X123.46\n"},
      {"Haas has no sign column", "haas", "#1=1.5436\nDPRNT[X#1[44]]", 0, "X   1.5436\n"},
      {"Haas: nine digits", "haas", "DPRNT[#1[54]]", 114, ""},
      {"Haas: nine digits the other way", "haas", "DPRNT[#1[45]]", 114, ""},
      {"Haas: none", "haas", "DPRNT[#1[00]]", 114, ""},
      {"nine digits on the 16i", "fanuc-16i", "DPRNT[#1[54]]", 114, ""},
      {"nine digits on the 30i", "fanuc-30i", "#1=-2\nDPRNT[#1[54]]", 0, "-    2.0000\n"},
      {"Brother needs POPEN", "brother", "BPRNT[A]", 4041, ""},
      {"Brother after PCLOS", "brother", "POPEN\nPCLOS\nDPRNT[A]", 4041, ""},
      {"Brother: PCLOS twice", "brother", "PCLOS", 0, ""},
      {"Brother: one digit", "brother", "POPEN\n#1=-0.456\nDPRNT[#1[2]]", 0, "-.46\n"},
      {"Brother: eleven variables", "brother",
       "POPEN\nDPRNT[#1[1]#1[1]#1[1]#1[1]#1[1]#1[1]#1[1]#1[1]#1[1]#1[1]#1[1]]", 114, ""},
      {"null prints as 0", "fanuc-16i", "POPEN\nDPRNT[#1[20]]", 0, "  0\n"},
  };
  for (const Print& c : kCases) {
    SCOPED_TRACE(c.name);
    ControlRun run(c.control, c.program);
    EXPECT_EQ(run.alarm(), c.alarm);
    EXPECT_EQ(run.output(), c.output);
  }
}

TEST(Profile, IsFoundByItsNameOnly) {
  for (const Profile& profile : profiles()) {
    EXPECT_EQ(find_profile(profile.name), &profile);
  }
  EXPECT_EQ(find_profile("fanuc"), nullptr);
  EXPECT_EQ(profiles().size(), 7U);
}

}  // namespace
}  // namespace g31::fanuc::profile_test
