// The measuring cycles as programs of earlier software call them: parameters in GUD variables, then
// the bare name.

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::old_measuring_call_test {
namespace {

TEST(OldMeasuringCall, EachCycleTakesItsParametersFromVariables) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
  const std::string block = part("block", 100.2, 50.0, -300.0, "");
  const std::string turned = part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
  const MeasuringCase kRows[] = {
      {"edge, work offset, direction from the set point",
       block,
       "X-40\nZ-5\n_MVAR=100 _SETVAL=-30 _MA=1 _KNUM=1 _FA=5 _TSA=1\nCYCLE978",
       {{"_OVR[4]", -29.8}, {"$P_UIFR[1,X,FI]", 0.2}, {"_OVI[3]", 100}}},
      {"edge from the other side, tool offset inverted",
       block,
       "X40\nZ-5\n_MVAR=0 _SETVAL=30 _MA=1 _KNUM=10001 _FA=5 _TSA=1 _TUL=1 _TLL=-1 _TDIF=1\n"
       "_TNAME=\"MILL\"\nCYCLE978",
       {{"_OVR[4]", 30.2}, {"$TC_DP15[2,1]", 0.2}, {"_OVI[3]", 200}}},
      {"hole, the offset in force",
       ring,
       "Z-5\n_MVAR=101 _SETVAL=40 _KNUM=9999\nCYCLE977",
       {{"_OVR[4]", 40.0}, {"$P_UIFR[1,X,FI]", 0.2}, {"$P_UIFR[1,Y,FI]", -0.3}}},
      {"hole, tool by its number, radius",
       ring,
       "Z-5\n_MVAR=1 _SETVAL=39.9 _KNUM=4001 _TNUM=2 _TUL=1 _TLL=-1 _TDIF=1 _TSA=1\nCYCLE977",
       {{"$TC_DP15[2,1]", 0.05}, {"_OVR[8]", 1.0}, {"_OVR[29]", 1.0}}},
      {"hole, with a DL number the additive offset",
       ring,
       "Z-5\n_MVAR=1 _SETVAL=39.9 _KNUM=4001 _DLNUM=2 _TNUM=2 _TUL=1 _TLL=-1 _TDIF=1 _TSA=1\n"
       "CYCLE977",
       {{"$TC_SCP26[2,1]", 0.05}, {"$TC_DP15[2,1]", 0.0}, {"_OVI[13]", 2}}},
      {"hole, measured only",
       ring,
       "Z-5\n_MVAR=1 _SETVAL=40 _KNUM=0\nCYCLE977",
       {{"_OVR[5]", 0.2}, {"$P_UIFR[1,X,FI]", 0.0}}},
      {"basic frame",
       ring,
       "Z-5\n_MVAR=101 _SETVAL=40 _KNUM=1011\nCYCLE977",
       {{"$P_BFRAME[X,FI]", 0.2}, {"$P_UIFR[1,X,FI]", 0.0}}},
      {"angle",
       turned,
       "X-20 Y-27\nZ-5\n_MVAR=105 _KNUM=1 _MA=102 _ID=30 _FA=6 _TSA=5 _SETVAL=-20\nCYCLE998",
       {{"_OVR[4]", 3.0}, {"$P_UIFR[1,Z,RT]", 3.0}}},
      {"angle, basic frame",
       turned,
       "X-20 Y-27\nZ-5\n_MVAR=105 _KNUM=1011 _MA=102 _ID=30 _FA=6 _TSA=5 _SETVAL=-20\nCYCLE998",
       {{"_OVR[4]", 3.0}, {"$P_UIFR[1,Z,RT]", 0.0}, {"$P_CHBFR[0,Z,RT]", 3.0}}},
      {"corner",
       turned,
       "X-42 Y-32\nZ-5\n_MVAR=6 _SETV[0]=20 _SETV[1]=45 _SETV[2]=15 _FA=15\nCYCLE961",
       {{"_OVR[4]", 3.0}}},
      {"arc",
       part("ring", 100.2, 49.7, -300.0, "bore = 40.0\nsagitta = 0.0000005"),
       "Z-5\n_MVAR=1 _SETVAL=40 _INCA=120 _FA=2\nCYCLE979",
       {{"_OVR[4]", 40.0}}},
  };
  expect_measured(kRows, 2e-6);
}

TEST(OldMeasuringCall, CalibrationAndMemories) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
  expect_measured(
      "Z-5\n_MVAR=8 _SETVAL=40 _FA=5 _TSA=5 _PRNUM=2\nCYCLE976\n_EV[1]=0.125 _MV[0]=0.25",
      {ring, kBentProbe},
      {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[1]", 2.995},
       {"$SNS_MEA_WP_POS_DEV_AX1[1]", 0.02},
       {"$SCS_MEA_EMPIRIC_VALUE[1]", 0.125},
       {"$SCS_MEA_AVERAGE_VALUE[0]", 0.25}},
      1e-4);
  expect_measured("X30\nZ3\n_MVAR=10000 _SETVAL=0.5 _FA=3 _TSA=5\nCYCLE976",
                  {part("block", 130.0, 50.0, -299.5, ""), kBentProbe}, {{"$TC_DP3[1,1]", 119.995}},
                  1e-6);
}

}  // namespace
}  // namespace g31::testing::old_measuring_call_test
