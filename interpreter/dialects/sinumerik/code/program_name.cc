#include "interpreter/dialects/sinumerik/code/program_name.h"

#include <algorithm>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kProgramSuffixes[] = {"MPF", "SPF", "CYC", "DEF", "ARC", "CST", "CPF"};
constexpr std::string_view kDataSuffix = "INI";
constexpr std::string_view kDigits = "0123456789";

bool is_suffix(std::string_view text) {
  return std::ranges::find(kProgramSuffixes, text) != std::end(kProgramSuffixes);
}

/// SGUD, MGUD, UGUD, GUD4 to GUD9, SMAC, MMAC, UMAC (Programming Guide Advanced, reserved block
/// names), and their like of builders.
bool is_kept_for_definitions(std::string_view stem) {
  const std::string_view name = stem.substr(0, stem.find_last_not_of(kDigits) + 1);
  return name.ends_with("GUD") || name.ends_with("MAC");
}

/// DEF, DEFINE or REDEF, perhaps behind a block number.
bool begins_with_definition(std::string_view line) {
  const auto skip = [&line](std::string_view characters) {
    line.remove_prefix(std::min(line.find_first_not_of(characters), line.size()));
  };
  skip(" \t");
  const std::string block_number = upper(line.substr(0, 2));
  if (block_number.size() == 2 && block_number[0] == 'N' &&
      kDigits.find(block_number[1]) != std::string_view::npos) {
    line.remove_prefix(1);
    skip(kDigits);
    skip(" \t");
  }
  const std::string word = upper(line.substr(0, line.find_first_of(" \t")));
  return word == "DEF" || word == "DEFINE" || word == "REDEF";
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

bool holds_definitions(const ProgramName& name, std::string_view text) {
  if (!is_definition(name) || is_kept_for_definitions(name.stem)) {
    return is_definition(name);
  }
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (begins_with_definition(text.substr(0, end))) {
      return true;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

bool is_callable(const ProgramName& name) {
  return !is_definition(name) && !is_data(name);
}

}  // namespace g31::sinumerik
