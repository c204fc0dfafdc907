// CYCLE150 and CYCLE160: logs as text and as table, the user's lines, the last measurement, the
// result screen.  The expected files are written by hand; only the clock's readings are blotted out
// in both.

#include <regex>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::measuring_log_test {
namespace {

std::string without_clock(const std::string& text) {
  return std::regex_replace(text, std::regex("[0-9]{2}:[0-9]{2}:[0-9]{2}"), "hh:mm:ss");
}

std::string file_of(const MeasuringRun& run, const std::string& name) {
  return without_clock(run.output.document.at("files").value(name, "missing"));
}

MeasuringRun measured(const std::string& program, const std::string& parts,
                      const std::string& more_sheets = {}) {
  MeasuringRun run = run_measuring(program, {parts + more_sheets, kCalibrated}, {"R1"});
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  return run;
}

const char* const kHead = R"(*****************************************************
Date      :2000-01-01          Time:hh:mm:ss
Protocol: LOG.TXT
Program  : _N_PART_MPF
Workpiece no.:1
*****************************************************
)";

const char* const kHole = R"(
-----------------------------------------------------
1                      : 977 / 101          Time:hh:mm:ss
Results measure:1 Hole / CYCLE977

-----------------------------------------------------
Correction into:Work offset, coarse

                G54
                Coarse [mm]      Rotation [deg]
                ---------------------------------
X              100.2000           0.0000
Y               49.7000           0.0000
Z             -300.0000           0.0000
                ---------------------------------

Results:        Setpoint         Measured         Difference
X                0.0000           0.2000           0.2000 mm
Y                0.0000          -0.3000          -0.3000 mm
Diameter        40.0100          40.0000          -0.0100 mm
                ---------------------------------
)";

TEST(MeasuringLog, ThreeMeasurementsOneAfterTheOther) {
  const std::string parts =
      ring_aside() + part("block", 300.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
  const MeasuringRun run = measured(
      "CYCLE150(10,1001,\"LOG.TXT\")\nZ-5\nCYCLE977(101,10001,,1,40.01,,,2,5)\nZ20\n"
      "$P_UIFR[1]=CTRANS(X,300,Y,50,Z,-300)\nG54\nX0 Y0\n"
      "CYCLE978(200,,4000001,1,0.1,2,8,3,2,1,\"MILL\")\nX-20\nY-27\nZ-5\n"
      "CYCLE998(105,10004,,1,,2,,5,3,102,1,30)",
      parts);
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) + kHole + R"(
-----------------------------------------------------
2                      : 978 / 200          Time:hh:mm:ss
Results measure:Set edge / CYCLE978

-----------------------------------------------------
Correction into:Tool offset, length L1, geometry

                MILL D1
Offset           0.1000 mm
                ---------------------------------

Results:        Setpoint         Measured         Difference
Z                0.1000           0.0000          -0.1000 mm
                ---------------------------------

-----------------------------------------------------
3                      : 998 / 105          Time:hh:mm:ss
Results measure:Align edge / CYCLE998

-----------------------------------------------------
Correction into:Work offset, coarse

                G57
                Coarse [mm]      Rotation [deg]
                ---------------------------------
X                0.0000           0.0000
Y                0.0000           0.0000
Z                0.0000           1.0000
                ---------------------------------

Results:        Setpoint         Measured         Difference
Angle            2.0000           3.0000           1.0000 deg
                ---------------------------------
)");
}

TEST(MeasuringLog, Balls) {
  const MeasuringRun run =
      measured("CYCLE150(10,1001,\"LOG.TXT\")\nCYCLE997(1000109,1,1,25,2,5,,,0.1,0,0)",
               part("sphere", 100.2, 49.7, -299.9, "diameter = 25.01"));
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) + R"(
-----------------------------------------------------
1                      : 997 / 1000109          Time:hh:mm:ss
Results measure:1 Sphere / CYCLE997

-----------------------------------------------------
Correction into:Work offset, fine

                G54
                Fine [mm]        Rotation [deg]
                ---------------------------------
X                0.1000           0.0000
Y               -0.3000           0.0000
Z                0.1000           0.0000
                ---------------------------------

