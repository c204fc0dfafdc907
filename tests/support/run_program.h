#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tools/cli/run_command.h"

namespace g31::testing {

/// A folder of its own for one test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "g31_test_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  /// Writes a file into the folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (path_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  }

 private:
  std::filesystem::path path_;
};

/// The content of a file; empty where there is none.
inline std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What `g31 run` left: exit code, document (null when none was written) and standard error.
struct RunOutput {
  int exit_code = -1;
  nlohmann::json document;
  std::string errors;
};

/// Runs the command in this process; the document goes through a file in a folder of its own.
inline RunOutput run_program(cli::RunOptions options) {
  TemporaryFolder folder;
  options.json = folder.path("result.json");
  RunOutput output;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  output.exit_code = static_cast<int>(cli::run_command(options));
  output.errors = ::testing::internal::GetCapturedStderr();
  ::testing::internal::GetCapturedStdout();
  std::ifstream in(options.json, std::ios::binary);
  if (in) {
    output.document = nlohmann::json::parse(in);
  }
  return output;
}

}  // namespace g31::testing
