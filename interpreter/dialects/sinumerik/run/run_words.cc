#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/runner.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {

bool Runner::set_word(std::size_t address, double value, Modification modification) {
  const auto which = static_cast<Address>(address);
  const int most = most_in_block(which);
  if (words_.words[address].times == most) {
    return failed(most > 1 ? AlarmId::AddressTooOften : AlarmId::AddressRepeated,
                  std::string(name_of(which)));
  }
  if (which == Address::Machine) {
    words_.machine_codes[words_.machine_code_count++] = value;
  }
  words_.set(address, value, modification);
  return true;
}

MaybeFailure Runner::take_word(const Op& op) {
  set_word(op.detail, number(op.a), static_cast<Modification>(op.count));
  return from_step();
}

MaybeFailure Runner::take_text_word(const Op& op) {
  words_.tool_name = text(op.a);
  set_word(op.detail, 0.0);
  return from_step();
}

MaybeFailure Runner::take_axis_word(const Op& op) {
  const double axis = number(op.a);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex);
  }
  const AxisWordInfo& row = info(static_cast<AxisWordId>(op.detail));
  const BlockWords::Word word{number(op.b), static_cast<Modification>(op.count), true};
  const auto index = static_cast<std::size_t>(axis);
  switch (row.role) {
    case AxisRole::Setting:
    case AxisRole::AxisSetting:
      return take_axis_setting({row.id, static_cast<int>(axis), word.value});
    case AxisRole::Path:
      set_word(index, word.value, word.modification);
      return from_step();
    case AxisRole::Positioning:
      if (words_.positioning[index].present) {
        return failure(AlarmId::AddressRepeated,
                       fmt::format("{}[{}]", row.name, kAxisLetters[index]));
      }
      words_.position_axis(index, word);
      return std::nullopt;
    case AxisRole::Measuring:
    case AxisRole::Refused:
      break;
  }
  contract_violated("these are compiled to other steps", __FILE__, __LINE__);
}

MaybeFailure Runner::take_axis_setting(const BlockWords::AxisSetting& setting) {
  const AxisWordInfo& row = info(setting.word);
  const std::string shown = fmt::format(
      "{}[{}]={:g}", row.name,
      setting.axis == kSpindleAxis ? 'S' : kAxisLetters[static_cast<std::size_t>(setting.axis)],
      setting.value);
  for (const BlockWords::AxisSetting& known : words_.axis_settings) {
    if (known.word == setting.word && known.axis == setting.axis) {
      return failure(AlarmId::AddressRepeated, shown);
    }
  }
  if (setting.word == AxisWordId::AxisFeed && setting.value < 0.0) {
    return failure(AlarmId::NegativeAxisFeed, shown);
  }
  if (setting.value < row.least || setting.value > row.most) {
    return failure(AlarmId::ValueOutOfLimits,
                   fmt::format("{}: {:g} to {:g}", shown, row.least, row.most));
  }
  words_.axis_settings.push_back(setting);
  return std::nullopt;
}

MaybeFailure Runner::take_axis_measuring(const Op& op) {
  const double axis = number(op.a);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex);
  }
  words_.measure_axis(static_cast<std::size_t>(axis),
                      {number(op.result), number(op.b), op.detail != 0});
  return std::nullopt;
}

/// Spindle 1, or 0 for the master spindle, which it is.
MaybeFailure Runner::check_spindle(const Op& op) {
  const double which = number(op.a);
  return which == 0.0 || which == 1.0
             ? std::nullopt
             : std::optional(failure(AlarmId::NoSuchAddress, fmt::format("spindle {:g}", which)));
}

MaybeFailure Runner::take_skip_action(const Op& op) {
  const double probe = number(op.a);
  if (probe < 1.0 || probe > Channel::kMostProbes) {
    return failure(AlarmId::IndexOne, fmt::format("$A_PROBE[{:.0f}]", probe));
  }
  channel_.skip_action = {static_cast<int>(probe), number(op.b) != 0.0
                                                       ? machine::SignalEdge::Rising
                                                       : machine::SignalEdge::Falling};
  return std::nullopt;
}

MaybeFailure Runner::execute(const Op& op) {
  const CompiledProgram& program = *level().program;
  const NcBlock& block = program.nc_blocks[static_cast<std::size_t>(op.b.place)];
  for (const ConstantWord& word : block.words_of(program)) {
    if (!set_word(index_of(word.address), word.value)) {
      return from_step();
    }
  }
  const Block commands{words_, block.codes_of(program), here()};
  const bool moves = modal_call_ && commands_motion(commands);
  MaybeFailure wrong = execute_block(channel_, commands);
  words_.clear();
  if (!wrong && moves && !channel_.held_line) {
    return modal_call();
  }
  return wrong;
}

}  // namespace g31::sinumerik
