#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/word_steps.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
bool WordSteps::set_word(std::size_t address, double value, Modification modification) {
  const auto which = static_cast<Address>(address);
  const int most = most_in_block(which);
  if (words_.words[address].times == most) {
    return fault_.keep(most > 1 ? AlarmId::AddressTooOften : AlarmId::AddressRepeated,
                       std::string(name_of(which)));
  }
  if (const ValueRange range = range_of(which); !range.holds(value)) [[unlikely]] {
    return fault_.keep(out_of_range(name_of(which), value, range));
  }
  if (which == Address::Machine) {
    words_.machine_codes[words_.machine_code_count++] = value;
  }
  words_.set(address, value, modification);
  return true;
}

MaybeFailure WordSteps::take_word(const Op& op) {
  set_word(op.detail, operands_.number(op.a), static_cast<Modification>(op.count));
  return fault_.taken();
}

MaybeFailure WordSteps::take_text_word(const Op& op) {
  words_.tool_name = operands_.text(op.a);
  set_word(op.detail, 0.0);
  return fault_.taken();
}

MaybeFailure WordSteps::take_axis_word(const Op& op) {
  const double axis = operands_.number(op.a);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex);
  }
  const AxisWordInfo& row = info(static_cast<AxisWordId>(op.detail));
  const BlockWords::Word word{operands_.number(op.b), static_cast<Modification>(op.count), true};
  const auto index = static_cast<std::size_t>(axis);
  switch (row.role) {
    case AxisRole::Setting:
    case AxisRole::AxisSetting:
    case AxisRole::Switch:
    case AxisRole::AxisSwitch:
      return take_axis_setting({row.id, static_cast<int>(axis), word.value});
    case AxisRole::Path:
      if (row.id == AxisWordId::CentreOfAxis) {
        return take_centre_of(static_cast<int>(axis), word);
      }
      set_word(index_of(address_of_axis(static_cast<int>(axis))), word.value, word.modification);
      return fault_.taken();
    case AxisRole::Positioning:
      if (words_.positioning[index].present) {
        return failure(AlarmId::AddressRepeated,
                       fmt::format("{}[{}]", row.name, letter_of_axis(static_cast<int>(axis))));
      }
      if (!ValueRange().holds(word.value)) {
        return failure(out_of_range(row.name, word.value, ValueRange()));
      }
      words_.position_axis(index, word);
      return std::nullopt;
    case AxisRole::Measuring:
    case AxisRole::Refused:
      break;
  }
  contract_violated("these are compiled to other steps", __FILE__, __LINE__);
}

/// IP[axis]
MaybeFailure WordSteps::take_centre_of(int axis, const BlockWords::Word& word) {
  if (!is_linear_axis(axis)) {
    return failure(AlarmId::BadAxisIndex, fmt::format("IP[{}]", letter_of_axis(axis)));
  }
  set_word(index_of(Address::CentreX) + static_cast<std::size_t>(axis), word.value,
           word.modification);
  return fault_.taken();
}

MaybeFailure WordSteps::take_axis_setting(const BlockWords::AxisSetting& setting) {
  const AxisWordInfo& row = info(setting.word);
  for (const BlockWords::AxisSetting& known : words_.axis_settings) {
    if (known.word == setting.word && known.axis == setting.axis) {
      return failure(
          AlarmId::AddressRepeated,
          fmt::format("{}[{}]={:g}", row.name, letter_of_axis(setting.axis), setting.value));
    }
  }
  if (MaybeFailure wrong = failure(wrong_axis_setting(row, setting.axis, setting.value))) {
    return wrong;
  }
  words_.axis_settings.push_back(setting);
  return std::nullopt;
}

MaybeFailure WordSteps::take_axis_measuring(const Op& op) {
  const double axis = operands_.number(op.a);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex);
  }
  if (!is_machine_axis(static_cast<int>(axis))) {
    return failure(AlarmId::NotImplemented,
                   fmt::format("{} carries no probe", letter_of_axis(static_cast<int>(axis))));
  }
  const auto index = static_cast<std::size_t>(axis);
  if (op.detail == kSecondTrigger) {
    words_.axis_measuring[index]->second_trigger = operands_.number(op.b);
    return std::nullopt;
  }
  words_.measure_axis(index, {operands_.number(op.result), operands_.number(op.b), op.detail != 0});
  return std::nullopt;
}

MaybeFailure WordSteps::take_spindle_word(const Op& op) {
  const double which = operands_.number(op.a);
  const auto address = static_cast<Address>(op.detail);
  if (which == 0.0 || which == channel_.master_spindle) {
    set_word(op.detail, operands_.number(op.b), static_cast<Modification>(op.count));
    return fault_.taken();
  }
  if (which < 0.0 || which > kMostSpindles) {
    return failure(AlarmId::NoSuchAddress, fmt::format("spindle {:g}", which));
  }
  words_.spindle_words.push_back({static_cast<int>(which), address, operands_.number(op.b),
                                  static_cast<Modification>(op.count)});
  return std::nullopt;
}

MaybeFailure WordSteps::take_group_code(const Op& op) {
  const auto code = find_g_code(operands_.number(op.a), operands_.number(op.b));
  if (!code) {
    return failure(AlarmId::UnknownGCode,
                   fmt::format("G[{:g}]={:g}", operands_.number(op.a), operands_.number(op.b)));
  }
  const GCode& row = g_codes()[code->row];
  if (row.action == GAction::Refused) {
    return failure(AlarmId::NotImplemented, fmt::format("{}, {}", row.name, row.text));
  }
  words_.computed_codes.push_back(packed(*code));
  return std::nullopt;
}

/// Spindle 1 holds the tools, and so does, as 0, the master spindle.
MaybeFailure WordSteps::check_spindle(const Op& op) {
  const double which = operands_.number(op.a);
  return which == 0.0 || which == 1.0
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::NoSuchAddress, fmt::format("spindle {:g}", which)));
}

MaybeFailure WordSteps::take_skip_action(const Op& op) {
  const double probe = operands_.number(op.a);
  if (probe < 1.0 || probe > Channel::kMostProbes) {
    return failure(AlarmId::IndexOne, fmt::format("$A_PROBE[{:.0f}]", probe));
  }
  channel_.skip_action = {static_cast<int>(probe), operands_.number(op.b) != 0.0
                                                       ? machine::SignalEdge::Rising
                                                       : machine::SignalEdge::Falling};
  return std::nullopt;
}

MaybeFailure WordSteps::take_constants(std::span<const ConstantWord> words) {
  for (const ConstantWord& word : words) {
    if (!set_word(index_of(word.address), word.value)) {
      return fault_.taken();
    }
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik
