#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/run/call_stack.h"
#include "interpreter/dialects/sinumerik/run/operands.h"
#include "interpreter/dialects/sinumerik/run/system_steps.h"
#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/shown_value.h"

namespace g31::sinumerik {

/// A value that a step may write.
struct WrittenValue {
  std::string name;
  VariableView in;           ///< the variable; of type None: a system variable
  std::size_t element = 0;   ///< of the variable
  bool is_assigned = false;  ///< false: only a change shows that the step has written it
  runtime::ShownValue before = {};
};

/// What steps write, for a listener: it is looked at before a step and behind it.
class WrittenValues {
 public:
  /// All must outlive it.
  WrittenValues(Operands& operands, Channel& channel, SystemSteps& system, const CallStack& stack,
                const Globals& globals)
      : operands_(operands), channel_(channel), system_(system), stack_(stack), globals_(globals) {}

  /// What a step that comes next may write, as it is now.
  std::vector<WrittenValue> before(const Op& op);
  /// Tells what of it the step has written.
  void tell(const std::vector<WrittenValue>& written, const Op& op, source::Location where,
            runtime::BlockListener& listener);

 private:
  std::vector<WrittenValue> written_by(const Op& op);
  std::vector<WrittenValue> written_by_number_step(const Op& op);
  std::vector<WrittenValue> written_to_arguments(const Op& op);
  std::vector<WrittenValue> elements(std::int32_t which, std::int32_t first, std::int32_t count);
  [[nodiscard]] std::vector<WrittenValue> behind(const VariableView& in, std::size_t element) const;
  std::string system_name(const Op& op);
  runtime::ShownValue system_value(const Op& op);
  runtime::ShownValue value_now(const WrittenValue& written, const Op& op);

  Operands& operands_;
  Channel& channel_;
  SystemSteps& system_;
  const CallStack& stack_;
  const Globals& globals_;
};

}  // namespace g31::sinumerik
