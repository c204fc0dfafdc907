#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace g31::fanuc {

enum class Arguments { One, OneOrTwo, Two, Parameter };
enum class InSeries16i { Yes, No };

enum class FunctionId : unsigned char {
#define FUNCTION(name, arguments, series_16i, text) name,
#include "interpreter/dialects/fanuc/vocabulary/functions.def"
#undef FUNCTION
};

/// One row of functions.def.
struct FunctionInfo {
  std::string_view name;
  Arguments arguments;
  InSeries16i in_16i;
  std::string_view text;
};

/// All rows.
std::span<const FunctionInfo> functions();

const FunctionInfo& info(FunctionId id);

/// The function of this name or of its abbreviation (two letters or more), upper case.
std::optional<FunctionId> find_function(std::string_view name);

}  // namespace g31::fanuc
