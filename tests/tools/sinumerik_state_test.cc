// What a SINUMERIK control keeps from run to run: variables, and the files of its programs.

#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::testing::sinumerik_state_test {
namespace {

namespace fs = std::filesystem;

RunOutput run(const TemporaryFolder& folder, const std::string& program, const std::string& sheet,
              const std::string& print = "R1-R9") {
  cli::RunOptions options;
  options.programs = {folder.write("case.mpf", program + "\nM30\n")};
  options.setups = {folder.write("sheet.toml", sheet)};
  options.prints = {print};
  return run_program(options);
}

constexpr const char* kKeeping = "[control]\nvariables_file = \"machine.vars\"\n";
constexpr const char* kFiles = "[control]\nfiles = \"logs\"\n";

TEST(SinumerikVariables, OutliveTheRunWhenTheyDifferFromPowerOn) {
  const TemporaryFolder folder;
  const RunOutput first = run(folder,
                              "DEF REAL LOCAL=9\nR5=1.5 R6=0.1EX-12\n_OVR[4]=24.017 "
                              "_OVI[2]=977\n$SNS_MEA_WP_BALL_DIAM[3]=5.9983\n"
                              "$MA_MAX_AX_ACCEL[Y]=3\n$SCS_MEA_FEED_MEASURE=300",
                              kKeeping);
  EXPECT_EQ(first.exit_code, 0);
  EXPECT_EQ(text_of(folder.path("machine.vars")),
            "$MA_MAX_AX_ACCEL[Y]=3\n$SNS_MEA_WP_BALL_DIAM[3]=5.9983\nR5=1.5\nR6=1e-13\n"
            "_OVI[2]=977\n_OVR[4]=24.017\n");
  const RunOutput next = run(folder,
                             "R1=R5 R2=R6*10EX12 R3=_OVR[4] R4=_OVI[2]\n"
                             "R7=$SNS_MEA_WP_BALL_DIAM[3] R8=$MA_MAX_AX_ACCEL[Y]",
                             kKeeping);
  EXPECT_EQ(next.document["variables"]["R1"], 1.5);
  EXPECT_NEAR(next.document["variables"]["R2"].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(next.document["variables"]["R3"], 24.017);
  EXPECT_EQ(next.document["variables"]["R4"], 977.0);
  EXPECT_EQ(next.document["variables"]["R7"], 5.9983);
  EXPECT_EQ(next.document["variables"]["R8"], 3.0);
}

TEST(SinumerikVariables, OfADefinitionFileCountFromItsInitialValues) {
  const TemporaryFolder folder;
  folder.write("MY.DEF", "%_N_MY_DEF\nDEF NCK REAL LIMIT=5\nDEF NCK INT TABLE[2,3]\nM17\n");
  run(folder, "LIMIT=0 TABLE[1,2]=7", kKeeping);
  EXPECT_EQ(text_of(folder.path("machine.vars")), "LIMIT=0\nTABLE[1,2]=7\n");
  const RunOutput next = run(folder, "R1=LIMIT R2=TABLE[1,2]", kKeeping);
  EXPECT_EQ(next.document["variables"]["R1"], 0.0);
  EXPECT_EQ(next.document["variables"]["R2"], 7.0);
}

TEST(SinumerikVariables, OfAProcThatNothingCalledAreNotThere) {
  const TemporaryFolder folder;
  const RunOutput called = run(folder, "PROC MAIN(VAR REAL VV)", "", "VV");
  EXPECT_NE(called.errors.find("[12300]"), std::string::npos) << called.errors;
  EXPECT_TRUE(called.document["variables"]["VV"].is_null());
  folder.write("MGUD.DEF", "DEF CHAN INT WRONG WRONG\nM17\n");
  const RunOutput not_begun = run(folder, "PROC MAIN(VAR REAL VV)", "", "VV");
  EXPECT_NE(not_begun.errors.find("[12080]"), std::string::npos) << not_begun.errors;
  EXPECT_TRUE(not_begun.document["variables"]["VV"].is_null());
}

TEST(SinumerikVariables, ThatTheSheetGivesHaveChangedFromThere) {
  const TemporaryFolder folder;
  folder.write("MY.DEF", "%_N_MY_DEF\nDEF NCK REAL LIMIT=5\nDEF NCK STRING[9] TITLE=\"A\"\nM17\n");
  cli::RunOptions options;
  options.setups = {folder.write("sheet.toml",
                                 "[gud]\nPALLET = 0.5\nRR = [0.25, 0.75]\nLEFT = 2\n"
                                 "[variables]\nR1 = 4\n"
                                 "[machine_data]\n\"$MA_OEM[X1]\" = 2.5\n")};
  options.changes = true;
  options.programs = {folder.write("case.mpf",
                                   "PALLET=0 RR[1]=7 R1=5 R2=6 LEFT=3 LEFT=2\n"
                                   "$MA_OEM[X1]=0\nLIMIT=0 TITLE=\"B\"\nM30\n")};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::map<std::string, nlohmann::json> was;
  for (const auto& change : output.document["changes"]) {
    was[change["name"]] = change["before"];
  }
  EXPECT_EQ(was, (std::map<std::string, nlohmann::json>{{"$MA_OEM[X]", 2.5},
                                                        {"LIMIT", 5.0},
                                                        {"PALLET", 0.5},
                                                        {"R1", 4.0},
                                                        {"R2", 0.0},
                                                        {"RR[1]", 0.75},
                                                        {"TITLE", "A"}}))
      << output.document["changes"];
}

TEST(SinumerikDefinitions, OfAUserCountBeforeThoseThatComeWithG31) {
  const TemporaryFolder folder;
  folder.write("MGUD.DEF",
               "DEF CHAN REAL _MA, _SETV[3]=(1,2,3)\nDEF CHAN INT _EV[20]\n"
               "DEF NCK STRING[20] S_TXT[4]\nM17\n");
  const RunOutput taken = run(folder,
                              "R1=_MA _SETV[0]=_SETV[0]+0.5 R2=_SETV[0] _EV[3]=4 R3=_EV[3]\n"
                              "R4=STRLEN(S_TXT[3]) R5=_NMSP _MV[2]=5 R6=_MV[2]",
                              "");
  EXPECT_EQ(taken.exit_code, 0) << taken.errors;
  EXPECT_EQ(taken.document["variables"]["R1"], 0.0) << "not 1, as g31's own file has it";
  EXPECT_EQ(taken.document["variables"]["R2"], 1.5);
  EXPECT_EQ(taken.document["variables"]["R3"], 4.0) << "no name for a datum of the cycles";
  EXPECT_EQ(taken.document["variables"]["R4"], 0.0) << "nor is there a value of theirs";
  EXPECT_EQ(taken.document["variables"]["R5"], 1.0);
  EXPECT_EQ(taken.document["variables"]["R6"], 5.0);
}

TEST(SinumerikDefinitions, ThatComeWithG31FillInWhatAFileOfTheirNameLacks) {
  const TemporaryFolder folder;
  folder.write("PGUD.DEF", "%_N_PGUD_DEF\nDEF CHAN REAL _OVI[20], OWN=3\nM17\n");
  const RunOutput filled =
      run(folder, "_OVI[0]=0.5 R1=_OVI[0] R2=OWN _OVR[4]=4 R3=_OVR[4] R4=_ROUGH", "");
  EXPECT_EQ(filled.exit_code, 0) << filled.errors;
  EXPECT_EQ(filled.document["variables"]["R1"], 0.5);
  EXPECT_EQ(filled.document["variables"]["R2"], 3.0);
  EXPECT_EQ(filled.document["variables"]["R3"], 4.0);
  EXPECT_EQ(filled.document["variables"]["R4"], 3.0);
}

TEST(SinumerikFiles, LieInTheFolderOfTheSheetWhateverPathTheProgramNames) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("logs"));
  folder.write("logs/OLD.TXT", "FIRST\n");
  folder.write("logs/GONE.TXT", "X\n");
  folder.write("logs/KEPT.TXT", "Y\n");
  const RunOutput output = run(folder,
                               "DEF INT ERR\nDEF STRING[20] LINE\n"
                               "READ(ERR,\"OLD.TXT\",1,1,LINE)\nR1=LINE==\"FIRST\"\n"
                               "WRITE(ERR,\"//NC/MPF.DIR/OLD.TXT\",\"SECOND\")\n"
                               "WRITE(ERR,\"/_N_WKS_DIR/_N_WP1_WPD/NEW.TXT\",\"HELLO\")\n"
                               "DELETE(ERR,\"GONE.TXT\")\nR2=ERR\n"
                               "WRITE(ERR,\"../OUT.TXT\",\"NO\")\nR3=ERR\n"
                               "WRITE(ERR,\"/\",\"NO\")\nR4=ERR",
                               kFiles);
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_EQ(output.document["variables"]["R1"], 1.0);
  EXPECT_EQ(output.document["variables"]["R2"], 0.0);
  EXPECT_EQ(output.document["variables"]["R3"], 1.0);
  EXPECT_EQ(output.document["variables"]["R4"], 1.0);
  EXPECT_EQ(text_of(folder.path("logs/OLD.TXT")), "FIRST\nSECOND\n");
  EXPECT_EQ(text_of(folder.path("logs/NEW.TXT")), "HELLO\n");
  EXPECT_EQ(text_of(folder.path("logs/KEPT.TXT")), "Y\n");
  EXPECT_FALSE(fs::exists(folder.path("logs/GONE.TXT")));
  EXPECT_FALSE(fs::exists(folder.path("OUT.TXT")));
  // The document tells what the program made, not what was there.
  EXPECT_EQ(output.document["files"].size(), 2U);
  EXPECT_EQ(output.document["files"]["NEW.TXT"], "HELLO\n");
}

