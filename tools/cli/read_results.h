#pragma once

#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/cli/judge_command.h"
#include "tools/disk/disk.h"
#include "tools/plan/measures.h"
#include "tools/plan/printed_results.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// What a program printed: of a file, of standard input, or as it comes on a serial line, there
/// until every measure has a value or nothing came for a while.
Result<plan::PrintedResults, session::Refusal> read_results(
    const JudgeOptions& options, const std::vector<plan::Measure>& measures, disk::Disk& disk);

}  // namespace g31::cli
