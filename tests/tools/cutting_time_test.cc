// $AC_CUTTING_TIME on a machine whose moves take their time.

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::cutting_time_test {
namespace {

/// 10 mm at 600 mm/min are a second, and a little more for speeding up and braking.
constexpr const char* kMoves =
    "G0 X0 Z50\n"
    "G1 F600 X10\n"
    "R1=$AC_CUTTING_TIME\n"
    "G0 X0\n"
    "R2=$AC_CUTTING_TIME-R1\n"
    "FA[X]=600 POS[X]=10\n"
    "R3=$AC_CUTTING_TIME-R1\n"
    "MEAS=1 G1 X20\n"
    "R4=$AC_CUTTING_TIME-R1\n"
    "R7=$AC_MEA[1]\n"
    "R5=(R1>=1) AND (R1<1.2) R6=(R4>=1) AND (R4<1.2)\n";

TEST(CuttingTime, CountsThePathAtItsFeedAndMeasuringOnIt) {
  expect_measured(kMoves, {ring_aside(), kCalibrated},
                  {{"R2", 0.0}, {"R3", 0.0}, {"R5", 1.0}, {"R6", 1.0}});
}

}  // namespace
}  // namespace g31::testing::cutting_time_test
