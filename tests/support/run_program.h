#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/run_command.h"

// One place compiles what a document is made of and read by.
extern template class nlohmann::basic_json<>;

namespace g31::testing {

/// A folder of its own for one test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  /// Writes a file into the folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string path(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// The content of a file; empty where there is none.
std::string text_of(const std::string& path);

/// What `g31 run` left: exit code, document (null when none was written) and standard error.
struct RunOutput {
  int exit_code = -1;
  nlohmann::json document;
  std::string errors;
};

/// Runs the command in this process; the document goes through a file in a folder of its own.
RunOutput run_program(cli::RunOptions options);

}  // namespace g31::testing
