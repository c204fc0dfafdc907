#include "tools/cli/check_options.h"

#include <map>

#include <CLI/CLI.hpp>

#include "tools/cli/control_and_level_options.h"
#include "tools/cli/output_places.h"

namespace g31::cli {
namespace {

const std::map<std::string, CheckOptions::Format> kFormats = {
    {"text", CheckOptions::Format::Text},
    {"json", CheckOptions::Format::Json},
    {"sarif", CheckOptions::Format::Sarif},
    {"github", CheckOptions::Format::Github},
};

/// Takes the names of a map, and says them when another comes.
template <typename Value>
void add_choice(CLI::App& command, const std::string& name, Value& value,
                const std::map<std::string, Value>& choices, const std::string& text) {
  std::vector<std::string> names;
  for (const auto& [known, meaning] : choices) {
    names.push_back(known);
  }
  command
      .add_option_function<std::string>(
          name, [&value, &choices](const std::string& given) { value = choices.at(given); }, text)
      ->check(CLI::IsMember(names))
      ->type_name("NAME");
}

}  // namespace

void add_check_options(CLI::App& check, CheckOptions& options) {
  auto* const files =
      check
          .add_option("FILE", options.files,
                      "programs, or folders of them with all folders below; - is standard input")
          ->type_name("FILE");
  check
      .add_option("-s,--setup", options.setups,
                  "set-up sheet (TOML) whose control, data and axes programs may name; repeatable, "
                  "later ones win key by key")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_control_option(check, options.control,
                     "control profile of all programs; without it as the sheet says, else by file "
                     "ending and content");
  check
      .add_option("--lib", options.libraries,
                  "folder of subprograms, with those below it; repeatable")
      ->type_name("DIR")
      ->allow_extra_args(false);
  add_choice(check, "--format", options.format, kFormats,
             "text (default), json (the document), sarif (SARIF 2.1.0), github (annotations)");
  check.add_option("--json", options.json, "document g31.check/1; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  check
      .add_option("--baseline", options.baseline,
                  "earlier document of this command: its findings (rule, file, text of the line) "
                  "are left out")
      ->type_name("FILE");
  check
      .add_option("--disable", options.disabled,
                  "leave out findings of this rule; repeatable; in a program "
                  "(g31: disable=NC003 reason) or ; g31: disable=NC003 reason")
      ->type_name("RULE")
      ->allow_extra_args(false);
  add_fail_on_option(
      check, options.fail_on,
      "lowest level at which a finding gives exit code 1: error, warning (default), note");
  auto* const rules = check.add_flag("--rules", options.lists_rules, "list the rules");
  check.callback([files, rules] {
    if (files->empty() && rules->empty()) {
      throw CLI::RequiredError("FILE or --rules");
    }
  });
  add_quiet_option(check, options.is_quiet);
}

std::string check_examples() {
  return "Examples:\n"
         "  g31 check O6001.nc\n"
         "  g31 check programs/ --lib macros --control fanuc-30i\n"
         "  g31 check *.MPF *.SPF --json findings.json\n"
         "  g31 check archive.arc --setup machine.toml\n"
         "  g31 check programs/ --format github --fail-on error\n"
         "  g31 check programs/ --json known.json; g31 check programs/ --baseline known.json\n"
         "  g31 check programs/ --format sarif > findings.sarif\n"
         "  g31 check - < part.nc\n"
         "  g31 check --rules\n\n"
         "In a folder files named O1234 or *.nc, .cnc, .tap, .eia, .iso, .ncc, .min, .mpf, .spf "
         "and\n"
         ".arc are programs, and texts that begin with % and O1234 or with %_N_.\n"
         "Findings go to standard output, each with its place and its rule.  Subprograms are "
         "looked\n"
         "up in the file, beside it, in the other files named, in --lib, in the other folders "
         "below\n"
         "one that is named (the nearest first; never in other workpieces, *.WPD, of a SINUMERIK)\n"
         "and among those that come with g31.  Words of a G code that the sheet makes a macro "
         "call\n"
         "are its arguments, those of an M code are taken as they are.  A comment disables rules "
         "for\n"
         "its own line; alone on a line for the next block; before the first block for the "
         "file.\n\n";
}

}  // namespace g31::cli
