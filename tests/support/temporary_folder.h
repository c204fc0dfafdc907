#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace g31::testing {

/// A folder of its own for one test or one fuzzer, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  /// Writes a file into the folder and returns its path.
  std::string write(const std::string& name, std::string_view text) const;
  [[nodiscard]] std::string path(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// The lines of a text that begin with a place in the folder, without the folder.
std::vector<std::string> places(const std::string& text, const TemporaryFolder& folder);

}  // namespace g31::testing
