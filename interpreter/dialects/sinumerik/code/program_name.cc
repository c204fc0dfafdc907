#include "interpreter/dialects/sinumerik/code/program_name.h"

#include <algorithm>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kProgramSuffixes[] = {"MPF", "SPF", "CYC", "DEF", "ARC", "CST", "CPF"};
constexpr std::string_view kDataSuffix = "INI";

bool is_suffix(std::string_view text) {
  return std::ranges::find(kProgramSuffixes, text) != std::end(kProgramSuffixes);
}

}  // namespace

std::string folder_name(std::string_view path) {
  while (path.ends_with('/') || path.ends_with(' ')) {
    path.remove_suffix(1);
  }
  const std::size_t slash = path.find_last_of("/\\");
  std::string name = upper(slash == std::string_view::npos ? path : path.substr(slash + 1));
  name.erase(0, name.starts_with("_N_") ? 3 : 0);
  std::ranges::replace(name, '.', '_');
  return name;
}

ProgramName program_name(std::string_view written) {
  const std::size_t slash = written.find_last_of("/\\");
  const std::string folder =
      slash == std::string_view::npos ? std::string() : folder_name(written.substr(0, slash));
  std::string name = upper(slash == std::string_view::npos ? written : written.substr(slash + 1));
  name.erase(0, name.find_first_not_of(" \t") == std::string::npos ? name.size()
                                                                   : name.find_first_not_of(" \t"));
  name.erase(name.find_last_not_of(" \t") + 1);
  if (name.starts_with("_N_")) {
    name.erase(0, 3);
  }
  const std::size_t mark = name.find_last_of("._");
  if (mark != std::string::npos && mark > 0 && is_suffix(name.substr(mark + 1))) {
    return {name.substr(0, mark), name.substr(mark + 1), folder};
  }
  return {name, "", folder};
}

ProgramName name_of_text(std::string_view written, std::string_view before_suffix) {
  ProgramName name = program_name(written);
  const std::string end = std::string(before_suffix) + std::string(kDataSuffix);
  if (name.suffix.empty() && name.stem.ends_with(end)) {
    name.suffix = kDataSuffix;
    name.stem.erase(name.stem.size() - end.size());
  }
  return name;
}

std::string file_name_on_control(std::string_view written) {
  constexpr std::size_t kType = 4;  // "_TXT"
  ProgramName name = program_name(written);
  const bool has_other_type =
      name.suffix.empty() && name.stem.size() > kType &&
      std::string_view("._").find(name.stem[name.stem.size() - kType]) != std::string_view::npos;
  if (has_other_type) {
    name.stem[name.stem.size() - kType] = '_';
    return name.stem;
  }
  return name.stem + "_" + (name.suffix.empty() ? "MPF" : name.suffix);
}

bool is_data(const ProgramName& name) {
  return name.suffix == kDataSuffix;
}

bool is_definition(const ProgramName& name) {
  return name.suffix == "DEF";
}

bool is_callable(const ProgramName& name) {
  return !is_definition(name) && !is_data(name);
}

}  // namespace g31::sinumerik
