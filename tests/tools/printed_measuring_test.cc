// Programs as the manual of the measuring cycles prints them, with parts that fit.

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::printed_measuring_test {
namespace {

MeasuringRun run_printed(const std::string& program, const std::string& parts,
                         const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("TE_977_BOHR.MPF", program)};
  options.setups = {folder.write("base.toml", testing::kMeasuringSheet),
                    folder.write("parts.toml", parts),
                    folder.write("data.toml", testing::kCalibrated)};
  options.prints = names;
  return {testing::run_program(options)};
}

/// A probe of the manual's name beside the usual tools, its hole or groove at the origin.
const char* const kNames =
    "[tools.710]\nlength = 120.0\nradius = 3.0\ntype = 710.0\nname = \"3D_PROBE_FR\"\n"
    "[tools.711]\nlength = 120.0\nradius = 3.0\ntype = 710.0\nname = \"3D_TASTER\"\n";

TEST(PrintedMeasuringProgram, StandardLogWithUserData) {
  const MeasuringRun run = run_printed(
      "R99=68.7\nG54\nN50 CYCLE150(10,1001,\"PROT_TE_977_BOHR.TXT\")\nN51 S_LOGTXT[0]=REP(\"\")\n"
      "N52 S_LOGTXT[0]=\"HOLE DM 20H7\"\nN53 S_LOGTXT[1]=\"LARGESTDIMENSION:20.021\"\n"
      "N54 S_LOGTXT[2]=\"SMALLESTDIMENSION:20.000\"\nN55 "
      "S_LOGTXT[3]=\"SPINDLETEMPERATURE:\"<<R99<<\" DEG\"\n"
      "N60 CYCLE160\nT=\"3D_PROBE_FR\" D1 M6\nG0 X0 Y0 Z5\nZ-5\n"
      "N70 "
      "CYCLE977(201,,4000001,1,24,,,2,8,0,1,1,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\nM30\n",
      part("ring", 99.98, 50.03, -300.0, "bore = 23.84") + kNames,
      {"_OVR[4]", "_OVR[5]", "_OVR[6]", "_OVR[16]", "_OVR[17]", "_OVR[18]", "_OVI[3]", "_OVI[9]"});
  ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
  EXPECT_NEAR(run.at("_OVR[4]"), 23.84, 1e-6);
  EXPECT_NEAR(run.at("_OVR[16]"), -0.16, 1e-6);
  EXPECT_NEAR(run.at("_OVR[17]"), -0.02, 1e-6);
  EXPECT_NEAR(run.at("_OVR[18]"), 0.03, 1e-6);
  EXPECT_EQ(run.at("_OVI[9]"), 0.0);
  const std::string log = run.output.document.at("files").at("PROT_TE_977_BOHR.TXT");
  EXPECT_NE(log.find("Program  : _N_TE_977_BOHR_MPF\n"), std::string::npos);
  EXPECT_NE(log.find("SPINDLETEMPERATURE:68.7 DEG\n"), std::string::npos);
  EXPECT_NE(log.find("Diameter        24.0000          23.8400          -0.1600 mm\n"),
            std::string::npos)
      << log;
}

TEST(PrintedMeasuringProgram, GrooveWithAUserLogOfItsResults) {
  const MeasuringRun run = run_printed(
      "T=\"3D_TASTER\"\nM6\nG54\nF2000\nCYCLE150(31,1,\"MEAS_PROTOCOL.TXT\")\nG0 X0 Y0\nZ-5\n"
      "CYCLE977(103,1,,1,50,,,5,5,0,1,1,,1,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\n"
      "S_PROTTXT[0]=REP(\"\")\nS_PROTTXT[0]=\"1st probe:\"\n"
      "S_PROTTXT[1]=SPRINT(\"X %10.3F          %10.3F          %10.3F "
      "mm\",_OVR[1],_OVR[5],_OVR[17])\n"
      "CYCLE160\nG1 X0\nM2\n",
      part("groove", 100.1, 50.0, -300.0, "width = 50.0") + kNames, {"$P_UIFR[1,X,FI]", "$P_F"});
  ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
  EXPECT_NEAR(run.at("$P_UIFR[1,X,FI]"), 0.1, 1e-6);
  EXPECT_EQ(run.at("$P_F"), 2000.0);
  const std::string log = run.output.document.at("files").at("MEAS_PROTOCOL.TXT");
  EXPECT_TRUE(
      log.ends_with("1st probe:\nX      0.000               0.100               0.100 mm\n"))
      << log;
}

}  // namespace
}  // namespace g31::testing::printed_measuring_test
