#include "tests/support/run_study.h"

#include <fstream>

#include <gtest/gtest.h>

namespace g31::testing {

std::string text_of_file(const std::string& path) {
  EXPECT_TRUE(std::ifstream(path, std::ios::binary)) << path;
  return text_of(path);
}

StudyOutput run_study(const cli::StudyOptions& options) {
  return captured([&] { return cli::study_command(options); });
}

StudyOutput study_document(cli::StudyOptions options) {
  options.json = "-";
  return run_study(options);
}

}  // namespace g31::testing