Results:        Setpoint         Measured         Difference
X                0.1000           0.2000           0.1000 mm
Y                0.0000          -0.3000          -0.3000 mm
Z                0.0000           0.1000           0.1000 mm
Diameter        25.0000          25.0100           0.0100 mm
                ---------------------------------
)");
}

TEST(MeasuringLog, AsATable) {
  const MeasuringRun run = measured(
      "CYCLE150(0,101,\"//NC:/WKS.DIR/LOG.CSV\")\nZ-5\nCYCLE977(101,10001,,1,40.01,,,2,5)\n"
      "CYCLE977(201,,1,1,40.01,,,2,5,,,,,,,\"MILL\")\nCYCLE977(1,,,1,40.01,,,2,5)",
      ring_aside());
  EXPECT_EQ(file_of(run, "LOG.CSV"), R"(Date;2000-01-01;Time;hh:mm:ss
Protocol;//NC:/WKS.DIR/LOG.CSV
Program;_N_PART_MPF
Workpiece no.;1
1;977;101;Time;hh:mm:ss;1 Hole
Correction into;Work offset, coarse
G54;Coarse [mm];Rotation [deg]
X;100.2000;0.0000
Y;49.7000;0.0000
Z;-300.0000;0.0000
Results;Setpoint;Measured;Difference;Unit
X;0.0000;0.2000;0.2000;mm
Y;0.0000;-0.3000;-0.3000;mm
Diameter;40.0100;40.0000;-0.0100;mm
2;977;201;Time;hh:mm:ss;1 Hole
Correction into;Tool offset, radius, wear
Tool;MILL;D1
Offset;-0.0050;mm
Results;Setpoint;Measured;Difference;Unit
X;0.0000;0.0000;0.0000;mm
Y;0.0000;0.0000;0.0000;mm
Diameter;40.0100;40.0000;-0.0100;mm
3;977;1;Time;hh:mm:ss;1 Hole
Correction into;Measuring only
Results;Setpoint;Measured;Difference;Unit
X;0.0000;0.0000;0.0000;mm
Y;0.0000;0.0000;0.0000;mm
Diameter;40.0100;40.0000;-0.0100;mm
)");
}

TEST(MeasuringLog, LinesOfTheUserAmongTheResults) {
  const MeasuringRun run = measured(
      "R99=68.7\nCYCLE150(10,1001,\"LOG.TXT\")\nS_LOGTXT[0]=REP(\"\")\nS_LOGTXT[0]=\"HOLE DM "
      "20H7\"\n"
      "S_LOGTXT[1]=\"LARGESTDIMENSION:20.021\"\nS_LOGTXT[2]=\"SMALLESTDIMENSION:20.000\"\n"
      "S_LOGTXT[3]=\"SPINDLETEMPERATURE:\"<<R99<<\" DEG\"\nCYCLE160\nZ-5\n"
      "CYCLE977(101,10001,,1,40.01,,,2,5)",
      ring_aside());
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) +
                                         "HOLE DM 20H7\nLARGESTDIMENSION:20.021\n"
                                         "SMALLESTDIMENSION:20.000\nSPINDLETEMPERATURE:68.7 DEG\n" +
                                         kHole);
}

