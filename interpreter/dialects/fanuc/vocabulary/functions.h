#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace g31::fanuc {

enum class Arguments { One, OneOrTwo, Two, Parameter };
/// Which functions a control has: those of its level and below.
enum class FunctionLevel : unsigned char { Basic, Full, Series30i };

enum class FunctionId : unsigned char {
#define FUNCTION(name, also, arguments, level, text) name,
#include "interpreter/dialects/fanuc/vocabulary/functions.def"
#undef FUNCTION
};

/// One row of functions.def.
struct FunctionInfo {
  std::string_view name;
  std::string_view also;  ///< a second name; "": none
  Arguments arguments;
  FunctionLevel level;
  std::string_view text;
};

/// All rows.
std::span<const FunctionInfo> functions();

const FunctionInfo& info(FunctionId id);

/// The function of this name, first or second, or of its abbreviation (two letters or more), upper
/// case.
std::optional<FunctionId> find_function(std::string_view name);

}  // namespace g31::fanuc
