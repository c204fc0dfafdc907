// A run whose variables nobody watches does not come here.

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/element_name.h"
#include "interpreter/dialects/sinumerik/run/shown_value.h"
#include "interpreter/dialects/sinumerik/run/written_values.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/dialects/sinumerik/vocabulary/frame_components.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {
namespace {

/// Whether the memory of a variable begins at `first` of that of another one and holds its `slot`.
template <typename Held>
bool holds_slot(const Held& held, std::size_t first, const VariableView& in, std::size_t slot) {
  const bool is_of_a_kind = in.type == Type::String
                                ? held.type == Type::String
                                : is_held_as_number(held.type) && is_held_as_number(in.type);
  return is_of_a_kind && slot >= first &&
         slot < first + static_cast<std::size_t>(held.shape.count());
}

}  // namespace

std::vector<WrittenValue> WrittenValues::before(const Op& op) {
  std::vector<WrittenValue> written = written_by(op);
  for (WrittenValue& value : written) {
    value.before = value_now(value, op);
  }
  return written;
}

void WrittenValues::tell(const std::vector<WrittenValue>& written, const Op& op,
                         source::Location where, runtime::BlockListener& listener) {
  for (const WrittenValue& value : written) {
    const runtime::ShownValue now = value_now(value, op);
    if (value.is_assigned || now != value.before) {
      listener.on_write({value.name, value.before, now, where});
    }
  }
}

std::vector<WrittenValue> WrittenValues::written_by(const Op& op) {
  if (is_number_step(op.code)) {
    return written_by_number_step(op);
  }
  if (op.code == OpCode::Store || op.code == OpCode::StoreText) {
    auto one = elements(op.b.place, static_cast<std::int32_t>(operands_.number(op.a)), 1);
    for (WrittenValue& value : one) {
      value.is_assigned = true;
    }
    return one;
  }
  if (op.code == OpCode::Fill || op.code == OpCode::Repeat) {
    return elements(op.a.place, static_cast<std::int32_t>(operands_.number(op.result)),
                    operands_.variable(op.a.place).shape.count());
  }
  if (op.code == OpCode::Procedure || op.code == OpCode::Function) {
    return written_to_arguments(op);
  }
  if (op.code == OpCode::WriteSystem) {
    std::string name = system_name(op);
    return name.empty() ? std::vector<WrittenValue>()
                        : std::vector<WrittenValue>{{std::move(name), {}, 0, true}};
  }
  return {};
}

/// The variable that has its value straight from a step; constants of the compiler have no name.
std::vector<WrittenValue> WrittenValues::written_by_number_step(const Op& op) {
  const bool is_global = op.result.bank == Bank::Globals;
  if (!is_global && op.result.bank != Bank::Locals) {
    return {};
  }
  const std::vector<Variable>& known = operands_.level().program->variables;
  const auto holds = [&](const Variable& one) {
    return is_held_as_number(one.type) &&
           one.storage == (is_global ? Storage::Global : Storage::Local) &&
           op.result.place >= one.place && op.result.place < one.place + one.shape.count();
  };
  const auto found = std::ranges::find_if(known, holds);
  if (found == known.end()) {
    return {};
  }
  auto one =
      elements(static_cast<std::int32_t>(found - known.begin()), op.result.place - found->place, 1);
  one.front().is_assigned = true;
  return one;
}

/// What a procedure or function gets: variables of the program for its results are among them.
std::vector<WrittenValue> WrittenValues::written_to_arguments(const Op& op) {
  std::vector<WrittenValue> all;
  for (const Argument& argument : operands_.arguments_of(op)) {
    std::vector<WrittenValue> given;
    if (argument.form == Argument::Form::Whole) {
      given = elements(argument.variable, 0, operands_.variable(argument.variable).shape.count());
    } else if (argument.form == Argument::Form::Element) {
      given = elements(argument.variable,
                       static_cast<std::int32_t>(operands_.number(argument.element)), 1);
    }
    std::ranges::move(given, std::back_inserter(all));
  }
  return all;
}

/// Some elements of a variable, as far as there are so many, and what is behind them if it is a VAR
/// parameter; frames have no single value.
std::vector<WrittenValue> WrittenValues::elements(std::int32_t which, std::int32_t first,
                                                  std::int32_t count) {
  Variable shaped = operands_.level().program->variables[static_cast<std::size_t>(which)];
  const VariableView in = operands_.variable(which);
  shaped.shape = in.shape;
  std::vector<WrittenValue> all;
  const bool is_shown = in.type != Type::Frame && in.type != Type::None;
  const std::int32_t end = std::min(in.shape.count(), first + count);
  for (std::int32_t i = first; i < end && is_shown; ++i) {
    const auto element = static_cast<std::size_t>(i);
    all.push_back({element_name(shaped, i), in, element});
    if (shaped.storage == Storage::Reference) {
      std::ranges::move(behind(in, element), std::back_inserter(all));
    }
  }
  return all;
}