TEST(MeasuringLog, TheUsersOwnLogAndArray) {
  const std::string program =
      "R101=123.456 R102=789.333\nCYCLE150 (10,1111,\"MY_PROT.TXT\")\n{0}[0]=REP(\"\")\n"
      "{0}[0]=\"MACHINE:ABC_12345\"\n{0}[1]=\"LOGFILE COMPENSATION DATA\"\n{0}[2]=\" \"\n"
      "{0}[3]=\"VALUE1 = \"<<R101\n{0}[4]=\"VALUE2 = \"<<R102\n{0}[6]=\"BEHIND AN EMPTY ONE\"\n"
      "CYCLE160\nZ-5\nCYCLE977(1,,,1,40,,,2,5)";
  const char* const kExpected =
      "MACHINE:ABC_12345\nLOGFILE COMPENSATION DATA\n \nVALUE1 = 123.456\nVALUE2 = 789.333\n";
  for (const char* const array : {"S_LOGTXT", "S_PROTTXT", "S_PROTTEXT"}) {
    SCOPED_TRACE(array);
    const MeasuringRun run = measured(fmt::format(fmt::runtime(program), array), ring_aside());
    EXPECT_EQ(file_of(run, "MY_PROT.TXT"), kExpected);
  }
  // An array of the user's definition file comes first, however long it is.
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  folder.write("UGUD.DEF", "%_N_UGUD_DEF\nDEF NCK STRING[200] S_USERTXT[30]\nM17\n");
  options.programs = {
      folder.write("part.mpf",
                   "DEF INT NN\nCYCLE150(10,11,\"MY.TXT\")\nS_LOGTXT[0]=\"NO\"\nFOR NN=0 TO 24\n"
                   "S_USERTXT[NN]=\"LINE \"<<NN\nENDFOR\nCYCLE160\nM30\n")};
  options.control = "sinumerik-828d";
  const MeasuringRun own{testing::run_program(options)};
  std::string lines;
  for (int i = 0; i < 25; ++i) {
    lines += fmt::format("LINE {}\n", i);
  }
  ASSERT_EQ(own.output.exit_code, 0) << own.output.errors;
  EXPECT_EQ(file_of(own, "MY.TXT"), lines);
}

TEST(MeasuringLog, RowsInTheColumnsOfTheStandardLog) {
  const MeasuringRun run = measured(
      "R11=12.5 R12=12.4988 R13=-0.0012\nCYCLE150 "
      "(31,11,\"MEAS_PROTOCOL.TXT\")\nS_PROTTEXT[0]=REP(\"\",10)\n"
      "S_PROTTEXT[0]=\"SPRINT(_PROTVAL[35],'''Axis''','''Setpoint''','''Measurd''','''Difference'''"
      ",'''Unit''')\"\n"
      "S_PROTTEXT[1]=\"SPRINT(_PROTVAL[36],'''Z''',R11,R12,R13,S_TXT[3])\"\n"
      "S_PROTTEXT[2]=SPRINT(\"X %10.3F\",R11)\nCYCLE160",
      ring_aside());
  const std::string rows =
      "Axis            Setpoint         Measurd          Difference       Unit\n"
      "Z               12.5000          12.4988          -0.0012 mm\n"
      "X     12.500\n";
  EXPECT_EQ(file_of(run, "MEAS_PROTOCOL.TXT"), rows);
  EXPECT_EQ(run.output.document.at("output"), rows + "Please acknowledge with NC-Start\n");
}

TEST(MeasuringLog, NewDeletesAppendGoesOnAndTheLastMeasurementCanBeWrittenLater) {
  const std::string measure = "Z-5\nCYCLE977(101,10001,,1,40.01,,,2,5)\n";
  // Off while measuring; the last measurement afterwards, new.
  MeasuringRun run = measured(measure + "CYCLE150(30,2,\"LOG.TXT\")", ring_aside());
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) + kHole);
  run = measured("CYCLE150(0,1,\"LOG.TXT\")\nCYCLE150(0,1,\"LOG.TXT\")\n" + measure, ring_aside());
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) + kHole);
  run =
      measured("CYCLE150(0,1,\"LOG.TXT\")\nCYCLE150(0,1001,\"LOG.TXT\")\n" + measure, ring_aside());
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) + kHead + kHole);
  run = measured("CYCLE150(0,1,\"LOG.TXT\")\nCYCLE150(0,0,\"\")\n" + measure, ring_aside());
  EXPECT_EQ(file_of(run, "LOG.TXT"), kHead);
}

