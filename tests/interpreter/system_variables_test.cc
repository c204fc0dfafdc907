// System variables by number, control and set-up; what each must show is that of MB-120 to MB-147.

#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"

#include <numbers>

#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "tests/support/control_run.h"

namespace g31::fanuc::system_variables_test {
namespace {

using testing::ControlRun;

constexpr int kIllegal = 115;
constexpr int kProtected = 116;

/// Every set of rows that a control can have, by its offset memory and parameter 6000.3.
std::vector<VariableGroups> possible_groups(const Profile& profile) {
  using enum VariableGroup;
  const VariableGroups given = profile.variables;
  if (!given.meets({OffsetsC})) {
    return {given};
  }
  const VariableGroups others = given.without(OffsetsC);
  return {given, others.with(OffsetsA), others.with(OffsetsB),
          others.without(LegacyOffsets).with(OffsetsCTurned)};
}

TEST(SystemVariables, OfOneControlNeverOverlap) {
  for (const Profile& profile : profiles()) {
    for (const VariableGroups groups : possible_groups(profile)) {
      const SystemVariableIndex index(groups);
      for (std::size_t i = 1; i < index.rows().size(); ++i) {
        EXPECT_LT(index.rows()[i - 1]->last, index.rows()[i]->first)
            << profile.name << " #" << index.rows()[i]->first;
      }
    }
  }
}

struct Case {
  const char* name;
  const char* control;
  const char* program;
  const char* variable;
  double value;
};

TEST(SystemVariables, ShowWhatTheProgramDid) {
  const Case kCases[] = {
      {"bits make the output word", "fanuc-16i", "#1100=1\n#1103=2.5\n#1115=-1", "#1132", 32777},
      {"the output word makes bits", "fanuc-16i", "#1132=5", "#1102", 1},
      {"null clears an output", "fanuc-16i", "#1132=7\n#1101=#0", "#1132", 5},
      {"a word beyond 16 bits loses the rest", "fanuc-16i", "#1132=65539", "#1132", 3},
      {"32-bit outputs are two's complement", "fanuc-16i", "#1133=-2", "#1133", -2},
      {"length wear by its short number", "fanuc-16i", "#2005=1.5", "#10005", 1.5},
      {"length geometry by its short number", "fanuc-16i", "#2205=1.5", "#11005", 1.5},
      {"a legacy work offset is the same storage", "fanuc-16i", "#2703=-12.5", "#5263", -12.5},
      {"the external one, too", "fanuc-16i", "#2500=4", "#5201", 4},
      {"G54.1 P48 by both numbers", "fanuc-16i", "#7942=3", "#14942", 3},
      {"G54.1 P300", "fanuc-16i", "G54.1P300\n#19981=7", "#5001", -7},
      {"a system variable is never null", "fanuc-16i", "#5221=5\n#5221=#0", "#5221", 0},
      {"offsets are in the unit in force", "fanuc-16i", "#11001=25.4\nG20\n#100=#11001", "#100", 1},
      {"a rotary offset is not", "fanuc-16i", "#5224=30\nG20\n#100=#5224", "#100", 30},
      {"the inch bit of the settings", "fanuc-16i", "G20\n#100=#3005", "#100", 4},
      {"the settings choose the unit", "fanuc-16i", "#3005=4\n#100=#4006", "#100", 20},
      {"G20 is setting 9 of a Haas", "haas", "G20\n#100=#20009", "#100", 0},
      {"the parts counter counts", "fanuc-16i", "#3901=5\n#3901=#3901+1", "#3901", 6},
      {"D as it was given", "fanuc-16i", "D3", "#4107", 3},
      {"E and F have their own numbers", "fanuc-16i", "F250.", "#4109", 250},
      {"words that no number shows", "fanuc-16i", "#100=#4110", "#100", 0},
      {"work offset modal is group 14", "fanuc-16i", "G56", "#4014", 56},
      {"of MELDAS group 12", "meldas", "G56", "#4012", 56},
      {"of Mazak, too", "mazatrol-iso", "G56", "#4012", 56},
      {"MELDAS shows the executing block", "meldas", "T7", "#4320", 7},
      {"so does the 30i", "fanuc-30i", "G91", "#4203", 91},
      {"pi", "fanuc-30i", "#100=#3101", "#100", std::numbers::pi},
      {"e", "fanuc-30i", "#100=#3102", "#100", std::numbers::e},
      {"more than twenty axes", "fanuc-30i", "G0X4.", "#100051", 4},
      {"Haas: #2001 is geometry", "haas", "#2001=50\nG43H1Z0\n#2201=1", "#5083", 50},
      {"Haas keeps diameters", "haas", "#2403=8\n#2603=0.5", "#2403", 8},
      {"Haas: #5201 is G52", "haas", "G52X3.", "#5201", 3},
      {"Haas: #10500 is #500", "haas", "#10500=2.5", "#500", 2.5},
      {"MELDAS: #2001 is geometry", "meldas", "#2001=50", "#10001", 50},
      {"MELDAS: #16001 is the radius", "meldas", "#16001=3", "#2401", 3},
      {"Brother: offsets by five digits", "brother", "#11001=40\n#10001=0.5\nG43H1Z0", "#5083",
       40.5},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    ControlRun run(c.control, c.program);
    EXPECT_EQ(run.alarm(), 0);
    ASSERT_TRUE(run.value(c.variable).has_value());
    EXPECT_NEAR(*run.value(c.variable), c.value, 1e-12);
  }
}

TEST(SystemVariables, RefuseWhatTheControlLacksOrProtects) {
  struct Refused {
    const char* name;
    const char* control;
    const char* program;
    int alarm;
  };
  const Refused kCases[] = {
      {"an input is not written", "fanuc-16i", "#1000=1", kProtected},
      {"a number between inputs and outputs", "fanuc-16i", "#100=#1016", kIllegal},
      {"the date is not written", "fanuc-16i", "#3011=20200101", kProtected},
      {"the time is not written", "fanuc-16i", "#3012=1", kProtected},
      {"the stop with message is not read", "fanuc-16i", "#100=#3006", kIllegal},
      {"on the 30i it has its own number", "fanuc-30i", "#100=#3000", 1115},
      {"MELDAS has another", "meldas", "#100=#3000", 243},
      {"numbers that never were", "fanuc-30i", "#100=#3009", kIllegal},
      {"constants of the 30i", "fanuc-16i", "#100=#3101", kIllegal},
      {"the executing block on the 16i", "fanuc-16i", "#100=#4201", kIllegal},
      {"distance to go on the 16i", "fanuc-16i", "#100=#5181", kIllegal},
      {"a seventh axis", "fanuc-16i", "#100=#5007", kIllegal},
      {"positions are not written", "fanuc-16i", "#5061=1", kProtected},
      {"modal data are not written", "fanuc-16i", "#4109=1", kProtected},
      {"legacy work offsets on MELDAS", "meldas", "#100=#2806", 241},
      {"a number that does not fit 32 bits", "fanuc-16i", "#1133=2147484.*1000.", 110},
      {"an analog input of a Haas is not written", "haas", "#13000=1", kProtected},
      {"beyond the Haas variables", "haas", "#13064=1", kIllegal},
  };
  for (const Refused& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun(c.control, c.program).alarm(), c.alarm);
  }
}

TEST(SystemVariables, OffsetMemoryDecidesWhatANumberMeans) {
  runtime::ControlSetup setup;
  setup.parameters["6000.3"] = 1.0;
  ControlRun turned("fanuc-16i", "#2001=50\n#2201=1\n#2401=6\n#2601=0.5", setup);
  EXPECT_EQ(turned.value("#11001"), 50.0);
  EXPECT_EQ(turned.value("#10001"), 1.0);
  EXPECT_EQ(turned.value("#13001"), 6.0);
  EXPECT_EQ(turned.value("#12001"), 0.5);

  runtime::ControlSetup a;
  a.offset_memory = runtime::OffsetMemory::A;
  ControlRun memory_a("fanuc-16i", "#2003=12\nG43H3Z0", a);
  EXPECT_EQ(memory_a.value("#10003"), 12.0);
  EXPECT_EQ(memory_a.value("#5083"), 12.0);
  EXPECT_EQ(ControlRun("fanuc-16i", "#100=#2201", a).alarm(), kIllegal);

  runtime::ControlSetup b;
  b.offset_memory = runtime::OffsetMemory::B;
  ControlRun memory_b("fanuc-16i", "#2003=0.5\n#2203=12\nG43H3Z0", b);
  EXPECT_EQ(memory_b.value("#11003"), 12.0);
  EXPECT_EQ(memory_b.value("#5083"), 12.5);
  EXPECT_EQ(ControlRun("fanuc-16i", "#100=#13001", b).alarm(), kIllegal);
}

TEST(SystemVariables, InputsComeFromTheSheet) {
  runtime::ControlSetup setup;
  setup.variables = {{"#1000", 1.0},        {"#1003", 1.0},      {"#1034", -7.0},
                     {"#3011", 20240228.0}, {"#3012", 235959.0}, {"#3007", 2.0}};
  ControlRun run("fanuc-16i", "#100=#1032\n#101=#1034\n#102=#3007\n#103=#3011\n#104=#3012", setup);
  EXPECT_TRUE(run.refused().empty());
  EXPECT_EQ(run.value("#100"), 9.0);
  EXPECT_EQ(run.value("#101"), -7.0);
  EXPECT_EQ(run.value("#102"), 2.0);
  EXPECT_EQ(run.value("#103"), 20240228.0);
  EXPECT_EQ(run.value("#104"), 235959.0);
}

TEST(SystemVariables, TheSheetCannotSetTheImpossible) {
  for (const auto& [name, value] : std::map<std::string, double>{{"#3011", 20230229.0},
                                                                 {"#3012", 246000.0},
                                                                 {"#3012", 1.5},
                                                                 {"#5061", 1.0},
                                                                 {"#3000", 1.0},
                                                                 {"#4001", 1.0}}) {
    runtime::ControlSetup setup;
    setup.variables = {{name, value}};
    EXPECT_EQ(ControlRun("fanuc-16i", "", setup).refused().size(), 1U) << name;
  }
}

TEST(SystemVariables, CommonVariablesCanBeWriteProtected) {
  runtime::ControlSetup setup;
  setup.parameters = {{"6031", 500.0}, {"6032", 510.0}};
  setup.variables = {{"#505", 3.0}};
  EXPECT_EQ(ControlRun("fanuc-16i", "#505=1", setup).alarm(), kProtected);
  EXPECT_EQ(ControlRun("fanuc-16i", "#1=510\n#[#1]=1", setup).alarm(), kProtected);
  ControlRun beside("fanuc-16i", "#511=#505", setup);
  EXPECT_EQ(beside.alarm(), 0);
  EXPECT_EQ(beside.value("#511"), 3.0);
}

TEST(SystemVariables, TheSkipPositionHasTheToolOffset) {
  AxisPositions q_M_touch = AxisPositions::Zero();
  q_M_touch[2] = 40.0;
  ControlRun fanuc("fanuc-16i", "#11001=100\nG90G43H1G0Z50.\nG31Z-20.F100\nG49", {}, {q_M_touch});
  EXPECT_EQ(fanuc.value("#5063"), 40.0);
  ControlRun haas("haas", "#2001=100\nG90G43H1G0Z50.\nG31Z-20.F100\nG49", {}, {q_M_touch});
  EXPECT_EQ(haas.value("#5063"), 40.0) << "as suites that subtract #5083 expect";
}

TEST(SystemVariables, BeyondEveryControlAreToldByANumberOfTheirSize) {
  for (const char* const program : {"#100=#[99999999999]", "#101=99999999*100\n#[#101]=1"}) {
    const ControlRun run("fanuc-16i", program);
    EXPECT_EQ(run.alarm(), kIllegal) << program;
    EXPECT_EQ(run.outcome().alarm->detail.substr(0, 12), "#1000000000 ") << program;
  }
  const ControlRun negative("fanuc-16i", "#100=#[0-99999999*100]");
  EXPECT_EQ(negative.alarm(), kIllegal);
  EXPECT_EQ(negative.outcome().alarm->detail, "#-1000000000 cannot be read");
}

}  // namespace
}  // namespace g31::fanuc::system_variables_test
