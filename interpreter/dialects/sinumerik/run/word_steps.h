#pragma once

#include "interpreter/dialects/sinumerik/code/word_limits.h"
#include "interpreter/dialects/sinumerik/run/operands.h"
#include "interpreter/dialects/sinumerik/run/step_fault.h"

namespace g31::sinumerik {

/// Collects the words of an NC block.
class WordSteps {
 public:
  /// Both must outlive it.
  WordSteps(Operands& operands, Channel& channel) : operands_(operands), channel_(channel) {}

  /// Of the running block, as far as they have come.
  BlockWords& words() { return words_; }

  MaybeFailure take_word(const Op& op);
  MaybeFailure take_text_word(const Op& op);
  MaybeFailure take_axis_word(const Op& op);
  MaybeFailure take_axis_measuring(const Op& op);
  MaybeFailure check_spindle(const Op& op);
  MaybeFailure take_spindle_word(const Op& op);
  MaybeFailure take_group_code(const Op& op);
  MaybeFailure take_skip_action(const Op& op);
  /// Those of a block that are plain numbers.
  MaybeFailure take_constants(std::span<const ConstantWord> words);

 private:
  MaybeFailure take_centre_of(int axis, const BlockWords::Word& word);
  MaybeFailure take_axis_setting(const BlockWords::AxisSetting& setting);
  bool set_word(std::size_t address, double value, Modification modification = Modification::None);

  Operands& operands_;
  Channel& channel_;
  BlockWords words_;
  StepFault fault_;
};

}  // namespace g31::sinumerik