TEST(SinumerikFiles, KeepTheNameOnTheDiskWhateverFormOfItAProgramWrites) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path("logs"));
  folder.write("logs/Old.mpf", "FIRST\n");
  folder.write("logs/TWIN", "A\n");
  folder.write("logs/TWIN.MPF", "B\n");
  const RunOutput written = run(folder,
                                "DEF INT ERR\nWRITE(ERR,\"_N_OLD_MPF\",\"SECOND\")\n"
                                "WRITE(ERR,\"_N_NEW_MPF\",\"ONE\")\nWRITE(ERR,\"NEW\",\"TWO\")\n"
                                "WRITE(ERR,\"TWIN.MPF\",\"C\")",
                                kFiles);
  EXPECT_EQ(written.exit_code, 0) << written.errors;
  EXPECT_EQ(text_of(folder.path("logs/Old.mpf")), "FIRST\nSECOND\n");
  EXPECT_EQ(text_of(folder.path("logs/_N_NEW_MPF")), "ONE\nTWO\n");
  EXPECT_EQ(text_of(folder.path("logs/TWIN")), "A\n");
  EXPECT_EQ(text_of(folder.path("logs/TWIN.MPF")), "B\nC\n");
  EXPECT_FALSE(fs::exists(folder.path("logs/NEW")));
}

