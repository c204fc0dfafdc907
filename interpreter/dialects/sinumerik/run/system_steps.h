#pragma once

#include <string>

#include "interpreter/dialects/sinumerik/run/missed_results.h"
#include "interpreter/dialects/sinumerik/run/operands.h"

namespace g31::sinumerik {

struct SystemAccess;

/// Reads and writes system variables.
class SystemSteps {
 public:
  /// All must outlive it.
  SystemSteps(Operands& operands, Channel& channel, const CallStack& stack, MissedResults& missed)
      : operands_(operands), channel_(channel), stack_(stack), missed_(missed) {}

  MaybeFailure read(const Op& op);
  MaybeFailure write(const Op& op);

 private:
  Result<SystemAccess, Failure> access_of(const Op& op, Arguments indices);

  // By what the functions of the column `work` in system_variables.def give or take.
  MaybeFailure show(const Op& op, const SystemAccess& access, const Result<double, Failure>& value);
  MaybeFailure show(const Op& op, const SystemAccess& access,
                    const Result<std::string, Failure>& value);
  MaybeFailure show(const Op& op, const SystemAccess& access, const Result<Frame, Failure>& value);
  MaybeFailure show(const Op& op, const SystemAccess& access, const Result<Frame*, Failure>& place);
  MaybeFailure set(const SystemAccess& access, const Argument& value,
                   MaybeFailure (*set_number)(Channel&, const SystemAccess&, double));
  MaybeFailure set(const SystemAccess& access, const Argument& value,
                   MaybeFailure (*set_text)(Channel&, const SystemAccess&, const std::string&));
  MaybeFailure set(const SystemAccess& access, const Argument& value,
                   Result<Frame*, Failure> (*find_frame)(Channel&, const SystemAccess&));

  Operands& operands_;
  Channel& channel_;
  const CallStack& stack_;
  MissedResults& missed_;
};

}  // namespace g31::sinumerik
