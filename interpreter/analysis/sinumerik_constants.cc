#include "interpreter/analysis/sinumerik_constants.h"

#include <cmath>
#include <string>

#include "interpreter/dialects/sinumerik/code/word_limits.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::analysis {
namespace {

using sinumerik::AlarmId;
using sinumerik::Bank;
using sinumerik::FunctionId;
using sinumerik::Op;
using sinumerik::OpCode;
using sinumerik::Operand;
using sinumerik::Type;

bool divides(OpCode code) {
  return code == OpCode::Divide || code == OpCode::DivideWhole || code == OpCode::Modulo;
}

bool calculates(OpCode code) {
  return divides(code) || code == OpCode::Add || code == OpCode::Subtract ||
         code == OpCode::Multiply;
}

/// @param code  one that calculates
double calculated(OpCode code, double a, double b) {
  return code == OpCode::Add           ? a + b
         : code == OpCode::Subtract    ? a - b
         : code == OpCode::Multiply    ? a * b
         : code == OpCode::Divide      ? a / b
         : code == OpCode::DivideWhole ? std::trunc(a / b)
                                       : std::fmod(a, b);
}

bool is_of_two(FunctionId id) {
  return sinumerik::info(id).parameters.size() > 1;
}

}  // namespace

WrongStep SinumerikConstants::look_at(const Op& step) {
  if (step.code == OpCode::Block) {
    temporaries_ = {};
  }
  auto wrong = wrong_in(step);
  if (step.result.bank == Bank::Temporaries) {
    temporaries_.at(static_cast<std::size_t>(step.result.place)) =
        wrong ? std::nullopt : result_of(step);
  }
  return wrong;
}

std::optional<double> SinumerikConstants::number(Operand operand) const {
  const auto place = static_cast<std::size_t>(operand.place);
  if (operand.bank == Bank::Constants) {
    // An operand that a step does not have is constant 0, of which there may be none.
    return place < program_.constants.size() ? std::optional(program_.constants[place])
                                             : std::nullopt;
  }
  return operand.bank == Bank::Temporaries ? temporaries_.at(place) : std::nullopt;
}

WrongStep SinumerikConstants::wrong_in(const Op& step) const {
  const OpCode code = step.code;
  if (code == OpCode::ToInt || code == OpCode::ToChar) {
    return whole(code == OpCode::ToInt ? Type::Int : Type::Char, step.a, AlarmId::BadConversion);
  }
  if (code == OpCode::CheckInt) {
    return whole(Type::Int, step.a, AlarmId::ArithmeticError);
  }
  return code == OpCode::CheckLimits                          ? limits(step)
         : code == OpCode::Index                              ? index(step)
         : code == OpCode::StoreText                          ? text(step)
         : code == OpCode::Fill || code == OpCode::Repeat     ? elements(step)
         : code == OpCode::Math || code == OpCode::Function   ? function(step)
         : code == OpCode::Call || code == OpCode::RepeatPart ? passes(step)
         : code == OpCode::Procedure                          ? procedure(step)
         : code == OpCode::SynchronisedAction                 ? action(step)
                                                              : operation(step);
}

WrongStep SinumerikConstants::whole(Type type, Operand operand, AlarmId alarm) const {
  const auto value = number(operand);
  return value && !fits(type, sinumerik::rounded(*value))
             ? WrongStep(not_of_type(type, *value, alarm))
             : std::nullopt;
}

WrongStep SinumerikConstants::limits(const Op& step) const {
  const auto value = number(step.a);
  return value ? beyond_limits(variable(step), *value) : std::nullopt;
}

WrongStep SinumerikConstants::index(const Op& step) const {
  const auto value = number(step.a);
  const sinumerik::Variable& array = variable(step);
  // The caller says how large the array of a VAR parameter is.
  if (!value || array.storage == sinumerik::Storage::Reference) {
    return std::nullopt;
  }
  const double place = sinumerik::rounded(*value);
  const int size = array.shape.size[step.detail];
  return place >= 0.0 && place < size ? std::nullopt
                                      : WrongStep(no_such_index(array, step.detail, place, size));
}

/// SET and REP: values behind the last element of the array.
WrongStep SinumerikConstants::elements(const Op& step) const {
  const sinumerik::Variable& array = program_.variables[static_cast<std::size_t>(step.a.place)];
  const auto first = number(step.result);
  if (!first || array.storage == sinumerik::Storage::Reference) {
    return std::nullopt;
  }
  const auto* const list = program_.arguments.data() + step.b.place;
  auto given = static_cast<double>(step.count);
  if (step.code == OpCode::Repeat) {
    given = step.count > 1 ? number(list[1].value).value_or(0.0) : 0.0;
  } else {
    for (; given > 0.0; --given) {
      if (list[static_cast<std::size_t>(given) - 1].form != sinumerik::Argument::Form::Omitted) {
        break;
      }
    }
  }
  return given < 0.0 || (given > 0.0 && *first + given > array.shape.count())
             ? WrongStep({AlarmId::TooManyInitialValues, ""})
             : std::nullopt;
}

