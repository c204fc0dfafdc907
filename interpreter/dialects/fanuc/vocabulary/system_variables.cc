#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"

#include <algorithm>
#include <array>

namespace g31::fanuc {
namespace {

using enum VariableGroup;

constexpr auto kSystemVariableRows = std::to_array<SystemVariable>({
#define In(...) \
  { __VA_ARGS__ }
#define SYSTEM_VARIABLE(first, last, shows, groups, unit, access, while_moving, text) \
  {first, last, Shows::shows, groups, Unit::unit, Access::access, WhileMoving::while_moving, text},
#include "interpreter/dialects/fanuc/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE
#undef In
});

/// Rows of one group never overlap; rows of groups that one control has together are compared for
/// every control by a test.
consteval bool rising_without_overlap() {
  for (std::size_t i = 0; i < kSystemVariableRows.size(); ++i) {
    if (kSystemVariableRows[i].first > kSystemVariableRows[i].last ||
        (i > 0 && kSystemVariableRows[i - 1].first > kSystemVariableRows[i].first)) {
      return false;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (kSystemVariableRows[j].groups.meets(kSystemVariableRows[i].groups) &&
          kSystemVariableRows[j].last >= kSystemVariableRows[i].first) {
        return false;
      }
    }
  }
  return true;
}
static_assert(rising_without_overlap(), "system_variables.def: rows must rise and not overlap");

}  // namespace

std::span<const SystemVariable> system_variables() {
  return kSystemVariableRows;
}

SystemVariableIndex::SystemVariableIndex(VariableGroups groups) {
  for (const SystemVariable& row : kSystemVariableRows) {
    if (row.groups.meets(groups)) {
      rows_.push_back(&row);
    }
  }
}

const SystemVariable* SystemVariableIndex::find(int number) const {
  const auto row = std::ranges::lower_bound(rows_, number, {}, &SystemVariable::last);
  return row != rows_.end() && (*row)->first <= number ? *row : nullptr;
}

}  // namespace g31::fanuc
