#include "tools/cli/new_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"

namespace g31::cli {

void add_new_options(CLI::App& command, NewOptions& options) {
  command.add_option("DIR", options.folder, "the folder; it is made where it is missing")
      ->required()
      ->type_name("DIR")
      ->check(why_no_word);
  add_control_option(command, options.control,
                     "what the program is written for (default fanuc-16i): haas, sinumerik-828d, "
                     "0i-MF and so on");
  command.add_option("--json", options.json, "document g31.new/1; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
}

std::string new_examples() {
  return "Examples:\n"
         "  g31 new measuring\n"
         "  g31 new measuring --control sinumerik-828d\n\n"
         "The folder gets measure.nc (MEASURE.MPF), setup.toml, README.md, and for CI "
         ".github/workflows/g31.yml and .gitlab-ci.yml.\n"
         "Where one of them is there already, nothing is changed, and the exit code is 2.\n\n";
}

}  // namespace g31::cli
