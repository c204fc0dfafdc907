#include "interpreter/dialects/fanuc/vocabulary/functions.h"

#include <array>

namespace g31::fanuc {
namespace {

constexpr auto kFunctionRows = std::to_array<FunctionInfo>({
#define FUNCTION(name, also, arguments, level, text) \
  {#name, also, Arguments::arguments, FunctionLevel::level, text},
#include "interpreter/dialects/fanuc/vocabulary/functions.def"
#undef FUNCTION
});

consteval bool first_two_letters_differ() {
  for (std::size_t i = 0; i < kFunctionRows.size(); ++i) {
    for (std::size_t j = i + 1; j < kFunctionRows.size(); ++j) {
      if (kFunctionRows[i].name.substr(0, 2) == kFunctionRows[j].name.substr(0, 2)) {
        return false;
      }
    }
  }
  return true;
}
static_assert(first_two_letters_differ(), "functions.def: abbreviations would be ambiguous");

}  // namespace

std::span<const FunctionInfo> functions() {
  return kFunctionRows;
}

const FunctionInfo& info(FunctionId id) {
  return kFunctionRows.at(static_cast<std::size_t>(id));
}

std::optional<FunctionId> find_function(std::string_view name) {
  for (std::size_t i = 0; i < kFunctionRows.size(); ++i) {
    const FunctionInfo& row = kFunctionRows[i];
    if (name.size() >= 2 && (row.name.starts_with(name) || name == row.also)) {
      return static_cast<FunctionId>(i);
    }
  }
  return std::nullopt;
}

}  // namespace g31::fanuc
