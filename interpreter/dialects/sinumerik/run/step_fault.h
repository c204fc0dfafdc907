#pragma once

#include <optional>
#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/value_limits.h"
#include "interpreter/dialects/sinumerik/state/failure.h"

namespace g31::sinumerik {

/// Why a step failed.  Steps say only whether they did: a reason is too large to hand about.
class StepFault {
 public:
  /// Keeps the reason; @returns false, for the way out.
  bool keep(AlarmId id, std::string detail = {}) { return keep(failure(id, std::move(detail))); }
  bool keep(WrongValue wrong) { return keep(failure(std::move(wrong))); }
  bool keep(Failure reason) {
    reason_ = std::move(reason);
    return false;
  }
  [[nodiscard]] bool is_there() const { return reason_.has_value(); }
  /// The reason, if there is one, which goes.
  MaybeFailure taken() { return std::exchange(reason_, std::nullopt); }

 private:
  MaybeFailure reason_;
};

}  // namespace g31::sinumerik