// As the two printed examples have it: the digit of the user's log beside that of the last
// measurement (manual, 3.16.3.3 and 3.16.3.6).
TEST(MeasuringLog, TheLastMeasurementOfTheUsersLogIsWhatItsLinesStillSay) {
  const MeasuringRun run = measured(
      "Z-5\nCYCLE977(101,10001,,1,40.01,,,2,5)\nS_LOGTXT[0]=\"USER LINE\"\n"
      "CYCLE150(30,11012,\"//NC/MPF.DIR/LAST_MEASURE.TXT\")\n"
      "CYCLE150(31,12,\"MEAS_PROTOCOL_LAST.TXT\")",
      ring_aside());
  EXPECT_EQ(file_of(run, "LAST_MEASURE.TXT"), "USER LINE\n");
  EXPECT_EQ(file_of(run, "MEAS_PROTOCOL_LAST.TXT"), "USER LINE\n");
  EXPECT_EQ(run.output.document.at("output"), "USER LINE\nPlease acknowledge with NC-Start\n");
}

TEST(MeasuringScreen, ShowsWaitsOrStaysAway) {
  struct Mode {
    const char* name;
    const char* switches;
    bool shows;
    std::size_t stops;
  };
  const Mode kRows[] = {{"off", "CYCLE150(30,0,\"\")", false, 0},
                        {"until NC start", "CYCLE150(31,0,\"\")", true, 1},
                        {"for 8 seconds", "CYCLE150(11,0,\"\")", true, 0},
                        {"on alarms only", "CYCLE150(41,0,\"\")", false, 0},
                        {"by setting data", "$SCS_MEA_RESULT_DISPLAY=3", true, 1}};
  const std::string screen = R"(Results measure:1 Hole / CYCLE977

Correction into:Measuring only

Results:        Setpoint         Measured         Difference
X                0.0000           0.2000           0.2000 mm
Y                0.0000          -0.3000          -0.3000 mm
Diameter        40.0100          40.0000          -0.0100 mm
                ---------------------------------
)";
  for (const Mode& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        measured(std::string(row.switches) + "\nZ-5\nCYCLE977(1,,,1,40.01,,,2,5)", ring_aside());
    const std::string wait = row.stops > 0 ? "Please acknowledge with NC-Start\n" : "";
    EXPECT_EQ(run.output.document.at("output"), row.shows ? screen + wait : "");
    EXPECT_EQ(run.output.document.at("stops").size(), row.stops);
  }
  const MeasuringRun oversize = run_measuring(
      "CYCLE150(41,0,\"\")\nZ-5\nCYCLE977(201,,0,1,39.9,,,2,5,,,,,,,\"MILL\",,0,1,0.05,-0.05,0.5,1,"
      "0,,,1)",
      {ring_aside(), kCalibrated}, {"R1"});
  const std::string shown = oversize.output.document.at("output");
  // The alarm is shown, at the line that calls the cycle, and the program goes on.
  EXPECT_EQ(oversize.output.exit_code, 1);
  const auto& alarm = oversize.output.document.at("diagnostics").back();
  EXPECT_EQ(alarm.at("code"), "PRB327");
  EXPECT_NE(alarm.at("message").get<std::string>().find("61304 oversize"), std::string::npos);
  EXPECT_EQ(alarm.at("column"), 1);
  EXPECT_EQ(alarm.at("file"), oversize.output.document.at("program"));
  EXPECT_NE(shown.find("Diameter        39.9000          40.0000           0.1000 mm\n"),
            std::string::npos)
      << shown;
}

TEST(MeasuringLog, APlaneHasBothItsAngles) {
  const MeasuringRun run =
      measured("CYCLE150(0,1,\"LOG.TXT\")\nX-15 Y-10 Z4\nCYCLE998(6,,,1,,1,,6,5,,,,30,0,0,20)",
               part("block", 100.0, 50.0, -300.0, "rotate_deg = [2.0, -3.0, 0.0]"));
  EXPECT_EQ(file_of(run, "LOG.TXT"), std::string(kHead) + R"(
-----------------------------------------------------
1                      : 998 / 6          Time:hh:mm:ss
Results measure:Align plane / CYCLE998

-----------------------------------------------------
Correction into:Measuring only

Results:        Setpoint         Measured         Difference
Angle about X    1.0000           2.0000           1.0000 deg
Angle about Y    0.0000          -3.0000          -3.0000 deg
                ---------------------------------
)");
}

}  // namespace
}  // namespace g31::testing::measuring_log_test
