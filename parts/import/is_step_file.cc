#include <algorithm>

#include "machine/base/letters.h"
#include "parts/import/step_file.h"

namespace g31::parts {

bool is_step_file(std::string_view path) {
  const std::string ending = in_small_letters(path.substr(std::min(path.size(), path.rfind('.'))));
  return ending == ".step" || ending == ".stp";
}

}  // namespace g31::parts
