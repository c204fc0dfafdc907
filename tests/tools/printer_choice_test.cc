// --printer: where printouts go, and what is said when they cannot.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/captured.h"
#include "tests/support/played_printer.h"
#include "tests/support/run_program.h"

namespace g31::printer_choice_test {
namespace {

using testing::PlayedPrinter;
using testing::TemporaryFolder;

testing::CommandOutput run(const cli::RunOptions& options) {
  return testing::captured([&] { return cli::run_command(options); });
}

class PrinterChoice : public ::testing::Test {
 protected:
  cli::RunOptions options(const std::string& printer) const {
    cli::RunOptions options;
    options.programs = {program_};
    options.printer = printer;
    return options;
  }

  TemporaryFolder folder_;
  std::string program_ =
      folder_.write("main.nc", "%\nO1\n#1=12.5\nPOPEN\nDPRNT[X#1[33]]\nPCLOS\nM30\n%\n");
  const std::string text_ = "X  12.500\n";
};

TEST_F(PrinterChoice, IsStandardOutputOrAFile) {
  for (const char* printer : {"", "-"}) {
    const testing::CommandOutput streams = run(options(printer));
    EXPECT_EQ(streams.exit_code, 0) << streams.errors;
    EXPECT_EQ(streams.out, text_);
  }
  const std::string path = folder_.write("out.txt", "what was there before, and longer");
  const testing::CommandOutput streams = run(options(path));
  EXPECT_EQ(streams.exit_code, 0) << streams.errors;
  EXPECT_EQ(streams.out, "");
  std::ifstream file(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), text_);
}

TEST_F(PrinterChoice, LeavesStandardOutputToTheDocument) {
  cli::RunOptions both = options(folder_.path("out.txt"));
  both.json = "-";
  const testing::CommandOutput streams = run(both);
  EXPECT_EQ(streams.exit_code, 0) << streams.errors;
  EXPECT_EQ(nlohmann::json::parse(streams.out).at("output"), text_);
  both.printer = "-";
  const testing::CommandOutput refused = run(both);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.errors, "g31: error: --json and --printer cannot both be standard output\n");
  both.printer = "";
  const testing::CommandOutput quiet = run(both);
  EXPECT_EQ(nlohmann::json::parse(quiet.out).at("output"), text_);
}

TEST_F(PrinterChoice, IsRefusedBeforeAnythingRuns) {
  const std::string pipe = folder_.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string ordinary = folder_.write("file", "");
  const PlayedPrinter terminal;
  const std::pair<std::string, std::string> kCases[] = {
      {folder_.path("none/out.txt"), "cannot write: No such file or directory"},
      {folder_.path(""), "cannot write: Is a directory"},
      {pipe, "cannot write: nobody has read this pipe for 3 s"},
      {terminal.device(), "a serial line needs its settings: " + terminal.device() + ",4800,e,7,2"},
      {terminal.device() + ",4800,q,7,2", "parity \"q\": e (even), o (odd) or n (none)"},
      {terminal.device() + ",4700,e,7,2", "baud rate \"4700\": one of"},
      {terminal.device() + ",4800", "2 parts instead of 5"},
      {"/dev/no_such_line,4800,e,7,2", "cannot open /dev/no_such_line: No such file or directory"},
      {"/dev/null,4800,e,7,2", "/dev/null is not a serial line"},
      {ordinary + ",4800,e,7,2", ordinary + " is not a serial line"},
  };
  for (const auto& [printer, says] : kCases) {
    const testing::CommandOutput streams = run(options(printer));
    EXPECT_EQ(streams.exit_code, 2) << printer;
    EXPECT_EQ(streams.errors.rfind("g31: error: --printer " + printer + ": ", 0), 0U)
        << streams.errors;
    EXPECT_NE(streams.errors.find(says), std::string::npos) << streams.errors;
    EXPECT_EQ(streams.out, "");
  }
}

TEST_F(PrinterChoice, ALineOfSevenBitsCannotCarryNumbersOfBprnt) {
  PlayedPrinter printer;
  printer.start();
  cli::RunOptions narrow = options(printer.device() + ",19200,n,7,2");
  narrow.programs = {folder_.write("main.nc", "O1\n#1=1\nPOPEN\nBPRNT[X#1[3]]\nM30\n")};
  const testing::CommandOutput streams = run(narrow);
  EXPECT_EQ(streams.exit_code, 3);
  EXPECT_NE(streams.errors.find("main.nc:4:1: error: "), std::string::npos) << streams.errors;
  EXPECT_NE(streams.errors.find("BPRNT need 8 data bits"), std::string::npos) << streams.errors;
}

TEST_F(PrinterChoice, AFullDiskIsNoSuccess) {
  const testing::CommandOutput streams = run(options("/dev/full"));
  EXPECT_EQ(streams.exit_code, 2);
  EXPECT_EQ(streams.errors,
            "g31: error: --printer /dev/full: cannot write: No space left on device\n");
}

}  // namespace
}  // namespace g31::printer_choice_test
