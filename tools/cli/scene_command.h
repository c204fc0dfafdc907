#pragma once

#include <string>

#include "tools/cli/exit_code.h"
#include "tools/cli/run_command.h"

namespace g31::cli {

/// What the command line of `g31 scene` says.
struct SceneOptions {
  RunOptions run;
  std::string output;  ///< ends in .glb or .gltf
};

/// Runs a program and writes what happened as a glTF scene: parts, path, contacts, collisions.
///
/// Also of a run that ends in an alarm or a collision, up to there; the exit code is that of the
/// run.  Nothing else is written: no document, no variables file.
ExitCode scene_command(const SceneOptions& options);

}  // namespace g31::cli
