#include "tools/cli/view_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/report_options.h"
#include "tools/cli/run_options.h"

namespace g31::cli {

void add_view_options(CLI::App& view, ViewOptions& options) {
  constexpr int kLastPort = 65535;
  add_program_options(view, options.run);
  add_expect_option(view, options.run);
  add_language_option(view, options.run.language);
  view.add_option("--port", options.port, "of 127.0.0.1; 0, the default: any that is free")
      ->type_name("N")
      ->transform(whole_number(0, kLastPort));
  view.add_option("--json", options.json,
                  "document g31.view/1, which has the address; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
}

std::string view_examples() {
  return "Examples:\n"
         "  g31 view measure_ring.nc --setup ring.toml\n"
         "  g31 view part.mpf --control sinumerik-828d -s machine.toml --lang ja\n"
         "  g31 view part.nc -s machine.toml --expect '#160=19.998+-0.001' --port 8031\n\n"
         "Open the address that it prints.  Save the program, a sheet, a subprogram or a part in\n"
         "your editor: the page is new at once; what is wrong shows there, too.  Only this\n"
         "computer is answered, and only with the token of the address.  Nothing else is written,\n"
         "no variables file either.  Ctrl-C ends it, with exit code 130.\n\n";
}

}  // namespace g31::cli
