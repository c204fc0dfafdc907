#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace g31::sinumerik {

/// The files that a program reads and writes.  Each keeps the name that it has on the disk, or that
/// the program has made it with; the control finds it by any form of that name.
class ProgramFiles {
 public:
  using ByName = std::map<std::string, std::string>;

  ProgramFiles() = default;
  explicit ProgramFiles(const ByName& files);

  /// What they hold, by the names that they keep.
  [[nodiscard]] const ByName& all() const { return files_; }
  /// The name of the file that a name means: one of the very same letters comes first; the name
  /// itself where there is no such file.
  [[nodiscard]] std::string kept_name(const std::string& name) const;

  // By the name that a file keeps
  [[nodiscard]] bool contains(const std::string& name) const { return files_.contains(name); }
  /// nullptr: there is none.
  [[nodiscard]] const std::string* find(const std::string& name) const;
  /// What is in it; an empty one is made where there is none.
  std::string& content(const std::string& name);
  void remove(const std::string& name);

  /// How often a file was made or removed.
  [[nodiscard]] std::size_t changes() const { return changes_; }

  bool operator==(const ProgramFiles& other) const { return files_ == other.files_; }

 private:
  ByName files_;
  std::multimap<std::string, std::string> kept_names_;  ///< by the name on the control
  std::size_t changes_ = 0;
};

}  // namespace g31::sinumerik
