#include "tests/support/run_study.h"

#include <fstream>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

namespace g31::testing {

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

StudyOutput run_study(const cli::StudyOptions& options) {
  StudyOutput output;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  output.exit_code = static_cast<int>(cli::study_command(options));
  output.errors = ::testing::internal::GetCapturedStderr();
  output.out = ::testing::internal::GetCapturedStdout();
  return output;
}

StudyOutput study_document(cli::StudyOptions options) {
  options.json = "-";
  return run_study(options);
}

}  // namespace g31::testing
