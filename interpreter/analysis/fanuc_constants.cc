#include "interpreter/analysis/fanuc_constants.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"

namespace g31::analysis {
namespace {

using syntax::BlockKind;
using syntax::Index;
using syntax::kNone;
using WrongFanuc = std::optional<fanuc::WrongValue>;

/// All rows that a control of the profile may have: which memory of tool offsets it has, and how
/// their numbers run, the set-up says.
fanuc::VariableGroups possible_groups(const fanuc::Profile& profile) {
  using enum fanuc::VariableGroup;
  return profile.variables.meets({OffsetsC})
             ? profile.variables.with(OffsetsA).with(OffsetsB).with(OffsetsCTurned)
             : profile.variables;
}

/// The value of every operation of an expression, as far as constants make it.
class FanucConstants {
 public:
  FanucConstants(const fanuc::CompiledProgram& program, const fanuc::Profile& profile)
      : program_(program), profile_(profile) {}

  /// Goes through the code of an expression.  @returns what is wrong with it
  std::optional<WrongConstant> look_at(Index code) {
    for (;; ++code) {
      const fanuc::Op& op = program_.ops[code];
      if (op.code == fanuc::OpCode::End) {
        value_ = known(op.a);
        return std::nullopt;
      }
      if (auto wrong = wrong_operation(op)) {
        return WrongConstant{std::move(*wrong), program_.op_spans[code]};
      }
      known_.at(op.result) = result_of(op);
    }
  }

  /// Of the expression that was looked at; nullopt: only a run knows.
  [[nodiscard]] const std::optional<fanuc::Cell>& value() const { return value_; }

