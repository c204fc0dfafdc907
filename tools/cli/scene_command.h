#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "tools/cli/exit_code.h"
#include "tools/cli/run_command.h"

namespace g31::cli {

/// What the command line of `g31 scene` says.
struct SceneOptions {
  RunOptions run;                    ///< with `json`: where the document g31.scene/1 goes
  std::string output;                ///< ends in one of kSceneForms
  std::optional<int> width;          ///< pixels, of a still
  std::optional<std::string> theme;  ///< of a still: light or dark
  bool is_quiet = false;             ///< no progress
};

/// What a scene is written as, by the end of the file's name.
inline constexpr std::array<std::string_view, 4> kSceneForms = {".glb", ".gltf", ".svg", ".png"};

/// Runs a program and writes what happened as a glTF scene or as a still: parts, ways, stylus,
/// contacts, collisions.
///
/// Also of a run that ends in an alarm or a collision, up to there; the exit code is that of the
/// run.  Nothing else is written but the document that --json asks for: how the run ended and what
/// was said of it, whatever happened.
ExitCode scene_command(const SceneOptions& options);

}  // namespace g31::cli
