#pragma once

#include <span>
#include <string_view>

namespace g31::manual {

/// What a parameter of a measuring cycle means: a row of cycle_parameters.def.
struct CycleParameter {
  std::string_view cycles;  ///< "961 998", the numbers of those it is about; "" of all others
  std::string_view name;    ///< "S_FA"
  std::string_view text;
};

std::span<const CycleParameter> cycle_parameters();

/// The text of the first row that fits; "" when there is none.
/// @param cycle  "CYCLE977"
std::string_view text_of_parameter(std::string_view cycle, std::string_view name);

}  // namespace g31::manual