  /// A variable that a program writes, by its number.
  [[nodiscard]] WrongFanuc unwritable(std::int32_t number) const {
    if (fanuc::is_local(number) || fanuc::is_common(number)) {
      return std::nullopt;
    }
    const auto why =
        number == 0 ? fanuc::AlarmId::WriteProtected : why_not(number, fanuc::why_unwritable);
    return why ? WrongFanuc(fanuc::WrongValue{*why, fmt::format("#{} cannot be written", number)})
               : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<fanuc::Cell> known(fanuc::Operand operand) const {
    const auto place = static_cast<std::size_t>(operand.place);
    return operand.bank == fanuc::Bank::Constants     ? std::optional(program_.constants[place])
           : operand.bank == fanuc::Bank::Temporaries ? known_.at(place)
                                                      : std::nullopt;
  }

  [[nodiscard]] WrongFanuc wrong_operation(const fanuc::Op& op) const {
    if (op.is_missing) {
      return fanuc::missing_operation(op);
    }
    const auto a = known(op.a);
    const auto b = known(op.b);
    if (op.code == fanuc::OpCode::Divide) {
      return b && b->or_zero() == 0.0 ? WrongFanuc(fanuc::no_divisor(*b)) : std::nullopt;
    }
    if (op.code == fanuc::OpCode::Modulo || op.code == fanuc::OpCode::And ||
        op.code == fanuc::OpCode::Or || op.code == fanuc::OpCode::Xor) {
      return wrong_whole(op, a, b);
    }
    if (op.code == fanuc::OpCode::Read) {
      return a ? unreadable(fanuc::variable_number(a->or_zero())) : std::nullopt;
    }
    if (op.code == fanuc::OpCode::DigitLimit) {
      return op.function > profile_.digit_limit
                 ? WrongFanuc(fanuc::too_many_digits(op.function, profile_.digit_limit))
                 : std::nullopt;
    }
    const auto id = static_cast<fanuc::FunctionId>(op.function);
    return op.code == fanuc::OpCode::Call && a && !fanuc::is_defined_at(id, a->or_zero())
               ? WrongFanuc(fanuc::undefined_at(id, a->or_zero()))
               : std::nullopt;
  }

  /// Of operands that only a run knows any number stands in that is right for both.
  [[nodiscard]] WrongFanuc wrong_whole(const fanuc::Op& op, const std::optional<fanuc::Cell>& a,
                                       const std::optional<fanuc::Cell>& b) const {
    const auto whole = [&](const std::optional<fanuc::Cell>& operand) {
      return operand ? fanuc::whole_operand(op.code, operand->or_zero(), profile_.logic_operands)
                     : 1.0;
    };
    return fanuc::wrong_operands(op.code, whole(a), whole(b));
  }

  [[nodiscard]] WrongFanuc unreadable(std::int32_t number) const {
    if (number == 0 || fanuc::is_local(number) || fanuc::is_common(number)) {
      return std::nullopt;
    }
    const auto why = why_not(number, fanuc::why_unreadable);
    return why ? WrongFanuc(fanuc::WrongValue{*why, fmt::format("#{} cannot be read", number)})
               : std::nullopt;
  }

  /// Why none of the rows that hold a number lets it be read or written; nullopt: one may.
  template <typename Why>
  [[nodiscard]] std::optional<fanuc::AlarmId> why_not(std::int32_t number, Why why) const {
    const fanuc::VariableGroups groups = possible_groups(profile_);
    std::optional<fanuc::AlarmId> found = why(nullptr);
    for (const fanuc::SystemVariable& row : fanuc::system_variables()) {
      if (row.first <= number && number <= row.last && row.groups.meets(groups)) {
        found = why(&row);
        if (!found) {
          return std::nullopt;
        }
      }
    }
    return found;
  }

  [[nodiscard]] std::optional<fanuc::Cell> result_of(const fanuc::Op& op) const {
    const auto a = known(op.a);
    const auto b = known(op.b);
    if (op.code == fanuc::OpCode::Negate) {
      return a && !a->is_vacant() ? std::optional(fanuc::Cell(-a->raw())) : a;
    }
    if (!a || !b) {
      return std::nullopt;
    }
    const double x = a->or_zero();
    const double y = b->or_zero();
    return op.code == fanuc::OpCode::Add        ? std::optional(fanuc::Cell(x + y))
           : op.code == fanuc::OpCode::Subtract ? std::optional(fanuc::Cell(x - y))
           : op.code == fanuc::OpCode::Multiply ? std::optional(fanuc::Cell(x * y))
           : op.code == fanuc::OpCode::Divide   ? std::optional(fanuc::Cell(x / y))
                                                : std::nullopt;
  }

  const fanuc::CompiledProgram& program_;
  const fanuc::Profile& profile_;
  std::array<std::optional<fanuc::Cell>, fanuc::kTemporaryCount> known_;
  std::optional<fanuc::Cell> value_;
};

std::optional<WrongConstant> wrong_assignment(const fanuc::CompiledProgram& program,
                                              const fanuc::Step& step, FanucConstants& constants) {
  std::optional<std::int32_t> number = step.number;
  if (step.target_kind == fanuc::TargetKind::Computed) {
    if (auto wrong = constants.look_at(step.target)) {
      return wrong;
    }
    number = constants.value() ? std::optional(fanuc::variable_number(constants.value()->or_zero()))
                               : std::nullopt;
  }
  if (auto wrong = constants.look_at(step.value)) {
    return wrong;
  }
  auto wrong = number ? constants.unwritable(*number) : std::nullopt;
  return wrong ? std::optional(
                     WrongConstant{std::move(*wrong), program.tree->blocks[step.block].span})
               : std::nullopt;
}

/// The words of a block up to a / between them: what is behind it may be skipped.
std::optional<WrongConstant> wrong_words(const fanuc::CompiledProgram& program,
                                         const fanuc::Step& step, const fanuc::Profile& profile,
                                         FanucConstants& constants) {
  const syntax::Block& block = program.tree->blocks[step.block];
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = program.tree->words[i];
    if (word.letter == '/') {
      return std::nullopt;
    }
    if (word.form == syntax::ValueForm::Computed) {
      if (auto wrong = constants.look_at(program.word_code[i - program.first_word])) {
        return wrong;
      }
    } else if (!fanuc::fits_address(word.number, word.digits, profile.word_digit_limit)) {
      return WrongConstant{
          fanuc::wrong_word(word.letter, word.number, word.digits, profile.word_digit_limit),
          word.span};
    }
  }
  return std::nullopt;
}

std::optional<WrongConstant> wrong_format(const fanuc::CompiledProgram& program,
                                          const fanuc::Step& step, const fanuc::Profile& profile) {
  const auto statement = static_cast<fanuc::OutputStatement>(step.number);
  if (fanuc::info(statement).has_format == fanuc::HasFormat::No) {
    return std::nullopt;
  }
  const syntax::ShortSpan format = program.tree->blocks[step.block].text;
  const auto items = fanuc::parse_output_format(
      program.file->text().substr(format.begin, format.end - format.begin));
  auto wrong =
      items.ok() ? fanuc::wrong_output(statement, profile.output, items.value()) : std::nullopt;
  return wrong ? std::optional(WrongConstant{*std::move(wrong), format}) : std::nullopt;
}

}  // namespace

std::optional<WrongConstant> wrong_constant(const fanuc::CompiledProgram& program,
                                            const fanuc::Step& step,
                                            const fanuc::Profile& profile) {
  FanucConstants constants(program, profile);
  switch (step.kind) {
    case BlockKind::Assign:
      return wrong_assignment(program, step, constants);
    case BlockKind::IfGoto:
    case BlockKind::IfThen:
    case BlockKind::While:
      return constants.look_at(step.condition);
    case BlockKind::Goto:
      return step.jump == kNone ? constants.look_at(step.value) : std::nullopt;
    case BlockKind::Nc:
      return wrong_words(program, step, profile, constants);
    case BlockKind::Output:
      return wrong_format(program, step, profile);
    case BlockKind::Empty:
    case BlockKind::Do:
    case BlockKind::End:
    case BlockKind::SetNames:
    case BlockKind::Bad:
      break;
  }
  return std::nullopt;
}

std::optional<WrongConstant> wrong_repeats(const syntax::Word& word) {
  if (word.form != syntax::ValueForm::Integer) {
    return std::nullopt;
  }
  auto wrong = fanuc::wrong_repeats(fanuc::nearest_integer(word.number));
  return wrong ? std::optional(WrongConstant{std::move(*wrong), word.span}) : std::nullopt;
}

}  // namespace g31::analysis
