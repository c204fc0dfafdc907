#include "interpreter/dialects/sinumerik/code/element_name.h"

#include <fmt/format.h>

namespace g31::sinumerik {

std::string element_name(const Variable& variable, std::int32_t element) {
  if (variable.name == "R") {
    return fmt::format("R{}", element);
  }
  if (variable.shape.dimensions == 0) {
    return variable.name;
  }
  const bool by_axis = variable.name.starts_with("$MA_");
  std::string indices;
  for (int i = variable.shape.dimensions - 1; i >= 0; --i) {
    const int size = variable.shape.size[static_cast<std::size_t>(i)];
    const int index = element % size;
    const bool is_axis = by_axis && i == variable.shape.dimensions - 1;
    const std::string shown_index =
        is_axis ? std::string(1, kAxisLetters[static_cast<std::size_t>(index)])
                : std::to_string(index);
    indices = shown_index + (indices.empty() ? "" : ",") + indices;
    element /= size;
  }
  return fmt::format("{}[{}]", variable.name, indices);
}

}  // namespace g31::sinumerik
