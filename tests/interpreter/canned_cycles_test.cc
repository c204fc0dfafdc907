// Every canned cycle move by move, as the operator's manuals draw it (MB-306 to MB-313).

#include "interpreter/dialects/fanuc/vocabulary/canned_cycles.h"

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::fanuc::canned_cycles_test {
namespace {

using testing::ControlRun;

runtime::ControlSetup with(std::map<std::string, double> parameters) {
  runtime::ControlSetup setup;
  setup.parameters = std::move(parameters);
  return setup;
}

/// The moves of a program that starts at X0 Y0 Z10 with F100, those before it left out.
std::vector<std::string> moves_of(const std::string& program,
                                  const runtime::ControlSetup& setup = {}) {
  ControlRun run("fanuc-16i", "F100\nG0Z10.\n" + program, setup);
  EXPECT_EQ(run.alarm(), 0);
  const auto& log = run.machine().log();
  return {log.begin() + 1, log.end()};
}

using Moves = std::vector<std::string>;

struct StepCase {
  const char* name;
  const char* program;
  Moves moves;
};

const StepCase kSteps[] = {
    {"G81 to the initial level",
     "G98G81X5.Z-3.R2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.000 0.000 10.000 rapid"}},
    {"G81 to R",
     "G99G81X5.Z-3.R2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.000 0.000 2.000 rapid"}},
    {"G82 dwells",
     "G99G82X5.Z-3.R2.P500",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "dwell 0.5", "move 5.000 0.000 2.000 rapid"}},
    {"G73 breaks chips",
     "G99G73X5.Z-5.R1.Q2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 1.000 rapid",
      "move 5.000 0.000 -1.000 F100", "move 5.000 0.000 -0.500 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.000 0.000 -2.500 rapid",
      "move 5.000 0.000 -5.000 F100", "move 5.000 0.000 1.000 rapid"}},
    {"G83 clears chips",
     "G98G83X5.Z-5.R1.Q3.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 1.000 rapid",
      "move 5.000 0.000 -2.000 F100", "move 5.000 0.000 1.000 rapid",
      "move 5.000 0.000 -1.750 rapid", "move 5.000 0.000 -5.000 F100",
      "move 5.000 0.000 10.000 rapid"}},
    {"a peck that ends at Z is the last",
     "G99G83X5.Z-3.R1.Q2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 1.000 rapid",
      "move 5.000 0.000 -1.000 F100", "move 5.000 0.000 1.000 rapid",
      "move 5.000 0.000 -0.750 rapid", "move 5.000 0.000 -3.000 F100",
      "move 5.000 0.000 1.000 rapid"}},
    {"G84 taps and comes out at feed, dwelling twice",
     "G98G84X5.Z-3.R2.P200",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "dwell 0.2", "move 5.000 0.000 2.000 F100", "dwell 0.2",
      "move 5.000 0.000 10.000 rapid"}},
    {"G74 as G84",
     "G99G74X5.Z-3.R2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.000 0.000 2.000 F100"}},
    {"G85 comes out at feed",
     "G98G85X5.Z-3.R2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.000 0.000 2.000 F100",
      "move 5.000 0.000 10.000 rapid"}},
    {"G86 comes out at rapid",
     "G98G86X5.Z-3.R2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.000 0.000 10.000 rapid"}},
    {"G88 dwells and is drawn out by hand to R",
     "G98G88X5.Z-3.R2.P100",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "dwell 0.1", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 10.000 rapid"}},
    {"G89 dwells and comes out at feed",
     "G99G89X5.Z-3.R2.P100",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "dwell 0.1", "move 5.000 0.000 2.000 F100"}},
    {"G76 steps off the wall",
     "G98G76X5.Z-3.R2.Q0.5P100",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 2.000 rapid",
      "move 5.000 0.000 -3.000 F100", "dwell 0.1", "move 5.500 0.000 -3.000 rapid",
      "move 5.500 0.000 10.000 rapid", "move 5.000 0.000 10.000 rapid"}},
    {"G87 bores upwards",
     "G98G87X5.Z-3.R-8.Q0.5",
     {"move 5.000 0.000 10.000 rapid", "move 5.500 0.000 10.000 rapid",
      "move 5.500 0.000 -8.000 rapid", "move 5.000 0.000 -8.000 rapid",
      "move 5.000 0.000 -3.000 F100", "move 5.500 0.000 -3.000 rapid",
      "move 5.500 0.000 10.000 rapid", "move 5.000 0.000 10.000 rapid"}},
};

TEST(CannedCycle, GoesStepByStep) {
  for (const StepCase& c : kSteps) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(moves_of(c.program, with({{"5114", 0.5}, {"5115", 0.25}})), c.moves);
  }
}

struct DataCase {
  const char* name;
  const char* program;
  Moves last;  ///< the last moves
};

