#include "tests/support/captured.h"

#include <gtest/gtest.h>

#include "tests/support/kept_documents.h"
#include "tools/cli/command_line.h"

namespace g31::testing {

CommandOutput captured(const std::function<cli::ExitCode()>& command) {
  CommandOutput output;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  output.exit_code = static_cast<int>(command());
  output.errors = ::testing::internal::GetCapturedStderr();
  output.out = ::testing::internal::GetCapturedStdout();
  keep_document(output.out);
  return output;
}

CommandOutput g31(const std::vector<std::string>& words, const std::string& version) {
  std::vector<const char*> arguments = {"g31"};
  for (const std::string& word : words) {
    arguments.push_back(word.c_str());
  }
  return captured([&] {
    return cli::run_command_line(static_cast<int>(arguments.size()), arguments.data(), version);
  });
}

}  // namespace g31::testing
