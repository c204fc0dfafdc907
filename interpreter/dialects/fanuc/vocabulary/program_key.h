#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// What a program is called by: O and its number, or its name (MB-002).
struct ProgramKey {
  std::int32_t number = 0;  ///< 0: it has none
  std::string name;         ///< what stands between < and >; empty: it has none
  [[nodiscard]] bool is_empty() const { return number == 0 && name.empty(); }
  friend auto operator<=>(const ProgramKey&, const ProgramKey&) = default;
};

/// `O9010`, `<BORE>`; empty for an empty key.
std::string to_text(const ProgramKey& key);
/// Why a program that is called is not found.
std::string missing_program(const ProgramKey& key);

/// @param name  what stands between < and >; O and a number are a number there, too
ProgramKey key_of_name(std::string_view name);

/// The name of a program.  @param name  `<BORE>` in a text; else the name is empty
std::string_view between_angles(std::string_view text, syntax::ShortSpan name);

/// What a call by such a text means.
ProgramKey key_between_angles(std::string_view text, syntax::ShortSpan name);

/// Whether a program may have this name: 1 to 32 letters, digits and - + _ .
bool is_program_name(std::string_view name);

}  // namespace g31::fanuc
