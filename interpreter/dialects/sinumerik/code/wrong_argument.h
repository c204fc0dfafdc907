#pragma once

#include <optional>
#include <string>

#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::sinumerik {

/// What a call gives for one parameter, as far as it is known before it has a value.
struct GivenArgument {
  Argument::Form form = Argument::Form::Omitted;
  Type type = Type::None;
  int dimensions = 0;  ///< of a whole array
};

/// As the caller's program has it.
GivenArgument given_by(const Argument& argument, const CompiledProgram& caller);

/// Why a parameter does not take an argument.
struct WrongArgument {
  AlarmId id = AlarmId::WrongArgumentType;
  std::string detail;
};

/// What is wrong whatever the value is: no variable for a VAR parameter, another type or dimension,
/// no axis.  A text for a CHAR passes here: its length decides.
/// @param variable  of the parameter
std::optional<WrongArgument> wrong_argument(const Parameter& parameter, const Variable& variable,
                                            const GivenArgument& given);

/// "A: STRING is no CHAR"
WrongArgument wrong_type(const Variable& variable, Type given);

}  // namespace g31::sinumerik
