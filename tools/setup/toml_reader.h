#pragma once

#include <span>
#include <string>

#include "machine/base/result.h"
#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"

namespace g31::setup {

/// Reads set-up sheets and lays later ones over earlier ones, key by key; [[part]] and
/// [[skip_signal]] of a later sheet replace the whole list.
///
/// The machine file that the result names is read first; keys of the sheets win over it.  Relative
/// paths of a sheet start at its folder; those in the Job can be opened as they are.
/// @returns the job, or every error of every sheet, in the order of the files and their lines
/// @param machines_folder  where a machine file is looked for that is not at its place; may be
/// empty
Result<Job, SetupErrors> read_job(std::span<const std::string> sheet_paths,
                                  const std::string& machines_folder = {});

}  // namespace g31::setup
