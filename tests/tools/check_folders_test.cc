// `g31 check FOLDER`: where the programs of a tree find what they call.

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"

namespace g31::check_folders_test {
namespace {

using testing::TemporaryFolder;

class CheckedTree : public ::testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    std::filesystem::create_directories(std::filesystem::path(folder_.path(file)).parent_path());
    folder_.write(file, text);
  }
  [[nodiscard]] testing::CommandOutput check(std::vector<std::string> words) const {
    for (std::string& word : words) {
      word = word.starts_with('-') ? word : folder_.path(word);
    }
    words.insert(words.begin(), "check");
    return testing::g31(words);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(CheckedTree, ProgramsCallThoseOfTheOtherFolders) {
  write("shop/main/bore.nc", "O1\nG65 P9100 D40.\nM30\n");
  write("shop/macros/probe/O9100.nc", "O9100\n#1=#7\nM99\n");
  write("shop/macros/kept", "%\nO9200\nM98 P1\nM99\n%\n");
  const auto whole = check({"shop"});
  EXPECT_EQ(whole.exit_code, 0) << whole.out << whole.errors;
  EXPECT_EQ(whole.out, "");
  const auto alone = check({"shop/main"});
  EXPECT_EQ(alone.exit_code, 1) << "nobody has named the folder of the macros";
  EXPECT_NE(alone.out.find("[NC005]"), std::string::npos) << alone.out;
  EXPECT_EQ(check({"shop/main", "shop/macros"}).exit_code, 1) << "two trees, two machines";
  EXPECT_EQ(check({"shop/main", "shop/macros/probe/O9100.nc"}).exit_code, 0);
}

// Files are read once for all folders; what one of them may call and how it is read is not kept.
TEST_F(CheckedTree, WhatAFolderHoldsSaysNothingOfTheNextOne) {
  write("a/modal.nc", "O1\nG66.1 P9000\nG67\nM30\nO9000\nM99\n");
  write("b/plain.nc", "O2\nT-5\nM98 P9000\nM30\n");
  for (const std::vector<std::string>& named :
       {std::vector<std::string>{"a", "b"}, std::vector<std::string>{"b", "a"}}) {
    const auto output = check(named);
    EXPECT_NE(output.out.find("plain.nc:2:1: error: alarm 6"), std::string::npos) << output.out;
    EXPECT_NE(output.out.find("[NC005]"), std::string::npos) << output.out;
    EXPECT_EQ(output.out.find("modal.nc"), std::string::npos) << output.out;
  }
  // Named themselves they are of one machine.
  EXPECT_EQ(check({"a/modal.nc", "b/plain.nc"}).out, "");
}

TEST_F(CheckedTree, TheNearestProgramIsTheOneThatIsMeant) {
  for (const std::string machine : {"a", "b"}) {
    write(machine + "/MPF.DIR/M.MPF", "UP1(1)\nM30\n");
  }
  write("a/SPF.DIR/UP1.SPF", "PROC UP1(REAL X)\nM17\n");
  write("b/SPF.DIR/UP1.SPF", "PROC UP1\nM17\n");
  const auto output = check({""});
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.out.find("b/MPF.DIR/M.MPF:1:"), std::string::npos) << output.out;
  EXPECT_EQ(output.out.find("a/MPF.DIR/M.MPF:1:"), std::string::npos) << output.out;
}

TEST_F(CheckedTree, LibrariesAreTheFoldersBelowThem) {
  write("main/bore.nc", "O1\nM98 P9100\nM30\n");
  write("lib/macros/deep/O9100.nc", "O9100\nM99\n");
  EXPECT_EQ(check({"main/bore.nc"}).exit_code, 1);
  EXPECT_EQ(check({"main/bore.nc", "--lib", "lib"}).exit_code, 0);
  const auto output = check({"main/bore.nc", "--lib", "nix"});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("no such folder"), std::string::npos) << output.errors;
}

TEST_F(CheckedTree, ASinumerikLooksIntoItsSubprogramsAndNotIntoOtherWorkpieces) {
  write("MPF.DIR/A.MPF", "UP1\nM30\n");
  write("SPF.DIR/UP1.SPF", "R1=1\nM17\n");
  EXPECT_EQ(check({""}).exit_code, 0);
  write("WKS.DIR/X.WPD/X.MPF", "UP1\nUP2\nM30\n");
  write("WKS.DIR/Y.WPD/UP2.SPF", "R1=1\nM17\n");
  const auto output = check({""});
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.out.find("X.MPF:2:1: error: alarm 12550"), std::string::npos) << output.out;
}

TEST_F(CheckedTree, ADefinitionFileIsToldByItsNameOrByWhatItDefines) {
  write("P.MPF", "R1=ROUND_OF+TURN_OF\nM30\n");
  // Of a post-processor and of a linker.
  write("POST.def", "MACHINE  mill\nFORMAT Coordinate \"&__5.3_\"\n");
  write("lib/exports.def", "LIBRARY probe\nEXPORTS\n  touch\n");
  write("WHEEL.DEF", "; of the wheel\nN10 def NCK REAL ROUND_OF=1\nM17\n");
  write("DEF.DIR/SHOP.DEF", "DEF NCK REAL TURN_OF=1\nM17\n");
  EXPECT_EQ(check({""}).out, "");
  EXPECT_EQ(check({"P.MPF", "--lib", "DEF.DIR", "--lib", "lib"}).out, "");
  write("lib/MGUD.DEF", "MACHINE mill\n");
  const auto output = check({"P.MPF", "--lib", "DEF.DIR", "--lib", "lib"});
  EXPECT_NE(output.out.find("MGUD.DEF:1:"), std::string::npos) << output.out;
  EXPECT_EQ(output.out.find("exports"), std::string::npos) << output.out;
}

TEST_F(CheckedTree, DefinitionsThatAreCutOffOrMisnamedAreToldAsSuch) {
  write("files/MGUD.DEF", "DEF \n");
  EXPECT_NE(
      check({"files/MGUD.DEF"}).out.find("in a definition file NCK or CHAN stands behind DEF"),
      std::string::npos);
  write("P.MPF", "DEF REAL D0_FAST, L1\nDEF NCK REAL SIZE\nL1=1\nM30\n");
  const auto output = check({"P.MPF"});
  EXPECT_NE(output.out.find("P.MPF:1:10: error: alarm 12080, syntax error in text: D0_FAST, a name "
                            "begins with two letters or underscores"),
            std::string::npos)
      << output.out;
  EXPECT_NE(output.out.find("NCK and CHAN are for definition files only"), std::string::npos);
}

}  // namespace
}  // namespace g31::check_folders_test