TEST(SinumerikFiles, AreSavedAfterAnAlarmToo) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("logs"));
  const RunOutput output =
      run(folder, "DEF INT ERR\nWRITE(ERR,\"A.TXT\",\"LINE\")\nSETAL(65000)", kFiles);
  EXPECT_EQ(output.exit_code, 3);
  EXPECT_EQ(text_of(folder.path("logs/A.TXT")), "LINE\n");
}

TEST(SinumerikFiles, LinksInTheFolderLeadNowhere) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("logs"));
  const std::string outside = folder.write("secret.txt", "SECRET\n");
  fs::create_symlink(outside, folder.path("logs/LINK.TXT"));
  const RunOutput output = run(folder,
                               "DEF INT ERR\nDEF STRING[20] LINE\n"
                               "READ(ERR,\"LINK.TXT\",1,1,LINE)\nR1=ERR\n"
                               "WRITE(ERR,\"LINK.TXT\",\"OVERWRITTEN\")",
                               kFiles);
  EXPECT_EQ(output.document["variables"]["R1"], 3.0);
  EXPECT_EQ(text_of(outside), "SECRET\n");
  EXPECT_EQ(text_of(folder.path("logs/LINK.TXT")), "OVERWRITTEN\n");
}

TEST(SinumerikFiles, WithoutTheFolderNothingRuns) {
  const TemporaryFolder folder;
  const RunOutput output = run(folder, "R1=1", kFiles);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("sheet.toml:2:9: error: control.files is "), std::string::npos)
      << output.errors;
  EXPECT_NE(output.errors.find("logs, which cannot be read: No such file or directory [SET157]\n"
                               "    2 | files = \"logs\"\n"
                               "      |         ^\n"
                               "      = expected a folder that is there"),
            std::string::npos)
      << output.errors;
}

TEST(SinumerikDataFiles, OfTheCommandLineComeBeforeTheSheet) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("part.mpf", "R1=$P_UIFR[1,X,TR] R2=$P_UIFR[2,X,TR] R3=R9\nM30\n"),
      folder.write("UFR.INI", "$P_UIFR[1,X,TR]=5\n$P_UIFR[2,X,TR]=6\nR9=7\n")};
  options.setups = {folder.write("sheet.toml", "[work_offsets.G54]\nX = 100.0\n")};
  options.prints = {"R1-R3"};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.document["variables"]["R1"], 100.0);
  EXPECT_EQ(output.document["variables"]["R2"], 6.0);
  EXPECT_EQ(output.document["variables"]["R3"], 7.0);
}

}  // namespace
}  // namespace g31::testing::sinumerik_state_test
