#include "tools/cli/plan_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/report_options.h"

namespace g31::cli {

void add_plan_options(CLI::App& command, PlanOptions& options) {
  command.add_option("PRODUCT", options.product, "the part: a STEP file, or a mesh")
      ->type_name("FILE")
      ->required();
  command
      .add_option(
          "--stock", options.stock,
          "what the part is cut from: a STEP file or a mesh; X,Y,Z: a block of these sizes, "
          "centred on the part in X and Y and standing on its lower face; box: the block "
          "around the part")
      ->type_name("STOCK")
      ->check(why_no_word)
      ->required();
  command
      .add_option("-o,--output", options.folder,
                  "the folder that gets plan.json, the program, setup.toml and plan.html")
      ->type_name("DIR")
      ->check(why_no_word)
      ->required();
  command.add_option("--control", options.control, "the control that the program is for")
      ->type_name("NAME")
      ->check(why_no_word);
  command
      .add_option("-s,--setup", options.setup,
                  "a sheet with machine, probe, fixtures and [work_offsets.G54], in which the "
                  "part's origin is to lie; its parts are fixtures (fixture = true)")
      ->type_name("SHEET")
      ->check(why_no_word);
  constexpr double kLeastMm = 1e-5;
  constexpr double kMostMm = 1000.0;
  command
      .add_option(
          "--tolerance", options.tolerance_mm,
          "of every measure whose size the model does not state itself (AP242), mm: what deviates "
          "by up to T either way is good")
      ->type_name("T")
      ->check(number_range(kLeastMm, kMostMm));
  command
      .add_option("--as-machined", options.as_machined,
                  "another file of the part, on which the program is run as well; plan.json has "
                  "the judgement")
      ->type_name("FILE")
      ->check(why_no_word);
  command.add_flag("--point-by-point", options.by_points,
                   "single touches of holes and bosses, too, in place of the control's own cycles, "
                   "O9010 (G100) and CYCLE977");
  command.add_option("--json", options.json, "what plan.json says; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  add_language_option(command, options.language);
  add_quiet_option(command, options.is_quiet);
}

std::string plan_examples() {
  return "Holes and bosses are measured by the control's own cycles where these fit: O9010, the "
         "macro of G100 (load it into the control), or CYCLE977, with the calibration of the "
         "sheet.\n"
         "The exit code is 1 where anything is not measured (plan.json says why), or comes out of "
         "tolerance on the part as drawn; what is out of tolerance on the part as machined is in "
         "plan.json.\n\n"
         "Examples:\n"
         "  g31 plan product.step --stock box -o inspection\n"
         "  g31 plan product.step --stock stock.step -o inspection --control 828D --tolerance "
         "0.05\n"
         "  g31 plan product.step --stock 160,110,40 -o inspection --as-machined machined.step\n"
         "  g31 run inspection/inspect.nc -s inspection/setup.toml --printer results.txt\n"
         "  g31 judge inspection/plan.json results.txt\n\n";
}

}  // namespace g31::cli