const DataCase kData[] = {
    {"a place alone is another hole",
     "G99G81X5.Z-3.R2.\nX7.",
     {"move 7.000 0.000 2.000 rapid", "move 7.000 0.000 2.000 rapid",
      "move 7.000 0.000 -3.000 F100", "move 7.000 0.000 2.000 rapid"}},
    {"a new depth at the same place",
     "G99G81X5.Z-3.R2.\nZ-4.",
     {"move 5.000 0.000 2.000 rapid", "move 5.000 0.000 -4.000 F100",
      "move 5.000 0.000 2.000 rapid"}},
    {"another cycle takes the data over",
     "G99G81X5.Z-3.R2.\nG85X6.",
     {"move 6.000 0.000 2.000 rapid", "move 6.000 0.000 2.000 rapid",
      "move 6.000 0.000 -3.000 F100", "move 6.000 0.000 2.000 F100"}},
    {"G98 later still finds the initial level",
     "G99G81X5.Z-3.R2.\nG98X6.",
     {"move 6.000 0.000 -3.000 F100", "move 6.000 0.000 10.000 rapid"}},
    {"a block without axes makes no hole",
     "G99G81X5.Z-3.R2.\nM8",
     {"move 5.000 0.000 2.000 rapid"}},
    {"a dwell block makes no hole", "G99G81X5.Z-3.R2.\nG4X1.", {"dwell 1"}},
    {"G80 gives the motion back", "G99G81X5.Z-3.R2.\nG80X9.", {"move 9.000 0.000 2.000 rapid"}},
    {"a code of group 01 ends it, too", "G99G81X5.Z-3.R2.\nG1X9.", {"move 9.000 0.000 2.000 F100"}},
    {"the later of both codes counts", "G99G1G81X5.Z-3.R2.", {"move 5.000 0.000 2.000 rapid"}},
    {"G91 counts R from the initial level and Z from R",
     "G91G99G81X5.Z-4.R-8.",
     {"move 5.000 0.000 2.000 rapid", "move 5.000 0.000 -2.000 F100",
      "move 5.000 0.000 2.000 rapid"}},
    {"K repeats along G91",
     "G91G99G81X5.Z-4.R-8.K3",
     {"move 15.000 0.000 2.000 rapid", "move 15.000 0.000 -2.000 F100",
      "move 15.000 0.000 2.000 rapid"}},
    {"K0 only keeps the data",
     "G99G81X5.Z-3.R2.K0\nX7.",
     {"move 7.000 0.000 10.000 rapid", "move 7.000 0.000 2.000 rapid",
      "move 7.000 0.000 -3.000 F100", "move 7.000 0.000 2.000 rapid"}},
    {"polar places",
     "G16G99G81X5.Y90.Z-3.R2.",
     {"move 0.000 5.000 2.000 rapid", "move 0.000 5.000 -3.000 F100",
      "move 0.000 5.000 2.000 rapid"}},
    {"incremental angles repeat",
     "G16G99G81X5.Y0Z-3.R2.\nG91Y90.K2",
     {"move -5.000 0.000 2.000 rapid", "move -5.000 0.000 -3.000 F100",
      "move -5.000 0.000 2.000 rapid"}},
    {"turned places",
     "G68X0Y0R90.\nG99G81X5.Y0Z-3.R2.",
     {"move 0.000 5.000 2.000 rapid", "move 0.000 5.000 -3.000 F100",
      "move 0.000 5.000 2.000 rapid"}},
    {"scaling leaves the pecks as they are",
     "G51X0Y0Z0P2000\nG99G73X5.Z-1.R1.Q3.",
     {"move 10.000 0.000 2.000 rapid", "move 10.000 0.000 -1.000 F100",
      "move 10.000 0.000 -0.500 rapid", "move 10.000 0.000 -2.000 F100",
      "move 10.000 0.000 2.000 rapid"}},
    {"the tool offset comes with the move to R",
     "#11001=20.\nG43H1G99G81X5.Z-3.R2.",
     {"move 5.000 0.000 10.000 rapid", "move 5.000 0.000 22.000 rapid",
      "move 5.000 0.000 17.000 F100", "move 5.000 0.000 22.000 rapid"}},
    {"feed per revolution",
     "G95S500F0.2\nG99G84X5.Z-3.R2.",
     {"move 5.000 0.000 -3.000 F100", "move 5.000 0.000 2.000 F100"}},
};

TEST(CannedCycle, KeepsItsDataUntilItEnds) {
  for (const DataCase& c : kData) {
    SCOPED_TRACE(c.name);
    const Moves moves = moves_of(c.program, with({{"5114", 0.5}}));
    ASSERT_GE(moves.size(), c.last.size());
    EXPECT_EQ(Moves(moves.end() - static_cast<std::ptrdiff_t>(c.last.size()), moves.end()), c.last);
  }
}

