#include "tools/cli/scene_options.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/run_options.h"
#include "tools/picture/still.h"

namespace g31::cli {

void add_scene_options(CLI::App& scene, SceneOptions& options) {
  add_program_options(scene, options.run);
  scene
      .add_option("-o,--output", options.output,
                  "a .glb or .gltf file: a scene for any viewer; a .svg or .png file: a "
                  "picture for documents (.png needs rsvg-convert, Debian: librsvg2-bin)")
      ->type_name("FILE")
      ->required();
  scene
      .add_option("--json", options.run.json,
                  "how the run ended, as a document g31.scene/1; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  scene.add_option("--width", options.width, "of a picture, pixels")
      ->type_name("PX")
      ->transform(whole_number(picture::kLeastStillPixels, picture::kMostStillPixels))
      ->default_str(std::to_string(picture::StillLook{}.width));
  scene.add_option("--theme", options.theme, "of a picture: light or dark")
      ->type_name("THEME")
      ->check(CLI::IsMember(std::vector<std::string>{"light", "dark"}))
      ->default_str("light");
  add_quiet_option(scene, options.is_quiet);
}

std::string scene_examples() {
  return "A scene of a machine with rotary axes is in coordinates of the part: of each touch, "
         "extras have\n"
         "contact_mm there, and machine_contact_mm in those of the machine, where documents of "
         "runs have it.\n\n"
         "Examples:\n"
         "  g31 scene measure_ring.nc --setup ring.toml -o ring.glb\n"
         "  g31 scene part.nc -s machine.toml -s fixture.toml -o part.gltf\n"
         "  g31 scene part.nc -s machine.toml -o part.svg --width 1600 --theme dark\n"
         "  g31 scene part.nc -s machine.toml -o part.svg --json part.json\n"
         "  g31 scene part.mpf --control sinumerik-828d -s machine.toml -o part.glb\n\n";
}

}  // namespace g31::cli
