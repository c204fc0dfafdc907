#include "tools/cli/evaluate_options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/report_options.h"

namespace g31::cli {

namespace {

void add_limits(CLI::App& command, EvaluateOptions& options) {
  command.add_option("--max-time", options.max_time_s, "wall seconds (default 600)")
      ->type_name("S")
      ->check(why_no_time);
  add_max_output(command, options.max_output, "all files that are written, together");
}

}  // namespace

void add_evaluate_options(CLI::App& command, EvaluateOptions& options) {
  command.add_option("KIND", options.kind, "what to evaluate, see below")->required();
  command
      .add_option("FILE", options.file,
                  "CSV with a line of column names, of 256 MB at most; g31 run --trace writes "
                  "such files")
      ->type_name("FILE")
      ->required();
  command.add_option("--json", options.json, "the results as a document; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  command.add_flag("--curves", options.has_curves, "every curve into the document");
  command.add_option("--svg", options.svg, "a drawing")->type_name("FILE")->check(why_no_place);
  add_report_options(command, options.report, options.language);
  give_drawing_language(command);
  command
      .add_option("--magnify", options.magnify,
                  "how many times a drawn circle or square enlarges its errors; 1 is true size")
      ->type_name("V")
      ->check(why_no_word);
  command
      .add_option("--columns", options.columns,
                  "what the file calls its columns, for example X=x_act,Y=y_act")
      ->type_name("NAME=COLUMN,...")
      ->allow_extra_args(false);
  command
      .add_option("--unit", options.unit,
                  "unit of the file's lengths: mm (default), um, nm, m, inch")
      ->type_name("UNIT")
      ->check(why_no_word);
  add_limits(command, options);
  for (const evaluate::OptionRow& row : evaluate::options()) {
    command
        .add_option_function<std::string>(
            std::string(row.option),
            [&options, id = row.id](const std::string& value) { options.given[id] = value; },
            fmt::format("{} ({})", row.text, row.kinds))
        ->type_name(std::string(row.value))
        ->check(why_no_word);
  }
  add_quiet_option(command, options.is_quiet);
}

std::string evaluate_examples() {
  std::string text = "Kinds, and the columns of their files (lengths in mm, t in s):\n";
  for (const evaluate::KindRow& row : evaluate::kinds()) {
    text += fmt::format("  {:<14} {:<22} {}\n", row.word, row.columns, row.text);
  }
  return text +
         "A trace of g31 run serves as it is: time_s counts as t, X_true as X where there is no "
         "X.\n\n"
         "Examples:\n"
         "  g31 run circle.nc -s machine.toml --trace circle.csv\n"
         "  g31 evaluate circle circle.csv --radius 50 --svg circle.svg --magnify 1000\n"
         "  g31 evaluate circle scale.csv --columns X=x_act,Y=y_act --unit um --interval 182.32us\n"
         "  g31 evaluate square square.csv --side 100 --json square.json\n"
         "  g31 evaluate diagonal scale.csv --target 50,50 --on 300\n"
         "  g31 evaluate straightness bed.csv --step 100 --sense gap --unit um --compensation "
         "bed.toml\n"
         "  g31 evaluate cylindricity shaft.csv --step 30 --diameters ends.csv\n"
         "  g31 evaluate positioning x.csv\n"
         "  g31 evaluate circle circle.csv --columns X=X_encoder,Y=Y_encoder --json -\n\n";
}

}  // namespace g31::cli