WrongStep SinumerikConstants::text(const Op& step) const {
  const sinumerik::Variable& into = variable(step);
  if (step.result.bank != Bank::Constants || into.storage == sinumerik::Storage::Reference) {
    return std::nullopt;
  }
  const std::string& value = program_.text_constants[static_cast<std::size_t>(step.result.place)];
  return sinumerik::too_long(value.substr(0, value.find('\0')), into.longest);
}

WrongStep SinumerikConstants::operation(const Op& step) const {
  const auto a = number(step.a);
  const auto b = number(step.b);
  if (!calculates(step.code) || !b || (!a && !(divides(step.code) && *b == 0.0))) {
    return std::nullopt;
  }
  return std::isfinite(calculated(step.code, a.value_or(1.0), *b))
             ? std::nullopt
             : WrongStep(sinumerik::no_number(*b));
}

WrongStep SinumerikConstants::function(const Op& step) const {
  const auto id = static_cast<FunctionId>(step.detail);
  if (step.code == OpCode::Math) {
    const auto a = number(step.a);
    const auto b = is_of_two(id) ? number(step.b) : std::optional(0.0);
    return a && b && !sinumerik::mathematics(id, *a, *b)
               ? WrongStep(sinumerik::undefined_at(id, *a))
               : std::nullopt;
  }
  if (id != FunctionId::BOUND) {
    return std::nullopt;
  }
  const auto first = static_cast<std::size_t>(step.b.place);
  const auto low = number(program_.arguments[first].value);
  const auto high = number(program_.arguments[first + 1].value);
  return low && high ? sinumerik::wrong_bounds(*low, *high) : std::nullopt;
}

WrongStep SinumerikConstants::passes(const Op& step) const {
  if (step.code == OpCode::RepeatPart) {
    const auto given = number(step.b);
    return given ? sinumerik::wrong_passes(*given) : std::nullopt;
  }
  const sinumerik::CallSite& site = program_.calls[static_cast<std::size_t>(step.a.place)];
  const auto given = site.is_modal ? std::nullopt : number(site.passes);
  return given ? sinumerik::wrong_passes(*given) : std::nullopt;
}

/// SETAL and SETMS, and what stands in synchronised actions alone: their steps are not among these.
WrongStep SinumerikConstants::procedure(const Op& step) const {
  const auto id = static_cast<sinumerik::ProcedureId>(step.detail);
  if (sinumerik::belongs_to_action(id)) {
    return sinumerik::outside_of_action(id);
  }
  const auto given = step.count > 0
                         ? number(program_.arguments[static_cast<std::size_t>(step.b.place)].value)
                         : std::nullopt;
  if (!given) {
    return std::nullopt;
  }
  return id == sinumerik::ProcedureId::SETAL
             ? sinumerik::wrong_alarm_number(sinumerik::rounded(*given))
         : id == sinumerik::ProcedureId::SETMS ? sinumerik::wrong_master_spindle(*given)
                                               : std::nullopt;
}

/// ID.
WrongStep SinumerikConstants::action(const Op& step) const {
  const auto scope = static_cast<sinumerik::ActionScope>(step.detail % sinumerik::kActionScopes);
  const auto given = scope == sinumerik::ActionScope::NextBlock ? std::nullopt : number(step.a);
  return given ? sinumerik::wrong_action_number(*given) : std::nullopt;
}

/// nullopt also of operations whose result nobody is to know here, as of comparisons.
std::optional<double> SinumerikConstants::result_of(const Op& step) const {
  const auto a = number(step.a);
  const auto b = number(step.b);
  const OpCode code = step.code;
  if (!a) {
    return std::nullopt;
  }
  if (code == OpCode::Move || code == OpCode::Negate) {
    return code == OpCode::Move ? *a : -*a;
  }
  if (code == OpCode::CheckInt || code == OpCode::ToInt || code == OpCode::ToChar) {
    return sinumerik::rounded(*a);
  }
  const bool is_function = code == OpCode::Math;
  const auto id = static_cast<FunctionId>(step.detail);
  if (is_function && (b || !is_of_two(id))) {
    return sinumerik::mathematics(id, *a, b.value_or(0.0));
  }
  return b && calculates(code) ? std::optional(calculated(code, *a, *b)) : std::nullopt;
}

}  // namespace g31::analysis
