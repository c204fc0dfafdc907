#include "tools/session/shipped_macros.h"

#include <algorithm>
#include <sstream>

#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"

namespace g31::session {

MacroText text_of_macro(const std::string& text) {
  MacroText macro;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t open = line.find('(');
    const std::size_t close = line.rfind(')');
    const bool is_comment = open != std::string::npos && close != std::string::npos && open < close;
    const std::string comment = is_comment ? line.substr(open + 1, close - open - 1) : "";
    if (macro.name.empty() && line.starts_with('O')) {
      macro.name = line.substr(0, line.find_first_of(" ("));
      macro.title = comment;
    } else if (!macro.name.empty() && is_comment && open == 0) {
      macro.lines.push_back(comment);
    } else if (!macro.name.empty()) {
      break;
    }
  }
  return macro;
}

std::vector<MacroText> shipped_macros() {
  std::vector<MacroText> all;
  const auto folder = disk::shipped_folder("macros/fanuc");
  if (!folder) {
    return all;
  }
  disk::Disk disk;
  for (const std::string& name : disk.list(*folder)) {
    if (const auto text = disk.read(*folder + "/" + name); text && name.ends_with(".nc")) {
      all.push_back(text_of_macro(*text));
    }
  }
  std::ranges::sort(all, {}, &MacroText::name);
  return all;
}

}  // namespace g31::session
