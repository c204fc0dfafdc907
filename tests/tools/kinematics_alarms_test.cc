// What CYCLE9960 and CYCLE996 refuse: each alarm once, and nothing is written.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/kinematics_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::kinematics_alarms_test {
namespace {

struct Fault {
  const char* name;
  std::string program;
  int alarm;
};

std::vector<std::string> watched() {
  std::vector<std::string> names = carrier_names();
  for (const char* const name : {"$P_UIFR[1,X,TR]", "$P_UIFR[1,Z,TR]"}) {
    names.emplace_back(name);
  }
  return names;
}

/// The alarm comes, the carrier and the offset stay.
/// @param still  the rotary axes have not turned
void expect_refused(const Fault& fault, const std::vector<std::string>& sheets, bool still) {
  SCOPED_TRACE(fault.name);
  std::vector<std::string> names = watched();
  names.insert(names.end(), {"_OVI[9]", "$AA_IM[A]", "$AA_IM[B]", "$AA_IM[C]"});
  const MeasuringRun before = run_on_sheets("T1 M6", sheets, names);
  const MeasuringRun run = run_on_sheets(over_the_ball(fault.program), sheets, names);
  EXPECT_EQ(run.alarm(), fault.alarm) << run.output.errors;
  for (const std::string& name : watched()) {
    EXPECT_EQ(run.at(name), before.at(name)) << name;
  }
  if (still) {
    for (const char* const axis : {"$AA_IM[A]", "$AA_IM[B]", "$AA_IM[C]"}) {
      EXPECT_FALSE(run.at(axis) > 0.0 || run.at(axis) < 0.0) << axis;
    }
  }
}

std::string call(const std::string& variant, const std::string& series,
                 const std::string& rest = "1,3,5,1,1,0,0") {
  return "CYCLE9960(" + variant + "," + series + "," + rest + ")";
}

const std::string kTables = "1,25,0,-60,60,4,0,0,0,270,4,0";

TEST(KinematicsAlarms, WhatIsAskedWronglyMovesNothing) {
  const std::vector<std::string> sheets = kinematics_sheets(misbelieved_machines().front());
  const Fault kFaults[] = {
      {"a type that is not there", call("11404,\"\"", kTables), 61307},
      {"a tens digit", call("11410,\"\"", kTables), 61307},
      {"probe not turned along", call("11300,\"\"", kTables), 61307},
      {"thousands", call("13400,\"\"", kTables), 61307},
      {"axes", call("21400,\"\"", kTables), 61307},
      {"mode", call("11400,\"\"", kTables, "1,3,5,1,1,2,0"), 61307},
      {"a table as reference head", call("11401,\"\"", kTables, "1,3,5,1,1,0,1"), 61307},
      {"fixed square to the axis", "$SCS_MEA_KIN_MODE[0]=6\n" + call("11400,\"\"", kTables), 61307},
      {"no such fixed value", "$SCS_MEA_KIN_MODE[1]=7\n" + call("11400,\"\"", kTables), 61307},
      {"no path", call("11400,\"\"", kTables, "1,0,5,1,1,0,0"), 61308},
      {"no tool", "D0\n" + call("11400,\"\"", kTables), 61311},
      {"a record too high", call("11400,\"\"", "41,25,0,-60,60,4,0,0,0,270,4,0"), 61313},
      {"no diameter", call("11400,\"\"", "1,0,0,-60,60,4,0,0,0,270,4,0"), 61316},
      {"two points", call("11400,\"\"", "1,25,0,-60,60,2,0,0,0,270,4,0"), 61317},
      {"thirteen points", call("11400,\"\"", "1,25,0,-60,60,4,0,0,0,270,13,0"), 61317},
      {"a narrow range", call("11400,\"\"", "1,25,0,-60,60,4,0,0,0,19,4,0"), 61430},
      {"end position", "$TC_CARR30[1]=-50\n" + call("11400,\"\"", kTables), 61189},
      {"end position of the other axis",
       "$TC_CARR32[1]=50\n" + call("51400,\"\"", "1,25,0,0,0,0,0,0,0,270,4,51"), 61189},
      {"a name that is not there", call("11400,\"HEAD\"", kTables), 61182},
      {"two records without names",
       "$TC_CARR1[2]=0 $TC_CARR7[2]=1 $TC_CARR12[2]=1\n" + call("11400,\"\"", kTables), 61180},
      {"limits the wrong way round",
       "$TC_CARR31[1]=5 $TC_CARR33[1]=-5\n" + call("11400,\"\"", kTables), 61185},
      {"no axis names", "$TC_CARR36[1]=\"\"\n" + call("11400,\"\"", kTables), 61188},
      {"not calibrated", call("11400,\"\"", "2,25,0,-60,60,4,0,0,0,270,4,0"), 61341},
      {"nothing there", "X200\n" + call("11400,\"\"", kTables), 61301},
      {"beside the safe area", call("11400,\"\"", kTables, "1,3,0.15,1,1,0,0"), 61303},
      {"correct only, and nothing was measured", call("12400,\"\"", kTables), 61430},
      {"calculation before three positions", "CYCLE996(1000,1,1)", 61430},
      {"a data record that is not there", "CYCLE996(1000,9,1)", 61182},
      {"a step that is not there", "CYCLE996(10004,1,1,25,0,,,,,,,,3,5)", 61307},
      {"a way that is not there", "CYCLE996(10501,1,1,25,0,,,,,,,,3,5)", 61307},
      {"an axis that is not there", "CYCLE996(30001,1,1,25,0,,,,,,,,3,5)", 61307},
      {"start angle", "CYCLE996(10401,1,1,25,361,,,,,,,,3,5)", 61331},
  };
  for (const Fault& fault : some_of(kFaults)) {
    expect_refused(fault, sheets, true);
  }
}

TEST(KinematicsAlarms, WhatTurnsOutToBeWrongWritesNothing) {
  const std::vector<MisbelievedMachine> machines = misbelieved_machines();
  const std::vector<std::string> sheets = kinematics_sheets(machines.front());
  expect_refused({"vectors beyond S_SETV4", call("11400,\"\"", kTables, "0.01,3,5,1,1,1,0"), 61430},
                 sheets, false);
  expect_refused({"directions beyond SD41611",
                  "$SCS_MEA_KIN_MODE[0]=4 $SCS_MEA_KIN_MODE[1]=6 $SN_CORR_TRAFO_DIR_MAX=0.005\n" +
                      call("11400,\"\"", kTables, "1,3,5,1,1,1,0"),
                  61430},
                 sheets, false);
  expect_refused(
      {"a triangle that is too small",
       "$SCS_MEA_KIN_MIN_ANG_TRIANGLE=20\n" + call("11400,\"\"", "1,25,0,120,240,3,30,0,30,90,3,0"),
       61430},
      kinematics_sheets(machines.at(4)), false);
  expect_refused({"no reference head before",
                  call("11402,\"\"", "1,25,0,120,240,3,30,0,30,90,4,0", "1,3,5,1,1,0,1"), 61321},
                 kinematics_sheets(machines.at(4)), true);
}

TEST(KinematicsAlarms, AToleranceOfTheDiameterIsForEachAxis) {
  std::vector<std::string> sheets = kinematics_sheets(misbelieved_machines().front());
  sheets.emplace_back("[probe]\nrepeatability_mm = 0.001\n");
  const std::string tolerance = "$SCS_MEA_KIN_DM_TOL=0.000001\n";
  expect_refused({"axis 1", tolerance + call("41400,\"\"", kTables), 62321}, sheets, false);
  expect_refused({"axis 2", tolerance + call("51400,\"\"", kTables), 62322}, sheets, false);
}

/// The ball on the axis of the table: it goes round nowhere.
TEST(KinematicsAlarms, ABallOnTheAxisSaysNothing) {
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.believed.rotary[2].p_M_centre = Point(150.1, -40.2, 0);
  machine.truth = machine.believed;
  expect_refused({"singular", call("51400,\"\"", kTables), 61316}, kinematics_sheets(machine),
                 false);
}

TEST(KinematicsAlarms, AMachineWithoutCarriersHasNoKinematics) {
  expect_refused({"no carrier", call("11400,\"\"", kTables), 61181}, {kMeasuringSheet}, true);
}

TEST(KinematicsAlarms, SingleStepsThatAreTooCloseTogether) {
  const std::vector<std::string> sheets = kinematics_sheets(misbelieved_machines().at(4));
  const std::string first =
      head_step(10401, 120, 30) + head_step(10402, 139, 30) + head_step(10403, 240, 30);
  const std::string both =
      first + head_step(20401, 0, 0) + head_step(20402, 0, 30) + head_step(20403, 0, 90);
  expect_refused({"19 degrees, at least 20", both + "CYCLE996(1000,1,1)", 61430}, sheets, false);
  expect_refused({"a segment of 61", both + "CYCLE996(1000,1,1,,,,,,,,,61)", 61430}, sheets, false);
  expect_refused({"offset vectors", both + "CYCLE996(1000,1,1,,,,,,,0.01,5,15,,,,,,1)", 61430},
                 sheets, false);
  const std::string moved = head_step(10401, 120, 30) + head_step(10402, 180, 30) +
                            head_step(10403, 240, 31) + head_step(20401, 0, 0) +
                            head_step(20402, 0, 30) + head_step(20403, 0, 90);
  expect_refused({"the other axis moved", moved + "CYCLE996(1000,1,1)", 61430}, sheets, false);
  expect_refused({"two of axis 2", first + head_step(20401, 0, 0) + "CYCLE996(1000,1,1)", 61430},
                 sheets, false);
}

}  // namespace
}  // namespace g31::testing::kinematics_alarms_test
