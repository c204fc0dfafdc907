#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/alarm.h"
#include "interpreter/runtime/cell.h"
#include "interpreter/runtime/interruption.h"
#include "interpreter/runtime/output_budget.h"
#include "interpreter/source/diagnostic.h"

namespace g31::runtime {

/// How a run ended.
enum class Status {
  Completed,
  Alarm,        ///< `alarm` says which
  Collision,    ///< something touched that must not, or a soft limit
  Setup,        ///< the set-up sheet does not fit the program
  Budget,       ///< blocks, time or output spent
  Interrupted,  ///< interrupted
  SyntaxError,  ///< a block that cannot be read; `alarm` says which, or the main program is none
  Defect,       ///< of g31 itself
};

/// Whether the program has broken off by what it did.
constexpr bool breaks_off(Status status) {
  return status == Status::Alarm || status == Status::Collision;
}

/// How long a run may last, and how much it may put out.
struct Budget {
  std::uint64_t blocks = 50'000'000;
  double wall_seconds = 600.0;
  OutputBudget* output = nullptr;              ///< outlives the run; nullptr: no end
  const Interruption* interruption = nullptr;  ///< outlives the run; nullptr: there is none
  /// Is told now and then how many blocks there were; outlives the run; nullptr: nobody.
  const std::function<void(std::uint64_t blocks)>* progress = nullptr;
};

/// What a run left behind.
struct Outcome {
  Status status = Status::Completed;
  std::optional<Alarm> alarm;
  std::vector<source::Diagnostic> diagnostics;  ///< in order; the reason of the end is the last
  std::uint64_t blocks = 0;
};

}  // namespace g31::runtime
