// What DPRNT and BPRNT send reaches standard output byte for byte.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31 {
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

}  // namespace
}  // namespace g31
