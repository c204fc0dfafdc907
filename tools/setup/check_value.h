#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "machine/base/result.h"
#include "tools/setup/document.h"
#include "tools/setup/keys.h"
#include "tools/setup/setup_error.h"

namespace g31::setup {

/// A checked value: vacant, a number or flag, a text, or a list of numbers.  Numbers are finite.
using SheetValue = std::variant<std::monostate, double, std::string, std::vector<double>>;

/// Why a value is refused, in the words of "KEY is ..., it should be ...".
struct ValueProblem {
  SetupErrorId id = SetupErrorId::WrongType;
  std::string is;
  std::string should_be;
};

/// Every whole number up to 2^53 is a double of its own.
inline constexpr std::int64_t kLargestExact = std::int64_t{1} << 53;

/// The value of a node as `type` and `limit` want it, within the bounds of its unit (units.def).
///
/// Whole numbers become doubles; those beyond kLargestExact in size are refused, so none is
/// rounded.
/// @param unit  "": none, and no bounds
Result<SheetValue, ValueProblem> checked_value(const Node& node, ValueType type, Limit limit,
                                               std::string_view unit);

/// "a string", "a table": what an error calls a value.
std::string kind_of(const Node& node);

}  // namespace g31::setup
