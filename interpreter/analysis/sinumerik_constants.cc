#include "interpreter/analysis/sinumerik_constants.h"

#include <cstddef>
#include <string>

#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::analysis {
namespace {

using sinumerik::AlarmId;
using sinumerik::Bank;
using sinumerik::Op;
using sinumerik::OpCode;
using sinumerik::Operand;
using sinumerik::Type;
using sinumerik::WrongValue;
using Wrong = std::optional<WrongValue>;

class Constants {
 public:
  explicit Constants(const sinumerik::CompiledProgram& program) : program_(program) {}

  [[nodiscard]] Wrong whole(Type type, Operand operand, AlarmId alarm) const {
    const auto value = number(operand);
    return value && !fits(type, sinumerik::rounded(*value))
               ? Wrong(not_of_type(type, *value, alarm))
               : std::nullopt;
  }
  [[nodiscard]] Wrong limits(const Op& step) const {
    const auto value = number(step.a);
    return value ? beyond_limits(variable(step), *value) : std::nullopt;
  }
  [[nodiscard]] Wrong index(const Op& step) const {
    const auto value = number(step.a);
    const sinumerik::Variable& array = variable(step);
    // The caller says how large the array of a VAR parameter is.
    if (!value || array.storage == sinumerik::Storage::Reference) {
      return std::nullopt;
    }
    const double place = sinumerik::rounded(*value);
    const int size = array.shape.size[step.detail];
    return place >= 0.0 && place < size ? std::nullopt
                                        : Wrong(no_such_index(array, step.detail, place, size));
  }
  [[nodiscard]] Wrong text(const Op& step) const {
    const sinumerik::Variable& into = variable(step);
    if (step.result.bank != Bank::Constants || into.storage == sinumerik::Storage::Reference) {
      return std::nullopt;
    }
    const std::string& value = program_.text_constants[static_cast<std::size_t>(step.result.place)];
    return sinumerik::too_long(value.substr(0, value.find('\0')), into.longest);
  }
  [[nodiscard]] Wrong division(const Op& step) const {
    return number(step.b) == 0.0 ? Wrong(WrongValue{AlarmId::ArithmeticError, "division by zero"})
                                 : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<double> number(Operand operand) const {
    return operand.bank == Bank::Constants
               ? std::optional(program_.constants[static_cast<std::size_t>(operand.place)])
               : std::nullopt;
  }
  [[nodiscard]] const sinumerik::Variable& variable(const Op& step) const {
    return program_.variables[static_cast<std::size_t>(step.b.place)];
  }

  const sinumerik::CompiledProgram& program_;
};

}  // namespace

Wrong wrong_constant(const sinumerik::CompiledProgram& program, const Op& step) {
  const Constants constants(program);
  const OpCode code = step.code;
  if (code == OpCode::ToInt || code == OpCode::ToChar) {
    return constants.whole(code == OpCode::ToInt ? Type::Int : Type::Char, step.a,
                           AlarmId::BadConversion);
  }
  if (code == OpCode::CheckLimits) {
    return constants.limits(step);
  }
  if (code == OpCode::Index) {
    return constants.index(step);
  }
  if (code == OpCode::StoreText) {
    return constants.text(step);
  }
  const bool divides =
      code == OpCode::Divide || code == OpCode::DivideWhole || code == OpCode::Modulo;
  return divides ? constants.division(step) : std::nullopt;
}

}  // namespace g31::analysis
