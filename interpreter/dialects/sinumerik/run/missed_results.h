#pragma once

#include <span>
#include <vector>

#include "interpreter/dialects/sinumerik/run/operands.h"
#include "interpreter/runtime/missed_touches.h"

namespace g31::sinumerik {

/// What becomes of the result of a measuring move without a signal.  A run that owes nothing has
/// only any() asked.
class MissedResults {
 public:
  /// All must outlive it.
  MissedResults(const CallStack& stack, Operands& operands, Channel& channel)
      : stack_(stack), operands_(operands), channel_(channel), missed_(channel.touches.missed) {}

  /// Whether a move without a signal is still unsettled.
  [[nodiscard]] bool any() const { return missed_.any(); }

  /// Says what a step reads and what becomes of it, before it is done.
  void follow(const Op& op);
  /// What a system variable shows is known once it has been read.
  void follow_read(const Op& op);

  /// The variables that a call gives values of, by argument; 0: none that is followed.
  std::vector<runtime::MissedTouches::Holder> holders_given(const CallSite& site,
                                                            const std::vector<BoundValue>& values);
  /// The parameters of the level that has begun hold what the arguments were made of; those that
  /// are taken by reference are the caller's own variables.
  void follow_arguments(const std::vector<runtime::MissedTouches::Holder>& given);

  /// MCALL keeps the values until it calls.
  void keep_for_modal_call(const std::vector<runtime::MissedTouches::Holder>& given);
  /// @param count  of its arguments
  void follow_modal_call(std::size_t count);

  /// The variables of a level, or the results within a block, are gone.
  void forget(std::span<const double> cells);
  /// The end of the program: variables of called ones are nowhere.
  void end();
  /// The program is broken off.
  void break_off();

 private:
  /// Where a number is, the same in every run; 0: a constant.
  [[nodiscard]] runtime::MissedTouches::Holder holder_of(const double& cell) const;
  void follow_function(const Op& op);
  void follow_array(const Op& op);
  void follow_block(const Op& op);
  void read_arguments(Arguments list);
  std::span<const double> cells_of(const Argument& whole);
  const double& element(const Op& op);
  void use_measured();

  const CallStack& stack_;
  Operands& operands_;
  Channel& channel_;
  runtime::MissedTouches& missed_;
  std::vector<runtime::MissedTouches::Reading> of_words_;  ///< of the block
};

}  // namespace g31::sinumerik
