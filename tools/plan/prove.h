#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "machine/base/result.h"
#include "tools/session/ending.h"
#include "tools/session/prepare.h"
#include "tools/session/refusal.h"
#include "tools/session/world.h"

namespace g31::plan {

/// A run of an inspection program.
struct Proof {
  session::Ending ending = session::Ending::Completed;
  std::string messages;  ///< what the run found, as people read it; "": nothing
  std::string printed;   ///< what it printed, or wrote to its one file
  std::size_t touches = 0;
  double machine_time_s = 0.0;
  std::vector<std::optional<double>> values;  ///< of the variables asked for; nothing: no number
};

/// What is run, and what is asked of it.
struct ProofRequest {
  session::Request run;
  std::vector<std::string> variables;
  std::string other_product;  ///< a file in the place of the last part; "": as the sheet has it
  /// Of that sheet, where they are made already; outlive the run.
  const session::BuiltParts* parts = nullptr;
  const runtime::Interruption* interruption = nullptr;
  std::function<void()> touched = [] {};  ///< called at each touch
};

/// Runs a program against the parts of its sheet; nothing is kept of what it writes.
Result<Proof, session::Refusal> prove(const ProofRequest& request);

}  // namespace g31::plan
