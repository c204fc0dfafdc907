// What DPRNT and BPRNT send reaches standard output byte for byte; messages are text.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::output_bytes_test {
namespace {

TEST(OutputBytes, ReachStandardOutputAsTheyAre) {
  const testing::TemporaryFolder folder;
  // The figures of MB-248: 0.40596 and -1638.4 with three decimals.
  const std::string program =
      "%\nO1\n#1=.40596\n#2=-1638.4\nPOPEN\nBPRNT[A*#1[3]#2[3]]\nDPRNT[Z#2[51]]\nPCLOS\nM30\n%\n";
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", program)};
  options.control = "fanuc-16i";
  ::testing::internal::CaptureStdout();
  const auto code = cli::run_command(options);
  const std::string bytes = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(static_cast<int>(code), 0);
  EXPECT_EQ(bytes, std::string("A \x00\x00\x01\x96\xFF\xE7\x00\x00\nZ- 1638.4\n", 21));
}

TEST(OutputBytes, OfMessagesAreLettersForATerminal) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  // MSG in Latin-1, as old archives have it.
  options.programs = {
      folder.write("main.mpf", "DEF STRING[9] TT=\"\xDF\"\nMSG(\"Gr\xFC\"<<TT<<\"e\")\nM30\n")};
  options.control = "sinumerik-828d";
  options.prints = {"TT"};
  ::testing::internal::CaptureStdout();
  const auto code = cli::run_command(options);
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(static_cast<int>(code), 0);
  EXPECT_EQ(text,
            "Gr\xC3\xBC\xC3\x9F"
            "e\nTT = \xC3\x9F\n");
}

TEST(RunDocument, KeepsTheFirstStopsAndCountsTheOthers) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("main.mpf", "WHILE R1<10003\nR1=R1+1\nG0 X=R1/100 M0\nENDWHILE\nM30\n")};
  const testing::RunOutput many = testing::run_program(options);
  EXPECT_EQ(many.document.at("stops").size(), 10000U);
  EXPECT_EQ(many.document.at("stops_left_out"), 3);
  options.programs = {folder.write("main.mpf", "G0 X1 M0\nM30\n")};
  const testing::RunOutput few = testing::run_program(options);
  EXPECT_EQ(few.document.at("stops").size(), 1U);
  EXPECT_FALSE(few.document.contains("stops_left_out"));
}

}  // namespace
}  // namespace g31::output_bytes_test
