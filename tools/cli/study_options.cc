#include "tools/cli/study_options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/report_options.h"
#include "tools/setup/check_value.h"
#include "tools/study/study.h"
#include "tools/study/study_keys.h"

namespace g31::cli {

void add_study_options(CLI::App& study, StudyOptions& options) {
  study.add_option("STUDY", options.study, "the study file (TOML)")->type_name("FILE");
  study.add_option("--json", options.json, "the study as a document; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  study.add_option("--csv", options.csv, "one line for each run; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  study
      .add_option("--svg", options.svg,
                  "the drawing of [evaluation]; of several runs FILE-1.svg, FILE-2.svg and so on")
      ->type_name("FILE")
      ->check(why_no_place);
  add_report_options(study, options.report, options.language);
  give_drawing_language(study);
  study
      .add_option("--threads", options.threads,
                  "threads; the same bytes with any number (default: one a core)")
      ->type_name("N")
      ->transform(whole_number(1, 1024));
  study.add_option("--repeats", options.repeats, "in the place of the study's own number")
      ->type_name("N")
      ->transform(whole_number(1, study::kMostRuns));
  study.add_option("--seed", options.seed, "in the place of the study's own seed")
      ->type_name("N")
      ->transform(whole_number(0, setup::kLargestExact));
  study.add_option("--shard", options.shard, "do part i of n only; --json takes it for --merge")
      ->type_name("i/n")
      ->check(why_no_word);
  study.add_option("--merge", options.merge, "put the shards together instead of running")
      ->type_name("FILE...");
  add_quiet_option(study, options.is_quiet);
}

std::string study_examples() {
  std::string text =
      "Examples:\n"
      "  g31 study parts/library/ring_gauge/table_3.toml\n"
      "  g31 study parts/library/path_accuracy/figure_10.toml --svg figure_10.svg\n"
      "  g31 study ring.toml --json ring.json --csv runs.csv --threads 2\n"
      "  g31 study ring.toml --shard 3/8 --json part-3.json\n"
      "  g31 study --merge part-*.json --json ring.json\n"
      "  g31 study hole.toml   (program = \"hole.mpf\", [results.diameter] value = \"_OVR[4]\")\n\n"
      "Keys of a study file (a value behind the text is what it is if not given):\n";
  for (const study::StudySectionRow& section : study::study_sections()) {
    text += fmt::format("  {:<22} {}\n", section.example, section.text);
    for (const study::StudyKeyRow& row : study::study_keys()) {
      if (row.section == section.id) {
        text += fmt::format("    {:<20} {}; {}\n", row.name, row.text,
                            row.default_text.empty() ? "has to be given" : row.default_text);
      }
    }
  }
  return text + "\n";
}

}  // namespace g31::cli