/// The variable behind an element of a VAR parameter, which is written at once with it, and the VAR
/// parameters of callers that have passed it on.
std::vector<WrittenValue> WrittenValues::behind(const VariableView& in, std::size_t element) const {
  const std::size_t slot = static_cast<std::size_t>(in.place) + in.first + element;
  std::vector<WrittenValue> all;
  const auto add = [&](const Variable& variable, std::size_t first) {
    all.push_back({element_name(variable, static_cast<std::int32_t>(slot - first)), in, element});
  };
  const std::span<const Variable> owners =
      in.is_global ? globals_.variables()
                   : std::span<const Variable>(stack_.level(in.level).own_place().first->variables);
  for (const Variable& variable : owners) {
    const auto first = static_cast<std::size_t>(variable.place);
    if (variable.storage == (in.is_global ? Storage::Global : Storage::Local) &&
        holds_slot(variable, first, in, slot)) {
      add(variable, first);
      break;
    }
  }
  for (std::size_t i = in.is_global ? 0 : in.level + 1; i < stack_.depth(); ++i) {
    const Level& level = stack_.level(i);
    for (Variable passed : level.own_place().first->variables) {
      const auto at = static_cast<std::size_t>(passed.place);
      if (passed.storage != Storage::Reference || at >= level.references.size()) {
        continue;
      }
      const Reference& to = level.references[at];
      const std::size_t first = static_cast<std::size_t>(to.place) + to.first;
      if (to.is_global == in.is_global && (to.is_global || to.level == in.level) &&
          holds_slot(to, first, in, slot)) {
        passed.shape = to.shape;
        add(passed, first);
      }
    }
  }
  return all;
}

/// "$TC_DP6[1,1]"; "" of a whole frame.
std::string WrittenValues::system_name(const Op& op) {
  const SystemVariable& row = system_variables()[static_cast<std::size_t>(op.a.place)];
  const Arguments indices = operands_.arguments_of(op).first(op.count - 1U);
  const bool is_component = row.type == Type::Frame && indices.size() >= 2;
  if (row.type == Type::Frame && !is_component) {
    return {};
  }
  std::vector<std::string> shown_indices;
  for (const Argument& index : indices) {
    const bool is_last = &index == &indices.back();
    const auto given = static_cast<std::size_t>(std::max(operands_.number(index.value), 0.0));
    shown_indices.push_back(is_component && is_last ? std::string(kComponentNames.at(given))
                            : index.type == Type::Axis
                                ? shown(Type::Axis, operands_.number(index.value))
                                : fmt::format("{}", operands_.number(index.value)));
  }
  return fmt::format(
      "{}{}{}", row.name, op.detail > 0 ? std::to_string(op.detail) : "",
      shown_indices.empty() ? "" : fmt::format("[{}]", fmt::join(shown_indices, ",")));
}

/// What the system variable shows that a step writes.
runtime::ShownValue WrittenValues::system_value(const Op& op) {
  const SystemVariable& row = system_variables()[static_cast<std::size_t>(op.a.place)];
  Op reads = op;
  reads.code = OpCode::ReadSystem;
  reads.count = static_cast<std::uint16_t>(op.count - 1);
  reads.result = {Bank::Temporaries, kTemporaryCount - 1};
  const runtime::LookFromOutside look(channel_.touches);
  const MaybeFailure wrong = system_.read(reads);
  if (wrong) {
    return runtime::Cell();
  }
  if (row.type == Type::String) {
    return shown_value({row.type, 0.0, operands_.text(reads.result)});
  }
  const Type type = row.type == Type::Frame ? Type::Real : row.type;
  return shown_value({type, operands_.number(reads.result), {}});
}

runtime::ShownValue WrittenValues::value_now(const WrittenValue& written, const Op& op) {
  if (written.in.type == Type::None) {
    return system_value(op);
  }
  if (written.in.type == Type::String) {
    return shown_value({Type::String, 0.0, written.in.texts[written.element]});
  }
  return shown_value(
      {written.in.type, without_sign_of_zero(operands_.loaded(written.in, written.element)), {}});
}

}  // namespace g31::sinumerik
