#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/element_name.h"
#include "interpreter/dialects/sinumerik/run/runner.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/source/latin_1.h"

namespace g31::sinumerik {
namespace {

std::string why(const Failure& failure) {
  return failure.detail.empty() ? std::string(info(failure.id).text)
                                : fmt::format("{} {}", info(failure.id).text, failure.detail);
}

}  // namespace

runtime::ShownValue shown_value(const ShownValue& value) {
  if (value.type == Type::String) {
    return value.text;
  }
  if (value.type == Type::Axis) {
    return shown(Type::Axis, value.number);
  }
  return runtime::Cell(value.number);
}

/// How synchronised actions are judged and done.
SynchronisedActions::Among Runner::among() {
  SynchronisedActions::Among among;
  among.holds = [this](const CompiledProgram& condition,
                       std::size_t depth) -> Result<bool, std::string> {
    const auto value = result_of(condition, depth);
    return value ? Result<bool, std::string>(value.value().number != 0.0) : value.error();
  };
  among.act = [this](const CompiledProgram& actions, std::size_t depth,
                     const source::Location& where) {
    stack_.begin_action({depth, where});
    MaybeFailure wrong = run_among(actions, depth, channel_.watch.write_listener());
    stack_.end_action();
    operands_.use_level();
    return wrong;
  };
  return among;
}

/// Runs blocks among the variables of a level, which goes on afterwards as if there had been none.
/// @param listener  hears what they assign to; nullptr: nobody
MaybeFailure Runner::run_among(const CompiledProgram& program, std::size_t depth,
                               runtime::BlockListener* listener) {
  const std::size_t depth_before = stack_.look_at(depth);
  if (level().program == nullptr) {
    start(program);
  }
  const CompiledProgram* const program_before = std::exchange(level().program, &program);
  const std::int32_t step_before = std::exchange(level().step, 0);
  const std::int32_t current_before = stack_.current();
  const bool ended_before = stack_.set_ended(false);
  const bool paused_before = std::exchange(is_paused_, false);
  auto parts = std::exchange(level().parts, {});
  auto waiting = std::exchange(level().waiting, {});
  const auto watch = std::exchange(channel_.watch, runtime::BlockWatch(runtime::Budget{}));
  words_.words().clear();
  operands_.use_level();
  MaybeFailure reason = listener != nullptr ? heard_loop(*listener) : loop();
  if (reason && !reason->where) {
    reason->where = stack_.here();
  }
  channel_.watch = watch;
  level().waiting = std::move(waiting);
  level().parts = std::move(parts);
  is_paused_ = paused_before;
  stack_.set_ended(ended_before);
  stack_.set_current(current_before);
  level().step = step_before;
  level().program = program_before;
  stack_.look_at(depth_before);
  return reason;
}

/// Whose local variables those of a level are; where its parameters stand for nothing it has none.
const CompiledProgram& Runner::home(std::size_t depth) const {
  static const CompiledProgram kNowhere;
  const Level& level = stack_.level(depth);
  return level.program != nullptr && level.has_arguments() ? *level.program : kNowhere;
}

std::optional<std::string> Runner::run_text(const std::string& source) {
  const CompiledProgram* const program =
      programs_.snippet(source, home(0), CallablePrograms::kCommandLine);
  level().program = level().program == nullptr ? program : level().program;
  const MaybeFailure reason = run_among(*program, 0);
  return reason ? std::optional(why(*reason)) : std::nullopt;
}

std::optional<std::string> Runner::wrong_expression(const std::string& expression) {
  const CompiledProgram* const main = has_run_ ? nullptr : programs_.main_program();
  const CompiledProgram* const program =
      programs_.looked_at(expression, main != nullptr ? *main : home(0));
  if (program->errors.empty()) {
    return std::nullopt;
  }
  const BlockError& error = program->errors.front();
  return why(failure(error.id, error.detail));
}

std::optional<std::string> Runner::why_no_variable(const std::string& name) {
  const CompiledProgram* const program = programs_.looked_at(name, home(0));
  if (!program->errors.empty()) {
    const BlockError& error = program->errors.front();
    return why(failure(error.id, error.detail));
  }
  return program->result.type == Type::Axis
             ? std::optional(fmt::format("it is an axis; where it stands at the start says [start] "
                                         "of a sheet: {} = 5.0",
                                         name))
             : std::nullopt;
}

Result<ShownValue, std::string> Runner::value_of(const std::string& expression) {
  if (const CompiledProgram* const main = has_run_ ? nullptr : programs_.main_program()) {
    start(*main);
  }
  return result_of(*programs_.looked_at(expression, home(0)), 0);
}

Result<ShownValue, std::string> Runner::evaluate(std::size_t level, const std::string& expression) {
  const std::size_t depth = depth_of(level);
  const CompiledProgram*& made = expressions_[{&home(depth), expression}];
  if (made == nullptr) {
    made = programs_.looked_at(expression, home(depth));
  }
  return result_of(*made, depth);
}

/// What the program of one expression comes to, for who looks from outside.
Result<ShownValue, std::string> Runner::result_of(const CompiledProgram& program,
                                                  std::size_t depth) {
  const runtime::LookFromOutside look(channel_.touches);
  const MaybeFailure reason = run_among(program, depth);
  const std::size_t depth_before = stack_.look_at(depth);
  const CompiledProgram* const program_before = std::exchange(level().program, &program);
  operands_.use_level();
  ShownValue shown;
  shown.type = program.result.type;
  if (!reason && shown.type == Type::String) {
    shown.text = operands_.text(program.result.value);
  } else if (!reason && is_held_as_number(shown.type)) {
    shown.number = without_sign_of_zero(operands_.number(program.result.value));
  }
  level().program = program_before;
  stack_.look_at(depth_before);
  if (level().program != nullptr) {
    operands_.use_level();
  }
  if (reason) {
    return why(*reason);
  }
  return shown.type == Type::Frame || shown.type == Type::None
             ? Result<ShownValue, std::string>(std::string("is not a single value"))
             : shown;
}

std::size_t Runner::depth_of(std::size_t level) const {
  return stack_.depth() - std::min(level, stack_.depth());
}

std::vector<std::pair<std::string, ShownValue>> Runner::local_values(std::size_t level) {
  std::vector<std::pair<std::string, ShownValue>> values;
  const std::size_t depth_before = stack_.look_at(depth_of(level));
  const CompiledProgram& program = home(stack_.depth());
  for (std::size_t i = 0; i < program.variables.size(); ++i) {
    const Variable& known = program.variables[i];
    const bool is_of_level = known.storage == Storage::Local || known.storage == Storage::Reference;
    if (!is_of_level || known.type == Type::Frame) {
      continue;
    }
    const VariableView found = operands_.variable(static_cast<std::int32_t>(i));
    Variable shaped = known;
    shaped.shape = found.shape;
    for (std::int32_t element = 0; element < found.shape.count(); ++element) {
      ShownValue value;
      value.type = found.type;
      if (found.texts != nullptr) {
        value.text = found.texts[element];
      } else if (found.numbers != nullptr) {
        value.number =
            without_sign_of_zero(operands_.loaded(found, static_cast<std::size_t>(element)));
      }
      values.emplace_back(element_name(shaped, element), std::move(value));
    }
  }
  stack_.look_at(depth_before);
  return values;
}

}  // namespace g31::sinumerik
