// Which way rapids go: straight, or each axis on its own.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/run/session.h"
#include "tests/support/control_run.h"

namespace g31::rapid_paths_test {
namespace {

/// A letter a rapid: S straight, I each axis on its own.
std::string paths_of(const testing::RecordingMachine& machine) {
  std::string paths;
  for (const machine::RapidPath path : machine.rapid_paths()) {
    paths += path == machine::RapidPath::Straight ? 'S' : 'I';
  }
  return paths;
}

struct FanucCase {
  const char* name;
  const char* profile;
  const char* program;
  std::map<std::string, double> parameters;
  std::optional<machine::RapidPath> sheet;
  const char* paths;
};
constexpr auto kStraight = machine::RapidPath::Straight;
constexpr auto kIndependent = machine::RapidPath::Independent;
const FanucCase kFanucCases[] = {
    {"as delivered", "fanuc-16i", "G0X1.Y2.\nG1X3.F100\nG0Z1.", {}, {}, "II"},
    {"LRP", "fanuc-30i", "G0X1.Y2.\nZ1.", {{"1401.1", 1}}, {}, "SS"},
    {"LRP as G10 L50 writes it",
     "fanuc-30i",
     "G0X1.Y2.\nG10L50\nN1401R10\nG11\nG0X3.Y4.",
     {},
     {},
     "IS"},
    {"the sheet", "haas", "G0X1.Y2.", {}, kStraight, "S"},
    {"and the other way round", "meldas", "G0X1.Y2.", {}, kIndependent, "I"},
    {"Haas", "haas", "G0X1.Y2.", {}, {}, "I"},
    {"MELDAS", "meldas", "G0X1.Y2.", {}, {}, "S"},
    {"reference points: neither way is straightened",
     "fanuc-16i",
     "G28X1.Y2.\nG29X3.Y1.\nG30X1.Y2.",
     {{"1401.1", 1}},
     {},
     "IIIIII"},
    {"of MELDAS: G28 begins and G29 ends with a G00",
     "meldas",
     "G28X1.Y2.\nG29X3.Y1.",
     {},
     {},
     "SIIS"},
    {"G53 is not straightened", "fanuc-16i", "G53X1.Y2.\nG0X2.", {{"1401.1", 1}}, {}, "IS"},
    {"of MELDAS it goes as G00 does", "meldas", "G53X1.Y2.", {}, {}, "S"},
    {"positioning, R and retract of a canned cycle",
     "fanuc-16i",
     "G81X1.Y2.Z-3.R1.F100\nG80",
     {},
     {},
     "III"},
    {"contour control makes them straight",
     "fanuc-30i",
     "G0X1.Y2.\nG5.1Q1\nG0X2.Y1.\nG5.1Q0\nG0X1.Y2.",
     {},
     {},
     "ISI"},
    {"unless AIR says as usual", "fanuc-30i", "G5.1Q1\nG0X2.Y1.", {{"7054.1", 1}}, {}, "I"},
    {"and LRP straight", "fanuc-30i", "G5.1Q1\nG0X2.Y1.", {{"7054.1", 1}, {"1401.1", 1}}, {}, "S"},
    {"in cutter compensation",
     "fanuc-16i",
     "G41D1G1X10.F100\nG0X20.Y10.\nG40X30.Y30.",
     {},
     {},
     "II"},
};

TEST(RapidPath, OfFanucControlsFollowsProfileParametersAndContourControl) {
  for (const FanucCase& c : kFanucCases) {
    SCOPED_TRACE(c.name);
    runtime::ControlSetup setup;
    setup.parameters = c.parameters;
    setup.rapids = c.sheet;
    setup.tools[1].radius_mm = 1.0;
    testing::ControlRun run(c.profile, c.program, setup);
    EXPECT_EQ(run.alarm(), 0);
    EXPECT_EQ(paths_of(run.machine()), c.paths);
  }
}

void run_sinumerik(const std::string& program, runtime::ControlSetup setup,
                   testing::RecordingMachine& machine) {
  testing::FilesInMemory files({{"main.mpf", program + "M30\n"}});
  source::SourceMap sources(files);
  sinumerik::ProgramLibrary library(sources);
  library.add_file("main.mpf");
  runtime::Observer observer;
  sinumerik::Session session(library, machine, observer);
  setup.tools[1].radius_mm = 1.0;
  EXPECT_TRUE(session.configure(setup).empty());
  const runtime::Outcome outcome = session.run({});
  EXPECT_FALSE(outcome.alarm) << outcome.alarm->text;
}

TEST(RapidPath, OfSinumerikIsStraightUnlessRtliofActs) {
  struct Case {
    const char* name;
    const char* program;
    std::optional<machine::RapidPath> sheet;
    const char* paths;
  };
  const Case kCases[] = {
      {"as delivered", "G0 X1 Y2\nX3\n", {}, "SS"},
      {"RTLIOF until RTLION", "RTLIOF\nG0 X1 Y2\nRTLION X3 Y4\n", {}, "IS"},
      {"only with exact stop", "RTLIOF G64\nG0 X1 Y2\nG60 X3 Y4\nG641 X5 Y5\n", {}, "SIS"},
      {"only without compressor", "RTLIOF COMPON\nG0 X1 Y2\nCOMPOF\nX3 Y4\n", {}, "SI"},
      {"only without compensation",
       "RTLIOF\nT1 M6\nD1\nG1 G41 X10 Y10 F100\nG0 X20 Y10\n"
       "G40 X30 Y30\nX40 Y50\n",
       {},
       "SII"},
      {"machine data of the start", "G0 X1 Y2\nIF $P_GG[55]<>2\nG0 X5\nENDIF\n",
       machine::RapidPath::Independent, "I"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    testing::RecordingMachine machine;
    runtime::ControlSetup setup;
    setup.rapids = c.sheet;
    run_sinumerik(c.program, setup, machine);
    EXPECT_EQ(paths_of(machine), c.paths);
  }
}

TEST(ContourControl, OfSinumerikLooksAheadAndFfwonFeedsForward) {
  testing::RecordingMachine machine;
  run_sinumerik("G1 X1 F100\nFFWON\nX2\nG2 X4 CR=1\nFFWOF G1 X5\n", {}, machine);
  using enum machine::ContourControl;
  EXPECT_EQ(machine.contour_controls(),
            (std::vector{LookAhead, FeedForward, FeedForward, LookAhead}));
}

}  // namespace
}  // namespace g31::rapid_paths_test
