#include "tools/page/file_names.h"

#include <filesystem>

#include <fmt/format.h>

namespace g31::page {

FileNames::FileNames(const std::vector<std::string>& paths) {
  std::map<std::string, int> known;
  for (const std::string& path : paths) {
    const std::string name = without_folder(path);
    const int number = ++known[name];
    names_.emplace(path, number == 1 ? name : fmt::format("{}~{}", name, number));
    has_namesakes_ = has_namesakes_ || number > 1;
  }
}

std::string FileNames::of(const std::string& path) const {
  const auto found = names_.find(path);
  return found != names_.end() ? found->second : without_folder(path);
}

Place FileNames::at(const source::ShownPlace& place) const {
  return {of(place.file), place.line};
}

std::string without_folder(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace g31::page
