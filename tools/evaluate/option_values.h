#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// What is wrong with a value; nullopt: nothing.
using WrongValue = std::optional<std::string>;

/// A number of a size within 1e6 that is all of the text.
std::optional<double> option_number(std::string_view text);

/// Of --sense.
std::vector<std::string> sense_names();

/// Puts the value of an option into a request.
WrongValue take_value(OptionId id, const std::string& text, Request& request);

}  // namespace g31::evaluate
