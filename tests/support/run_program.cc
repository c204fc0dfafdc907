#include "tests/support/run_program.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <unistd.h>

template class nlohmann::basic_json<>;

namespace g31::testing {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "g31_test_XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  const std::string path = (path_ / name).string();
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string TemporaryFolder::path(const std::string& name) const {
  return (path_ / name).string();
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    found.push_back(entry.path().filename().string());
  }
  return found;
}

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

RunOutput run_program(cli::RunOptions options) {
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
