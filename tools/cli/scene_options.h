#pragma once

#include <string>

#include "tools/cli/scene_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `scene` and its options; parsing fills `options`.
CLI::App* add_scene_command(CLI::App& app, SceneOptions& options);

/// Examples for the help text.
std::string scene_examples();

}  // namespace g31::cli
