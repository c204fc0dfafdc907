#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tools/cli/study_command.h"

namespace g31::testing {

inline std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

/// What `g31 study` left.
struct StudyOutput {
  int exit_code = -1;
  std::string out;
  std::string errors;
};

/// Runs the command in this process.
inline StudyOutput run_study(const cli::StudyOptions& options) {
  StudyOutput output;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  output.exit_code = static_cast<int>(cli::study_command(options));
  output.errors = ::testing::internal::GetCapturedStderr();
  output.out = ::testing::internal::GetCapturedStdout();
  return output;
}

/// Runs it with the document on standard output.
inline StudyOutput study_document(cli::StudyOptions options) {
  options.json = "-";
  return run_study(options);
}

}  // namespace g31::testing
