#include "tests/support/captured.h"

#include <gtest/gtest.h>

namespace g31::testing {

CommandOutput captured(const std::function<cli::ExitCode()>& command) {
  CommandOutput output;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  output.exit_code = static_cast<int>(command());
  output.errors = ::testing::internal::GetCapturedStderr();
  output.out = ::testing::internal::GetCapturedStdout();
  return output;
}

}  // namespace g31::testing
