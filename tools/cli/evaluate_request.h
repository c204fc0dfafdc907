#pragma once

#include "machine/base/result.h"
#include "tools/cli/evaluate_command.h"
#include "tools/evaluate/evaluate.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// What the command line asks for; error: what is wrong with it.
Result<evaluate::Request, session::Refusal> evaluate_request(const EvaluateOptions& options);

}  // namespace g31::cli
