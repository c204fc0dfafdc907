#include "tools/cli/scene_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/run_options.h"

namespace g31::cli {

CLI::App* add_scene_command(CLI::App& app, SceneOptions& options) {
  CLI::App* const scene = app.add_subcommand(
      "scene", "Run an NC program and write parts, path and contacts as a glTF 2.0 scene.");
  add_program_options(*scene, options.run);
  scene->add_option("-o,--output", options.output, "the scene: a .glb or a .gltf file")
      ->type_name("FILE")
      ->required();
  return scene;
}

std::string scene_examples() {
  return "Examples:\n"
         "  g31 scene measure_ring.nc --setup ring.toml -o ring.glb\n"
         "  g31 scene part.nc -s machine.toml -s fixture.toml -o part.gltf\n"
         "  g31 scene part.mpf --control sinumerik-828d -s machine.toml -o part.glb\n\n";
}

}  // namespace g31::cli
