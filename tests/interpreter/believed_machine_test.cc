// What Fanuc parameters make of a machine: hypothetical axes, tools that do not lie along Z, groups
// of the table's offset, speeds.  The true machine stands as the parameters say; where its tip is
// comes from its own chain.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/interpreter/traced_machine.h"
#include "tests/support/control_run.h"
#include "tests/support/worked_machines.h"

namespace g31::fanuc::believed_machine_test {
namespace {

using machine::AxisChainSetup;
using testing::ControlRun;
using testing::FilesInMemory;
using Values = std::map<std::string, double>;

/// Turns the rotary axes about the tip and says how far it leaves its place in the part.
class HeldRun final : public runtime::Observer {
 public:
  HeldRun(const AxisChainSetup& truth, const Values& parameters, const std::string& program)
      : files_({{"case.nc", "O0001\n" + program + "\nM30\n"}}),
        sources_(files_),
        library_(sources_),
        traced_(truth, Point(300, 100, -500), 0.01) {
    library_.add_file("case.nc");
    Session session(*find_profile("fanuc-30i"), library_, traced_.centre(), *this);
    runtime::ControlSetup told = traced_.told(truth);
    told.parameters = parameters;
    testing::TracedMachine::run(session, told);
  }

  /// From when the axis turns.  @returns how many samples there are
  int off(int turning, double& worst) const {
    const Point held = traced_.tip_at(traced_.end());
    int count = 0;
    bool turns = false;
    double before = traced_.samples().front().q_M_commanded[turning];
    for (const machine::TraceSample& sample : traced_.samples()) {
      turns = turns || sample.q_M_commanded[turning] != before;
      if (turns) {
        ++count;
        worst = std::max(worst, (traced_.tip_at(sample.q_M_commanded) - held).norm());
      }
    }
    return count;
  }
  [[nodiscard]] Point tip_at_end() const { return traced_.tip_at(traced_.end()); }

