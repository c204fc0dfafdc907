#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/setup/keys.h"

namespace g31::setup {

/// A row of units.def: what numbers of a unit stay within.
struct UnitBounds {
  std::string_view name;
  double least;  ///< in size, of a number that must be positive, or is 0 or more and not 0
  double most;   ///< in size
};

/// All rows of units.def.
std::span<const UnitBounds> bounded_units();

/// The row of a unit, or nullptr: numbers of it have no bounds.
const UnitBounds* find_unit(std::string_view name);

/// Numbers that a limit allows, beside those of its other ranges.
struct NumberRange {
  Limit of;
  double least;
  double most;  ///< may be infinite
  bool without_least = false;
};

/// None: the limit says nothing of single numbers.
std::vector<NumberRange> ranges_of(Limit limit);

/// Whether a number lies in a range of the limit, or the limit has none.
bool number_within(Limit limit, double number);

/// "a number", "an array of two numbers".
std::string_view words_for(ValueType type);

/// What a value should be: "greater than 0"; "" for Limit::Any.
std::string_view words_for(Limit limit);

/// The texts that a limit chooses among, as they are written: IS-A, IS-B, IS-C.  None: it is no
/// choice.
std::vector<std::string> choices_of(Limit limit);

}  // namespace g31::setup
