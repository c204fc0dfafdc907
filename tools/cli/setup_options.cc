#include "tools/cli/setup_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/output_places.h"

namespace g31::cli {

void add_setup_options(CLI::App& setup, SetupOptions& options) {
  setup.add_option("SHEET", options.setups, "set-up sheets (TOML); later ones win key by key")
      ->required()
      ->type_name("FILE");
  setup
      .add_option("--program", options.programs,
                  "the program that the sheets are for; it is followed on a machine without parts")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_control_option(setup, options.control, "control profile, instead of the sheet's");
  setup
      .add_option("--lib", options.libraries,
                  "folder of subprograms, with those below it; repeatable")
      ->type_name("DIR")
      ->allow_extra_args(false);
  setup.add_option("--json", options.json, "document g31.setup/1; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  add_fail_on_option(
      setup, options.fail_on,
      "lowest level at which a finding gives exit code 1: error, warning (default), note");
}

std::string setup_examples() {
  return "Examples:\n"
         "  g31 setup ring.toml\n"
         "  g31 setup machine.toml part.toml --program O6001.nc\n"
         "  g31 setup ring.toml --program measure_ring.nc --json -\n\n"
         "Findings go to standard output, each with its place and its code (g31 explain CODE).  "
         "With\n"
         "--program the blocks are followed where nothing can be touched: missing tools and "
         "offsets are\n"
         "found, and parts that no measuring move comes near.  Nothing is written.\n\n";
}

}  // namespace g31::cli