 private:
  FilesInMemory files_;
  source::SourceMap sources_;
  ProgramLibrary library_;
  testing::TracedMachine traced_;
};

struct Held {
  const char* name;
  AxisChainSetup truth;
  Values parameters;
  const char* stands;  ///< where the axis that is none for the control stands
  const char* turns;   ///< the others
  int turning;         ///< storage index
  bool is_of_head;     ///< places of the part are those with all axes at 0
};

AxisChainSetup about_gauge_point(const std::string& head, std::size_t axis) {
  AxisChainSetup setup = machine::worked::chain("", head);
  setup.rotary[2].p_M_centre = {0, 5, 0};
  setup.rotary.at(axis).p_M_centre = Point::Zero();
  return setup;
}

/// Machines with an axis of the head or of the table that stands for good.
std::vector<Held> with_fixed_axes() {
  using namespace machine::worked;  // NOLINT(google-build-using-namespace)
  return {{"axis at the spindle",
           k4(),
           {{"19686", 0}, {"19690", 30}, {"19696.1", 1}},
           "A30.",
           "C-170.F3000.\nC170.",
           5,
           true},
          {"axis at the column",
           k4(),
           {{"19681", 0}, {"19685", 40}, {"19696.0", 1}},
           "C40.",
           "A-70.F3000.\nA70.",
           3,
           true},
          {"inclined axis at the spindle",
           k5(),
           {{"19686", 0}, {"19690", -50}, {"19696.1", 1}},
           "B-50.",
           "C-170.F3000.\nC170.",
           5,
           true},
          {"head over a table",
           k2(),
           {{"19681", 0}, {"19685", 25}, {"19696.0", 1}},
           "B25.",
           "C-170.F3000.\nC170.",
           5,
           true},
          {"table under a head",
           k2(),
           {{"19686", 0}, {"19690", 35}, {"19696.1", 1}},
           "C35.",
           "B-70.F3000.\nB70.",
           4,
           false},
          {"table at the bed",
           k1(),
           {{"19681", 0}, {"19685", 20}, {"19696.0", 1}},
           "A20.",
           "C-170.F3000.\nC170.",
           5,
           false},
          {"table under the part",
           k1(),
           {{"19686", 0}, {"19690", 50}, {"19696.1", 1}},
           "C50.",
           "A-70.F3000.\nA70.",
           3,
           false}};
}

/// Machines whose tool does not lie along Z.
std::vector<Held> with_turned_tools() {
  return {
      {"tilted by RA",
       about_gauge_point("XYZCA", 0),
       {{"19686", 0}, {"19698", 30}},
       "A30.",
       "C-170.F3000.\nC170.",
       5,
       true},
      {"tilted by RB",
       about_gauge_point("XYZCB", 1),
       {{"19686", 0}, {"19699", -35}},
       "B-35.",
       "C-170.F3000.\nC170.",
       5,
       true},
      {"along X",
       about_gauge_point("XYZCB", 1),
       {{"19686", 0}, {"19697", 1}},
       "B90.",
       "C-170.F3000.\nC170.",
       5,
       true},
      {"along Y",
       about_gauge_point("XYZCA", 0),
       {{"19686", 0}, {"19697", 2}},
       "A-90.",
       "C-170.F3000.\nC170.",
       5,
       true},
  };
}

TEST(BelievedMachine, HoldsTheTipWithAxesThatStandForGood) {
  std::vector<Held> rows = with_fixed_axes();
  const std::vector<Held> turned = with_turned_tools();
  rows.insert(rows.end(), turned.begin(), turned.end());
  for (const Held& row : rows) {
    SCOPED_TRACE(row.name);
    const std::string program =
        std::string("G90G0") + row.stands + "\nG43.4H1\nG1X30.Y-20.Z10.F1000.\n" + row.turns;
    const HeldRun run(row.truth, row.parameters, program);
    double worst = 0.0;
    EXPECT_GT(run.off(row.turning, worst), 300);
    EXPECT_LT(worst, 1e-9);
    if (row.is_of_head) {
      EXPECT_LT((run.tip_at_end() - Point(30, -20, 10)).norm(), 1e-9);
    }
    // An error that the parameters have is one of the tip.
    Values wrong = row.parameters;
    for (const char* const angle : {"19685", "19690", "19698", "19699"}) {
      if (wrong.contains(angle)) {
        wrong[angle] += 0.1;
        double off = 0.0;
        HeldRun(row.truth, wrong, program).off(row.turning, off);
        EXPECT_GT(off, std::string(row.name) == "table under a head" ||
                               std::string(row.name) == "table under the part"
                           ? -1.0
                           : 0.01);
      }
    }
  }
}

runtime::ControlSetup told_of(const AxisChainSetup& chain, const Values& parameters) {
  runtime::ControlSetup setup;
  setup.kinematics = chain;
  setup.parameters = parameters;
  setup.work_offsets["G54"] = AxisPositions::Zero();
  setup.tools[1].length_mm = 120.0;
  return setup;
}

TEST(BelievedMachine, TheOffsetOfATiltedToolReadsAlongIt) {
  ControlRun run("fanuc-30i",
                 "G90G43.4H1\nG1X30.Y-20.Z10.F1000.\n#100=#5081\n#101=#5082\n#102=#5083",
                 told_of(machine::worked::k4(), {{"19686", 0}, {"19698", 30}}));
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_NEAR(run.value("#100").value_or(1e9), 0.0, 1e-9);
  EXPECT_NEAR(run.value("#101").value_or(1e9), -60.0, 1e-9);
  EXPECT_NEAR(run.value("#102").value_or(1e9), 60.0 * std::sqrt(3.0), 1e-9);
}

TEST(BelievedMachine, ParametersThatMakeNoMachineAreRefused) {
  const char* const program = "G90G43.4H1\nG1X1.F100.";
  const Values rows[] = {{{"19696.0", 1}},  // and an axis
                         {{"19681", 0}, {"19696.0", 1}, {"19686", 0}, {"19696.1", 1}},
                         {{"19697", 4}},
                         {{"19698", 1000}},
                         {{"19681", 0}, {"19696.0", 1}, {"19685", 1000}},
                         {{"19681", 0}}};
  for (const Values& parameters : rows) {
    ControlRun run("fanuc-30i", program, told_of(machine::worked::k1(), parameters));
    EXPECT_EQ(run.alarm(), 5420);
  }
}

/// (0.5, -0.3, 0.1) at C 0, in the axes of the machine.
Point table_offset(const Values& parameters, const std::string& turned) {
  ControlRun run("fanuc-30i",
                 "G90G10L21P1X0.5Y-0.3Z0.1A0C0\nG0" + turned +
                     "\nG54.2P1\nG0X10.Y20.Z30.\n#100=#5021\n#101=#5022\n#102=#5023",
                 told_of(machine::worked::k1(), parameters));
  EXPECT_EQ(run.alarm(), 0);
  return Point(run.value("#100").value_or(1e9), run.value("#101").value_or(1e9),
               run.value("#102").value_or(1e9)) -
         Point(10, 20, 30);
}

TEST(BelievedMachine, TheTablesOffsetTurnsByItsGroups) {
  const Values as_table = {{"7580", 6}, {"7581", 2}, {"7582", 1},
                           {"7583", 4}, {"7584", 3}, {"7585", 2}};
  EXPECT_LT((table_offset(as_table, "C90.") - Point(-0.3, -0.5, 0.1)).norm(), 1e-9);
  EXPECT_LT((table_offset(as_table, "C150.") - Point(-0.583012702, 0.009807621, 0.1)).norm(), 1e-8);
  for (const char* const turned : {"A0C0", "A30.C-70.", "A-50.C110."}) {
    EXPECT_LT((table_offset(as_table, turned) - table_offset({}, turned)).norm(), 1e-9) << turned;
  }
  // The other way about, and one group alone.
  const Values other = {{"7580", 6}, {"7581", 1}, {"7582", 2}};
  EXPECT_LT((table_offset(other, "A30.C90.") - Point(0.3, 0.5, 0.1)).norm(), 1e-9);
  ControlRun run("fanuc-30i", "G90G54.2P1",
                 told_of(machine::worked::k1(), {{"7580", 6}, {"7581", 1}, {"7582", 1}}));
  EXPECT_EQ(run.alarm(), 5459);
}

TEST(BelievedMachine, AnAxisThatWouldBeLedTooFastIsAnAlarm) {
  const std::string begin = "G90G43.4H1\nG1X30.Y-20.Z10.F1000.\n";
  const auto alarm = [&](const std::string& block, double most) {
    ControlRun run("fanuc-30i", begin + block + "\n#100=#5024",
                   told_of(machine::worked::k1(), {{"1422", most}}));
    return run.alarm();
  };
  EXPECT_EQ(alarm("X31.A60.C180.F1000.", 3000.0), 5422);
  EXPECT_EQ(alarm("X31.A60.C180.F1.", 3000.0), 0);
  EXPECT_EQ(alarm("X31.A60.C180.F1000.", 0.0), 0);
  EXPECT_EQ(alarm("A60.C180.F1000.", 3000.0), 0) << "the tip stands";
  // 180 degrees on 180 mm: C goes as fast as the tip; the axes cross some 450 mm below it.
  EXPECT_EQ(alarm("X210.C180.F1000.", 1000.0), 5422);
  EXPECT_EQ(alarm("X210.Y-20.F1000.", 1000.0), 0);
}

}  // namespace
}  // namespace g31::fanuc::believed_machine_test
