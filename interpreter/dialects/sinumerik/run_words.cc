#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/runner.h"

namespace g31::sinumerik {

MaybeFailure Runner::set_word(std::size_t address, BlockWords::Word word) {
  BlockWords::Word& known = words_.words[address];
  if (static_cast<Address>(address) == Address::Machine) {
    if (words_.machine_code_count == BlockWords::kMostMachineCodes) {
      return failure(AlarmId::AddressTooOften, "M");
    }
    words_.machine_codes[words_.machine_code_count++] = word.value;
  } else if (known.present) {
    const std::string name = address < kAxisCount
                                 ? std::string(1, kAxisLetters[address])
                                 : std::string(addresses()[address - kAxisCount].name);
    return failure(AlarmId::AddressRepeated, name);
  }
  known = word;
  known.present = true;
  return std::nullopt;
}

MaybeFailure Runner::take_word(const Op& op) {
  if (op.code == OpCode::TextWord) {
    words_.tool_name = text(op.a);
    return set_word(op.detail, {});
  }
  return set_word(op.detail, {number(op.a), static_cast<Modification>(op.count), true});
}

MaybeFailure Runner::take_axis_word(const Op& op) {
  const double axis = number(op.a);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex);
  }
  return set_word(static_cast<std::size_t>(axis),
                  {number(op.b), static_cast<Modification>(op.count), true});
}

MaybeFailure Runner::execute(const Op& op) {
  const NcBlock& codes = level().program->nc_blocks[static_cast<std::size_t>(op.a.place)];
  const Block block{words_, codes, here()};
  const bool moves = modal_call_ && commands_motion(block);
  MaybeFailure wrong = execute_block(channel_, block);
  words_ = BlockWords();
  if (!wrong && moves) {
    return modal_call();
  }
  return wrong;
}

}  // namespace g31::sinumerik
