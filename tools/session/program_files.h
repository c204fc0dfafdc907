#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"

namespace g31::session {

/// The folder in which a program reads and writes its files (READ, WRITE, EXTWRITE); by name, all
/// side by side.  Without a folder they live as long as the run.
class ProgramFiles {
 public:
  using Contents = std::map<std::string, std::string>;
  using Changes = std::map<std::string, std::string_view>;

  /// What lies in the folder; folders in it, hidden files and files of more than 16 MiB are none of
  /// the program's.  @param folder  "": none.  @returns why it cannot be read
  static Result<ProgramFiles, std::string> open(const std::string& folder);

  [[nodiscard]] const Contents& at_start() const { return at_start_; }
  /// What the program made or changed: texts of `now`.
  [[nodiscard]] Changes changed(const Contents& now) const;
  /// What save() writes or removes; none without a folder.
  [[nodiscard]] std::vector<std::string> paths(const Contents& now) const;
  /// Writes what has changed and removes what the program deleted, in the folder.
  /// @returns why it could not be done
  [[nodiscard]] std::optional<std::string> save(const Contents& now) const;

 private:
  [[nodiscard]] std::vector<std::string> deleted(const Contents& now) const;

  std::string folder_;
  Contents at_start_;
};

}  // namespace g31::session
