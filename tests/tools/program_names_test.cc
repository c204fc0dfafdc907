// Programs of a Fanuc that have names: in which files they are found, and how a run and a check
// show them.

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/code/program_windows.h"
#include "tests/support/captured.h"
#include "tests/support/run_program.h"

namespace g31::program_names_test {
namespace {

using testing::TemporaryFolder;

/// Runs a file of a folder on a 30i; programs are looked for there.
testing::RunOutput run_file(const std::string& file) {
  cli::RunOptions options;
  options.programs = {file};
  options.control = "fanuc-30i";
  options.prints = {"#100,#101"};
  return testing::run_program(options);
}

TEST(ProgramNames, AreFoundByWhatAFileSaysAndByWhatItIsCalled) {
  const TemporaryFolder folder;
  folder.write("first.txt", "<INSIDE>\n#100=1\nM99\n");
  folder.write("outside.nc", "#101=2\nM99\n");
  folder.write("INSIDE.NC", "#100=9\nM99\n");
  const auto run = run_file(folder.write("main.nc", "O1\nM98 <INSIDE>\nM98 <outside>\nM30\n"));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document["variables"]["#100"], 1.0);
  EXPECT_EQ(run.document["variables"]["#101"], 2.0);
}

TEST(ProgramNames, ShowInTheCallsOfAnAlarm) {
  const TemporaryFolder folder;
  folder.write("outside.nc", "G65 <INNER>\nM99\n<INNER>\n#100=1/0\nM99\n");
  const auto run = run_file(folder.write("main.nc", "<MAIN>\nM98 <outside>\nM30\n"));
  EXPECT_EQ(run.document["alarm"]["number"], 112);
  const auto& calls = run.document["alarm"]["calls"];
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[0]["program"], "<outside>");
  EXPECT_EQ(calls[1]["program"], "<MAIN>");
  EXPECT_EQ(run.document["alarm"]["line"], 4);
  EXPECT_NE(run.errors.find("called from <outside>"), std::string::npos) << run.errors;
}

TEST(ProgramNames, OfALongMainFileAreFoundWithoutTheRestOfIt) {
  const TemporaryFolder folder;
  std::string text = "<MAIN>\n";
  for (int n = 0; text.size() < fanuc::kWholeFileBytes + 2 * fanuc::kWindowBytes; ++n) {
    text += fmt::format("G1 X{}.5 Y0.5 F1000.\n", n % 1000);
  }
  text += "M98 <BEHIND>\nM98 <other>\nM30\n<BEHIND>\n#100=1\nM99\n<O12>\nM99\n";
  folder.write("other.nc", "#101=2\nM99\n");
  const auto run = run_file(folder.write("main.nc", text));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document["variables"]["#100"], 1.0);
  EXPECT_EQ(run.document["variables"]["#101"], 2.0);
}

TEST(ProgramNames, TwiceInAFileAreTold) {
  const TemporaryFolder folder;
  const auto run =
      run_file(folder.write("main.nc", "O1\nM98 <A>\nM30\n<A>\n#100=1\nM99\n<A>\n#100=2\nM99\n"));
  EXPECT_EQ(run.document["variables"]["#100"], 1.0);
  EXPECT_NE(run.errors.find("<A> appears twice: this one is used, not that of line 7"),
            std::string::npos)
      << run.errors;
}

TEST(ProgramNames, ThatAreNotThereAreFoundByACheck) {
  const TemporaryFolder folder;
  folder.write("outside.nc", "#101=2\nM99\n");
  const std::string file = folder.write(
      "main.nc", "O1\nM98 <outside>\nG65 <A>\nG66 <B>\nG67\nM98 <O22>\nM30\n<A>\nM99\n");
  const auto on_30i = testing::g31({"check", "--control", "fanuc-30i", file});
  EXPECT_EQ(on_30i.exit_code, 1);
  EXPECT_NE(on_30i.out.find("4:5: error: alarm 310, FILE NOT FOUND: <B> is in none"),
            std::string::npos)
      << on_30i.out;
  EXPECT_NE(on_30i.out.find("6:5: error: alarm 76, NUMBER NOT FOUND: O0022 is in none"),
            std::string::npos)
      << on_30i.out;
  EXPECT_EQ(on_30i.out.find("<A>"), std::string::npos) << on_30i.out;
  EXPECT_EQ(on_30i.out.find("<outside>"), std::string::npos) << on_30i.out;
  const auto on_16i = testing::g31({"check", "--control", "fanuc-16i", file});
  EXPECT_NE(on_16i.out.find("2:5: error: alarm 9, ILLEGAL ADDRESS INPUT: a call by name"),
            std::string::npos)
      << on_16i.out;
  EXPECT_NE(on_16i.out.find("30i and 0i-F have names: M98 P1234"), std::string::npos) << on_16i.out;
}

TEST(ProgramNames, ThatCallsMissByCaseEndTheRun) {
  const TemporaryFolder folder;
  folder.write("Bore.nc", "M99\n");
  const auto run = run_file(folder.write("main.nc", "O1\nM98 <BORE>\nM30\n"));
  EXPECT_EQ(run.document["alarm"]["number"], 310);
}

}  // namespace
}  // namespace g31::program_names_test
