#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/interruption.h"
#include "interpreter/source/source_map.h"
#include "tools/check/program_paths.h"
#include "tools/session/control.h"

namespace g31::check {

/// What is to be checked.
struct Request {
  ProgramPaths paths;
  std::optional<session::Control> control;  ///< of all; without one each file speaks for itself
  std::vector<std::string> libraries;       ///< folders of subprograms, each without those below
  runtime::ControlSetup setup;              ///< what the sheets say the control knows
  /// Told behind each file of `paths`.
  std::function<void()> file_done = [] {};
  const runtime::Interruption* interruption = nullptr;  ///< looked at behind each file
};

/// The findings of some files, file by file.
struct Findings {
  std::vector<analysis::Finding> found;
  std::vector<std::string> unreadable;  ///< files
};

/// Without what comments of the programs disable (disabled_findings.h).
///
/// Beside those of the files, the findings of definition files that a run would read with them.
/// Looks up what a program calls as a run of it would: in its file, in the other files of its
/// folder that are checked, in those that are named, in its folder, in the libraries, in the
/// folders that are checked with its own, the nearest first, and among the programs shipped with
/// g31.
/// Work that is interrupted has the findings of some of the files.
/// @param sources  gets the files that are read, and so shows where the findings are
Findings check(const Request& request, source::SourceMap& sources);

}  // namespace g31::check
