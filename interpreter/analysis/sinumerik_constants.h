#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/value_limits.h"

namespace g31::analysis {

using WrongStep = std::optional<sinumerik::WrongValue>;

/// The steps of a program in their order, as far as constants make their values.
class SinumerikConstants {
 public:
  /// It must outlive it.
  explicit SinumerikConstants(const sinumerik::CompiledProgram& program) : program_(program) {}

  /// What ends every run of a step, because its operands are constants that do not go there: a
  /// text longer than its variable, more values than an array has elements, a number beyond INT,
  /// CHAR or LLI and ULI, an index that the array has not, a division by 0, an argument that the
  /// function does not take.  nullopt: nothing, or only a run knows.
  WrongStep look_at(const sinumerik::Op& step);

  /// nullopt: only a run knows.
  [[nodiscard]] std::optional<double> number(sinumerik::Operand operand) const;

 private:
  [[nodiscard]] WrongStep wrong_in(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep whole(sinumerik::Type type, sinumerik::Operand operand,
                                sinumerik::AlarmId alarm) const;
  [[nodiscard]] WrongStep limits(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep index(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep elements(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep text(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep operation(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep function(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep passes(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep procedure(const sinumerik::Op& step) const;
  [[nodiscard]] WrongStep action(const sinumerik::Op& step) const;
  [[nodiscard]] std::optional<double> result_of(const sinumerik::Op& step) const;
  [[nodiscard]] const sinumerik::Variable& variable(const sinumerik::Op& step) const {
    return program_.variables[static_cast<std::size_t>(step.b.place)];
  }

  const sinumerik::CompiledProgram& program_;
  std::array<std::optional<double>, sinumerik::kTemporaryCount> temporaries_;
};

}  // namespace g31::analysis
