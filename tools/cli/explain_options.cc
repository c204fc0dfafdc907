#include "tools/cli/explain_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/limit_options.h"

namespace g31::cli {

bool is_file_of_explain(const std::string& word) {
  return word == "-" || word.ends_with(".json");
}

namespace {

/// --json alone is followed by topics, so its file behind it is known by its ending, which no topic
/// has.
void take_file_of_json(ExplainOptions& options) {
  const auto file = std::ranges::find_if(options.topics, is_file_of_explain);
  if (options.json == "-" && file != options.topics.end()) {
    options.json = *file;
    options.topics.erase(file);
  }
}

}  // namespace

void add_explain_options(CLI::App& explain, ExplainOptions& options) {
  explain
      .add_option("TOPIC", options.topics,
                  "#5061, #100-#149, G31, M98, ATAN, GOTO, PS0112, 'alarm 112', 6001.1, haas; of "
                  "a SINUMERIK $AA_MW, CYCLE977, _OVR[4], 61301, 55630; [probe], part.at, ring, "
                  "PRB301, SET103, 'exit 4'; skip, 'ball diameter'")
      ->check(why_no_word);
  auto* const all = explain.add_flag("--all", options.all, "everything that the control has");
  explain.add_flag("--search", options.search,
                   "list what has the words in its text, also where something is named so");
  add_control_option(
      explain, options.control,
      "control profile (default fanuc-16i; what it does not know is looked for in the others)");
  explain.add_flag(
      "--json{-}", options.json,
      "document g31.explain/1, to FILE behind it where that ends in .json, or by --json=FILE; "
      "else, and with -, to standard output");
  auto* const page =
      explain.add_option("--page", options.page,
                         "print a page of docs as the tables make it: set-up-sheet.md, "
                         "codes.md, reference/cycles.md, ...; of an unknown name all are listed");
  page->type_name("NAME")->excludes("--json");
  explain.callback([&options, all, page] {
    take_file_of_json(options);
    if (options.topics.empty() && all->empty() && page->empty()) {
      throw CLI::RequiredError("TOPIC, --all or --page");
    }
  });
}

std::string explain_examples() {
  return "Examples:\n"
         "  g31 explain '#5063' --control haas\n"
         "  g31 explain G31 'alarm 115' 6001.1\n"
         "  g31 explain '[probe]' part.at ring 'exit 4' 0i-MF\n"
         "  g31 explain skip 'ball diameter'\n"
         "  g31 explain --page set-up-sheet.md > docs/set-up-sheet.md\n"
         "  g31 explain --all --control fanuc-30i --json\n"
         "  g31 explain CYCLE977 '_OVR[4]' 61301 --control sinumerik-828d\n\n";
}

}  // namespace g31::cli
