#include "interpreter/dialects/fanuc/run/assignments.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/run/evaluation_failure.h"
#include "interpreter/dialects/fanuc/state/expression_reads.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "interpreter/source/readable_text.h"

namespace g31::fanuc {
namespace {

/// What a variable shows when nobody asks for it.
std::optional<Cell> looked_at(Control& control, std::int32_t number) {
  const runtime::LookFromOutside look(control.touches);
  const auto value = control.all_variables.read(number);
  return value ? std::optional(value.value()) : std::nullopt;
}

}  // namespace

std::optional<AlarmId> write_variable(Control& control, const CallStack& stack, std::int32_t number,
                                      Cell value) {
  runtime::BlockListener* const listener = control.watch.write_listener();
  const Cell before = listener != nullptr ? looked_at(control, number).value_or(Cell()) : Cell();
  if (const auto refused = control.all_variables.write(number, value)) {
    return refused;
  }
  if (listener != nullptr) {
    listener->on_write({fmt::format("#{}", number), before,
                        looked_at(control, number).value_or(value), stack.here()});
  }
  return std::nullopt;
}

MaybeFailure Assignments::assign(const Step& step) {
  const CompiledProgram& program = *frame().program;
  std::int32_t number = step.number;
  if (step.target_kind == TargetKind::Computed) {
    const Cell index = control_.evaluator.evaluate(program, step.target);
    if (control_.evaluator.failed()) {
      return evaluation_failure(control_.evaluator);
    }
    number = variable_number(index.or_zero());
  }
  const Cell value = control_.evaluator.value(program, step.value);
  if (control_.evaluator.failed()) {
    return evaluation_failure(control_.evaluator);
  }
  if (const auto refused = write_variable(control_, stack_, number, value)) {
    Failure failure;
    failure.id = *refused;
    failure.where = program.tree->blocks[step.block].span;
    failure.detail = fmt::format("#{} cannot be written", number);
    return failure;
  }
  if (control_.touches.missed.any()) {
    control_.touches.missed.assigns(holder_of(control_.variables.depth(), number));
  }
  return assigned_system_variable(number, value.or_zero());
}

/// What an assignment to #3000 or #3006 sets off, with the comment behind it as text.
MaybeFailure Assignments::assigned_system_variable(int number, double value) {
  if (number != 3000 && number != 3006) {
    return std::nullopt;
  }
  const CompiledProgram& program = *frame().program;
  const syntax::Block& block = program.tree->blocks[program.steps[frame().current].block];
  const std::string text = source::readable_text(
      program.file->text().substr(block.text.begin, block.text.end - block.text.begin));
  if (auto failure = end_read_ahead(control_)) {
    return failure;
  }
  if (number == 3006) {
    control_.observer.on_stop({"#3006", text, stack_.location(block.span)});
    return std::nullopt;
  }
  Failure failure;
  failure.id = AlarmId::MacroAlarm;
  failure.where = block.span;
  failure.alarm_text = text.empty() ? std::string(info(AlarmId::MacroAlarm).text) : text;
  const MacroAlarmRule& rule = control_.profile.macro_alarm;
  const int n = nearest_integer(value);
  const bool plain =
      rule.has_plain_numbers && control_.parameters.is_on(ParameterId::PlainAlarmNumber);
  const bool adds = rule.number == MacroAlarmRule::Number::BasePlusValue;
  failure.alarm_number = plain ? n : rule.base + (adds ? n : 0);
  if (n < rule.smallest || n > rule.largest) {
    failure.detail = fmt::format("#3000 takes {} to {}", rule.smallest, rule.largest);
  } else if (!adds) {
    failure.detail = std::to_string(n);
  }
  return failure;
}

MaybeFailure Assignments::set_names(const Step& step) {
  const CompiledProgram& program = *frame().program;
  const syntax::ShortSpan span = program.tree->blocks[step.block].text;
  std::int32_t number = step.number;
  const std::string_view list = program.file->text().substr(span.begin, span.end - span.begin);
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    std::string name = upper_case(list.substr(begin, comma - begin));
    begin = comma + 1;
    std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
    const NameRule& rule = control_.profile.names;
    const bool in_range = is_common(number) && number >= rule.first && number <= rule.last;
    if (!in_range || static_cast<int>(name.size()) > rule.longest) {
      Failure failure;
      failure.id = in_range ? AlarmId::NameFormat : AlarmId::IllegalVariable;
      failure.detail =
          in_range ? fmt::format("a name has at most {} characters", rule.longest)
                   : fmt::format("SETVN names #{} to #{}, not #{}", rule.first, rule.last, number);
      return failure;
    }
    if (name.empty()) {
      control_.variables.names.take_name(number);
    } else {
      control_.variables.names.give(std::move(name), number++);
    }
  }
  return std::nullopt;
}

}  // namespace g31::fanuc
