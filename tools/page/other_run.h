#pragma once

#include <map>
#include <string>

#include "machine/base/result.h"
#include "tools/setup/job.h"

namespace g31::page {

/// Another run, of which only its document is there.
struct OtherRun {
  std::string figures;                      ///< JSON: the document and what pictures need of it
  std::map<std::string, double> variables;  ///< that the document tells
  bool has_times = true;                    ///< of its moves, so that a time line shows them
};

/// @param document  text of a g31.run/1 with its moves and touches
/// @param job       of the run that is shown: its probe stands for that of the other
/// @returns one line that says what the text lacks
Result<OtherRun, std::string> other_run(const std::string& document, const setup::Job& job);

}  // namespace g31::page
