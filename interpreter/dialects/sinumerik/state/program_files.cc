#include "interpreter/dialects/sinumerik/state/program_files.h"

#include "interpreter/dialects/sinumerik/code/program_name.h"

namespace g31::sinumerik {

ProgramFiles::ProgramFiles(const ByName& files) {
  for (const auto& [name, text] : files) {
    content(name) = text;
  }
}

std::string ProgramFiles::kept_name(const std::string& name) const {
  if (contains(name)) {
    return name;
  }
  const auto found = kept_names_.find(file_name_on_control(name));
  return found != kept_names_.end() ? found->second : name;
}

const std::string* ProgramFiles::find(const std::string& name) const {
  const auto found = files_.find(name);
  return found != files_.end() ? &found->second : nullptr;
}

std::string& ProgramFiles::content(const std::string& name) {
  const auto [file, is_new] = files_.try_emplace(name);
  if (is_new) {
    ++changes_;
    kept_names_.emplace(file_name_on_control(name), name);
  }
  return file->second;
}

void ProgramFiles::remove(const std::string& name) {
  changes_ += files_.erase(name);
  const auto [first, last] = kept_names_.equal_range(file_name_on_control(name));
  for (auto kept = first; kept != last; ++kept) {
    if (kept->second == name) {
      kept_names_.erase(kept);
      return;
    }
  }
}

}  // namespace g31::sinumerik
