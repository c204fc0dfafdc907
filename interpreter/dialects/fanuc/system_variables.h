#pragma once

#include <span>
#include <string_view>

namespace g31::fanuc {

enum class Unit { None, Length, Angle };
enum class Access { Read, Write, ReadWrite };
enum class WhileMoving { Enabled, Disabled };

enum class SystemVariableId {
#define SYSTEM_VARIABLE(first, last, name, unit, access, while_moving, text) name,
#include "interpreter/dialects/fanuc/system_variables.def"
#undef SYSTEM_VARIABLE
};

/// One row of system_variables.def: a run of numbers that mean the same thing for axes or rows 1, 2...
struct SystemVariable {
  SystemVariableId id;
  int first;
  int last;
  std::string_view name;
  Unit unit;
  Access access;
  WhileMoving while_moving;
  std::string_view text;
};

/// All rows, rising by number.
std::span<const SystemVariable> system_variables();

/// The row that holds #number, or nullptr when the control has no such variable (alarm PS0115).
const SystemVariable* find_system_variable(int number);

}  // namespace g31::fanuc
