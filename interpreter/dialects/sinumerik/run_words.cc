#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/runner.h"

namespace g31::sinumerik {

bool Runner::set_word(std::size_t address, BlockWords::Word word) {
  const auto which = static_cast<Address>(address);
  const int most = most_in_block(which);
  if (words_.words[address].times == most) {
    return failed(most > 1 ? AlarmId::AddressTooOften : AlarmId::AddressRepeated,
                  std::string(name_of(which)));
  }
  if (which == Address::Machine) {
    words_.machine_codes[words_.machine_code_count++] = word.value;
  }
  words_.set(address, word);
  return true;
}

MaybeFailure Runner::take_word(const Op& op) {
  if (op.code == OpCode::TextWord) {
    words_.tool_name = text(op.a);
    set_word(op.detail, {});
  } else {
    set_word(op.detail, {number(op.a), static_cast<Modification>(op.count), true});
  }
  return from_step();
}

MaybeFailure Runner::take_axis_word(const Op& op) {
  const double axis = number(op.a);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex);
  }
  set_word(static_cast<std::size_t>(axis),
           {number(op.b), static_cast<Modification>(op.count), true});
  return from_step();
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
    if (!set_word(index_of(word.address), {word.value})) {
      return from_step();
    }
  }
  const Block commands{words_, block.codes_of(program), here()};
  const bool moves = modal_call_ && commands_motion(commands);
  MaybeFailure wrong = execute_block(channel_, commands);
  words_.clear();
  if (!wrong && moves) {
    return modal_call();
  }
  return wrong;
}

}  // namespace g31::sinumerik
