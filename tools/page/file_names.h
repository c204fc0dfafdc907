#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/source/source_map.h"
#include "tools/page/report.h"

namespace g31::page {

/// What a page calls the files of a run: without their folder, and of several that would be called
/// alike the second `FILE~2`, the third `FILE~3`.
class FileNames {
 public:
  FileNames() = default;
  /// @param paths  as they were opened, in the order of the page; none twice
  explicit FileNames(const std::vector<std::string>& paths);

  /// Of a file that is not among them the name without its folder.
  [[nodiscard]] std::string of(const std::string& path) const;
  [[nodiscard]] Place at(const source::ShownPlace& place) const;
  /// Whether two of them would be called alike.
  [[nodiscard]] bool has_namesakes() const { return has_namesakes_; }

 private:
  std::map<std::string, std::string> names_;
  bool has_namesakes_ = false;
};

/// A path without its folder.
std::string without_folder(const std::string& path);

}  // namespace g31::page
