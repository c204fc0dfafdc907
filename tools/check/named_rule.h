#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace g31::check {

/// Why a word is the code of no rule of rules.def, with the nearest one: "no such rule, did you
/// mean NC003?"; nullopt: it is one, in capitals or small letters.
std::optional<std::string> why_no_rule(std::string_view word);

}  // namespace g31::check