TEST(CannedCycle, DrillsAcrossThePlaneWhenTheParameterSaysSo) {
  const Moves along_z = moves_of("G18G99G81X5.Z-3.R2.");
  EXPECT_EQ(along_z.back(), "move 5.000 0.000 2.000 rapid");
  const Moves along_y = moves_of("G18G99G81X5.Y-3.R2.", with({{"5101.0", 1}}));
  EXPECT_EQ(along_y, (Moves{"move 5.000 0.000 10.000 rapid", "move 5.000 2.000 10.000 rapid",
                            "move 5.000 -3.000 10.000 F100", "move 5.000 2.000 10.000 rapid"}));
  const Moves along_x = moves_of("G19G99G81Y5.X-3.R2.", with({{"5101.0", 1}}));
  EXPECT_EQ(along_x.back(), "move 2.000 5.000 10.000 rapid");
}

TEST(CannedCycle, ShiftsToTheSideOfItsParameters) {
  struct Case {
    const char* name;
    double negative, second;
    const char* aside;
  };
  const Case kCases[] = {
      {"+X", 0, 0, "move 5.500 0.000 -3.000 rapid"},
      {"-X", 1, 0, "move 4.500 0.000 -3.000 rapid"},
      {"+Y", 0, 1, "move 5.000 0.500 -3.000 rapid"},
      {"-Y", 1, 1, "move 5.000 -0.500 -3.000 rapid"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const Moves moves =
        moves_of("G99G76X5.Z-3.R2.Q0.5", with({{"5101.4", c.negative}, {"5101.5", c.second}}));
    EXPECT_EQ(moves.at(3), c.aside);
  }
}

/// So many pecks as whole ones go into the depth, whatever their sum is rounded to.
TEST(CannedCycle, PecksNoRestOfRounding) {
  for (int pecks = 1; pecks <= 40; ++pecks) {
    for (int tenths = 1; tenths <= 20; ++tenths) {
      const std::string depth = std::to_string(pecks * tenths * 100);  // least increments
      const Moves moves = moves_of("G99G83X5.Z-" + depth + "R0Q" + std::to_string(tenths * 100));
      // Two to get there, one for each peck, two between two of them, one back to R.
      EXPECT_EQ(moves.size(), static_cast<std::size_t>(2 + pecks + 2 * (pecks - 1) + 1))
          << pecks << " pecks of " << tenths << " tenths";
    }
  }
}

TEST(CannedCycle, TellsOfPecksOfTapping) {
  const ControlRun run("fanuc-16i", "F100\nG0Z10.\nG99G84X5.Z-3.R2.Q1.");
  EXPECT_EQ(run.alarm(), 0);
  ASSERT_EQ(run.outcome().diagnostics.size(), 1u);
  EXPECT_EQ(run.outcome().diagnostics.front().code, "PRB304");
}

TEST(CannedCycle, RepeatsByLWhereTheControlDoes) {
  const std::string by_l = "G91G99G81X5.Z-4.R-8.L2";
  EXPECT_EQ(moves_of(by_l).size(), 4u);
  EXPECT_EQ(moves_of(by_l, with({{"1.1", 1}})).size(), 8u);
  EXPECT_EQ(ControlRun("haas", "F100\n" + by_l).machine().log().size(), 8u);
}

TEST(CannedCycle, RefusesWhatTheControlRefuses) {
  struct Case {
    const char* name;
    const char* program;
    int alarm;
  };
  const Case kCases[] = {
      {"G28 between holes", "F100\nG81X5.Z-3.R2.\nG28Z0", 44},
      {"G27, too", "F100\nG81X5.Z-3.R2.\nG27Z0", 44},
      {"G30, too", "F100\nG81X5.Z-3.R2.\nG30Z0", 44},
      {"after G80 it is allowed", "F100\nG81X5.Z-3.R2.\nG80\nG28Z0", 0},
      {"G83 without Q", "F100\nG83X5.Z-3.R2.", 45},
      {"G73 with Q0", "F100\nG73X5.Z-3.R2.Q0", 45},
      {"no feed", "G81X5.Z-3.R2.", 11},
      {"K with a point", "F100\nG81X5.Z-3.R2.K2.", 7},
      {"a dwell below 0", "F100\nG82X5.Z-3.R2.P-1", 6},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun("fanuc-16i", c.program).alarm(), c.alarm);
  }
}

TEST(CannedCycle, IsModalGroup9) {
  ControlRun run("fanuc-16i",
                 "F100\nG99G81X5.Z-3.R2.\n#101=#4009\n#102=#4001\n#103=#4010\nG80\n#104=#4009");
  EXPECT_EQ(run.value("#101"), 81);
  EXPECT_EQ(run.value("#102"), 0);
  EXPECT_EQ(run.value("#103"), 99);
  EXPECT_EQ(run.value("#104"), 80);
}

}  // namespace
}  // namespace g31::fanuc::canned_cycles_test
