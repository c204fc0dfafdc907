#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/step_machine.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

constexpr std::size_t kLongestText = 400;  // that << makes

}  // namespace

bool StepMachine::text_step(const Op& op) {
  switch (static_cast<TextStep>(op.code)) {
    case TextStep::MoveText:
      text(op.result) = text(op.a);
      return true;
    case TextStep::SetCharacter:
      return set_character(op);
    case TextStep::Concatenate: {
      std::string joined = text(op.a) + text(op.b);
      if (joined.size() > kLongestText) {
        return fault_.keep(AlarmId::ConcatenationTooLong);
      }
      text(op.result) = std::move(joined);
      return true;
    }
    case TextStep::NumberToText:
      text(op.result) = shown(static_cast<Type>(op.detail), number(op.a));
      return true;
    case TextStep::TextToNumber: {
      const std::string& from = text(op.a);
      const bool is_char = static_cast<Type>(op.detail) == Type::Char;
      if (is_char && from.size() != 1) {
        return fault_.keep(AlarmId::BadConversion, fmt::format("\"{}\" is not a CHAR", from));
      }
      number(op.result) =
          is_char ? static_cast<unsigned char>(from.front()) : (from.empty() ? 0.0 : 1.0);
      return true;
    }
    case TextStep::EqualText:
      number(op.result) = text(op.a) == text(op.b) ? 1.0 : 0.0;
      return true;
    case TextStep::LessText:
      number(op.result) = text(op.a) < text(op.b) ? 1.0 : 0.0;
      return true;
    case TextStep::LoadText:
      text(op.result) = variable(op.b.place).texts[static_cast<std::size_t>(number(op.a))];
      return true;
    case TextStep::StoreText:
      return store_text(op);
  }
  contract_violated("other_step() lets only these through", __FILE__, __LINE__);
}

/// One behind the last is a new last one; further behind, the character 0 that ends the text stays
/// in front of it, and nothing is seen of it.
bool StepMachine::set_character(const Op& op) {
  const double place = rounded(number(op.a));
  if (!(place >= 0.0 && place < op.count)) {
    return fault_.keep(AlarmId::IndexOne,
                       fmt::format("[{:.0f}], and a text of {} characters", place, op.count));
  }
  std::string& into = text(op.result);
  const auto at = static_cast<std::size_t>(place);
  const auto given = static_cast<char>(static_cast<unsigned char>(number(op.b)));
  if (at < into.size()) {
    into[at] = given;
  } else if (at == into.size()) {
    into += given;
  }
  return true;
}

bool StepMachine::store_text(const Op& op) {
  const VariableView target = variable(op.b.place);
  std::string value = text(op.result);
  value.resize(std::min(value.find('\0'), value.size()));  // the character 0 ends a text
  if (auto wrong = too_long(value, target.longest)) {
    return fault_.keep(*std::move(wrong));
  }
  target.texts[static_cast<std::size_t>(number(op.a))] = std::move(value);
  return true;
}

bool StepMachine::frame_step(const Op& op) {
  const auto component_of = [&](const Argument& axis, const Argument& component) {
    return std::pair(static_cast<int>(number(axis.value)),
                     static_cast<Component>(static_cast<int>(number(component.value))));
  };
  const auto* const list = stack_.level().program->arguments.data() + op.b.place;
  switch (static_cast<FrameStep>(op.code)) {
    case FrameStep::MoveFrame:
      frame(op.result) = frame(op.a);
      return true;
    case FrameStep::LoadFrame:
      frame(op.result) = variable(op.b.place).frames[static_cast<std::size_t>(number(op.a))];
      return true;
    case FrameStep::StoreFrame:
      variable(op.b.place).frames[static_cast<std::size_t>(number(op.a))] = frame(op.result);
      return true;
    case FrameStep::Chain:
      frame(op.result) = frame(op.a).chained(frame(op.b));
      return frame(op.result).is_within_limits() ||
             fault_.keep(AlarmId::ValueOutOfLimits, "a frame chained of frames");
    case FrameStep::EqualFrame:
      number(op.result) = frame(op.a) == frame(op.b) ? 1.0 : 0.0;
      return true;
    case FrameStep::LoadComponent:
    case FrameStep::StoreComponent: {
      const bool loads = op.code == OpCode::LoadComponent;
      const auto [axis, component] =
          loads ? component_of(list[0], list[1]) : component_of(list[1], list[2]);
      if (!has_frame(axis)) {
        return fault_.keep(AlarmId::BadAxisIndex);
      }
      if (loads) {
        number(op.result) = channel_.shown_component(axis, component, frame(op.a));
        return true;
      }
      MaybeFailure wrong =
          channel_.set_component(axis, component, operands_.number(list[0]), frame(op.result));
      return !wrong || fault_.keep(*std::move(wrong));
    }
  }
  contract_violated("other_step() lets only these through", __FILE__, __LINE__);
}

bool StepMachine::set_element(const VariableView& target, std::int32_t element,
                              const Argument& value) {
  if (element >= target.shape.count()) {
    return fault_.keep(AlarmId::TooManyInitialValues);
  }
  const auto at = static_cast<std::size_t>(element);
  const bool omitted = value.form == Argument::Form::Omitted;
  if (target.type == Type::String) {
    const std::string given = omitted ? std::string() : text(value.value);
    if (auto wrong = too_long(given, target.longest)) {
      return fault_.keep(*std::move(wrong));
    }
    target.texts[at] = given;
  } else if (target.type == Type::Frame) {
    target.frames[at] = omitted ? Frame() : frame(value.value);
  } else {
    return store(target, at, omitted ? initial_number(target.type) : operands_.number(value));
  }
  return true;
}

/// A list: the elements in turn; an omitted value leaves its element alone.
bool StepMachine::fill(const Op& op) {
  const VariableView target = variable(op.a.place);
  auto element = static_cast<std::int32_t>(number(op.result));
  for (const Argument& value : operands_.arguments_of(op)) {
    const bool omitted = value.form == Argument::Form::Omitted;
    if (!omitted && !set_element(target, element, value)) {
      return false;
    }
    ++element;
  }
  return true;
}

/// REP(value, count): without a count to the end of the array.
bool StepMachine::repeat_value(const Op& op) {
  const VariableView target = variable(op.a.place);
  const Arguments list = operands_.arguments_of(op);
  const auto first = static_cast<std::int32_t>(number(op.result));
  const std::int32_t rest = target.shape.count() - first;
  const double wanted = list.size() > 1 ? operands_.number(list[1]) : rest;
  if (wanted < 0.0 || wanted > rest) {
    return fault_.keep(AlarmId::TooManyInitialValues);
  }
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(wanted); ++i) {
    if (!set_element(target, first + i, list[0])) {
      return false;
    }
  }
  return true;
}

}  // namespace g31::sinumerik
