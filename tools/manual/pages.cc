#include "tools/manual/pages.h"

#include <array>

#include <fmt/format.h>

#include "tools/manual/entries.h"
#include "tools/manual/markdown.h"
#include "tools/manual/reference_pages.h"
#include "tools/study/study_keys.h"

namespace g31::manual {
namespace {

constexpr auto kPages = std::to_array<Page>({
    {"set-up-sheet.md", "every key of a set-up sheet, every shape, units, errors", sheet_page},
    {"schema/g31.sheet.schema.json", "JSON Schema of set-up sheets, for editors", sheet_schema},
    {"study-file.md", "every key of a study file", study_page},
    {"codes.md", "every code of a message", codes_page},
    {"not-simulated.md", "what of world and controls is not there", not_simulated_page},
    {"reference/controls.md", "what controls have otherwise", controls_page},
    {"reference/rules.md", "every rule of g31 check", rules_page},
    {"reference/cycles.md", "measuring cycles, other cycles, macros", cycles_page},
    {"reference/fanuc-variables.md", "every variable of Fanuc controls",
     [] { return reference_page("reference/fanuc-variables.md"); }},
    {"reference/fanuc-g-codes.md", "every G and M code",
     [] { return reference_page("reference/fanuc-g-codes.md"); }},
    {"reference/fanuc-language.md", "every function and statement",
     [] { return reference_page("reference/fanuc-language.md"); }},
    {"reference/fanuc-parameters.md", "every parameter",
     [] { return reference_page("reference/fanuc-parameters.md"); }},
    {"reference/fanuc-alarms.md", "every alarm",
     [] { return reference_page("reference/fanuc-alarms.md"); }},
    {"reference/sinumerik-variables.md", "every variable of the SINUMERIK",
     [] { return reference_page("reference/sinumerik-variables.md"); }},
    {"reference/sinumerik-g-codes.md", "every G code",
     [] { return reference_page("reference/sinumerik-g-codes.md"); }},
    {"reference/sinumerik-language.md", "every word of the language",
     [] { return reference_page("reference/sinumerik-language.md"); }},
    {"reference/machine-data.md", "every machine and setting datum",
     [] { return reference_page("reference/machine-data.md"); }},
    {"reference/measuring-data.md", "every variable of the measuring cycles",
     [] { return reference_page("reference/measuring-data.md"); }},
    {"reference/sinumerik-alarms.md", "every alarm",
     [] { return reference_page("reference/sinumerik-alarms.md"); }},
});

std::string fact_of(const runtime::Entry& entry, std::string_view name) {
  for (const runtime::Fact& fact : entry.facts) {
    if (fact.name == name) {
      return fact.value;
    }
  }
  return "";
}

}  // namespace

std::span<const Page> pages() {
  return kPages;
}

std::string study_page() {
  std::string page = page_head("Study files", "study-file.md");
  page +=
      "`g31 study FILE.toml` runs a program many times; the [tutorial for "
      "researchers](tutorials/researcher.md) shows how.  Relative paths start at the study's "
      "folder.\n";
  for (const study::StudySectionRow& section : study::study_sections()) {
    page += fmt::format("\n## {}\n\n{}\n\n", section.example, section.text);
    page += table_head({"key", "meaning", "without it", "example"});
    for (const study::StudyKeyRow& key : study::study_keys()) {
      if (key.section == section.id) {
        page += table_row({code(key.name), key.text,
                           key.default_text.empty() ? "it has to be given" : key.default_text,
                           code(key.example)});
      }
    }
  }
  return page;
}

std::string codes_page() {
  std::string page = page_head("Codes of messages", "codes.md");
  page +=
      "Every message about a program, its run or a sheet has a code that does not change; those "
      "about the command line\nhave none.  `g31 explain CODE` says the same as this page; alarms "
      "of a control: `g31 explain 'alarm 115' --control haas`.\n";
  std::string_view kind;
  const runtime::Entries entries = all_code_entries();
  for (const runtime::Entry& entry : entries) {
    if (entry.kind != kind) {
      kind = entry.kind;
      page += fmt::format("\n## {}\n\n", kind);
      page += table_head({"code", "counts as", "message", "what to do"});
    }
    page += table_row(
        {entry.name, fact_of(entry, "counts as"), entry.text, fact_of(entry, "what to do")});
  }
  return page;
}

}  // namespace g31::manual
