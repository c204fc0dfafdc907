#include <algorithm>
#include <cctype>

#include "parts/import/step_file.h"

namespace g31::parts {

bool is_step_file(std::string_view path) {
  std::string ending(path.substr(std::min(path.size(), path.rfind('.'))));
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".step" || ending == ".stp";
}

}  // namespace g31::parts
