#pragma once

#include <string>

#include "tools/cli/scene_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `scene`; parsing fills `options`.
void add_scene_options(CLI::App& scene, SceneOptions& options);

/// Examples for the help text.
std::string scene_examples();

}  // namespace g31::cli
