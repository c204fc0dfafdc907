#include <array>

#include <fmt/format.h>

#include "parts/artefacts/artefact.h"
#include "parts/artefacts/worked_out.h"
#include "tools/manual/entries.h"
#include "tools/manual/markdown.h"
#include "tools/manual/pages.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/true_sizes.h"
#include "tools/setup/value_words.h"

namespace g31::manual {
namespace {

constexpr std::string_view kAboutSheets =
    R"(A set-up sheet is a TOML file that says what a program finds on the machine: the control, the machine, the
probe, the parts, the offsets and tools that the control believes.  `g31 run PROGRAM --setup SHEET` takes any
number of sheets: of two that give a key the later one wins, lists (`[[part]]`) are taken as a whole.  Relative
paths start at the folder of the sheet.  Everything may be left out; `without it` says what counts then.

The reader is strict: a key that is not here is an error, with the one that was probably meant.
`g31 explain part.at` says what stands here, `g31 setup SHEET` checks a sheet without running anything, and
[how-it-fits.md](how-it-fits.md) shows how machine, probe, lengths and parts belong together.

Editors that know TOML (Even Better TOML in VS Code, Taplo elsewhere) complete and check sheets by
[schema/g31.sheet.schema.json](schema/g31.sheet.schema.json): write its path into the first line of a sheet,

```toml
#:schema ../../docs/schema/g31.sheet.schema.json
```

or give it in `.taplo.toml` to all sheets of a project:

```toml
[[rule]]
include = ["**/*.toml"]
[rule.schema]
path = "/usr/share/doc/g31/docs/schema/g31.sheet.schema.json"
```

The schema cannot say everything: the reader also knows which sizes fit each other, and what a control has.
)";

void add_section(std::string& page, const setup::SectionRow& section) {
  page += fmt::format("\n## {}\n\n{}\n", section.example, section.text);
  if (const std::string_view rule = setup::rule_of(section.name_form); !rule.empty()) {
    page += fmt::format("\nNames: {}.\n", rule);
  }
  page += '\n' + table_head({"key", "value", "unit", "without it", "meaning", "example"});
  for (const setup::KeyRow& key : setup::key_rows()) {
    if (key.section == section.id) {
      const bool is_exact = key.name_form == setup::NameForm::Exact;
      page += table_row({is_exact ? code(key.name) : std::string(key.name), value_words(key),
                         key.unit, key.default_text, key.text, code(key.example)});
    }
  }
}

/// What `true` may name of a shape beside its sizes.
void add_worked_out(std::string& page, std::string_view shape) {
  std::string rows;
  for (const parts::WorkedOut& result : parts::worked_out()) {
    if (result.shape == shape) {
      rows += table_row({code(result.name), result.text});
    }
  }
  if (!rows.empty()) {
    page += "\nWorked out from them, for `true` of a `[[characteristic]]`:\n\n" +
            table_head({"size", "meaning"}) + rows;
  }
}

void add_true_places(std::string& page) {
  page += "\n### Places\n\nWhat `true` of a `[[characteristic]]` may name of any part:\n\n";
  page += table_head({"key", "meaning"});
  for (const setup::TruePlace& place : setup::true_places()) {
    page += table_row({code(place.key), place.text});
  }
}

void add_shapes(std::string& page) {
  page +=
      "\n## Shapes\n\n`shape = \"ring\"` in `[[part]]`; the sizes are further keys of the part, in "
      "mm.  "
      "+Z points out of the top face, and a probe from above meets z = 0 first; `at` is where the "
      "origin lies, in machine coordinates.\n";
  for (const parts::Shape& shape : parts::shapes()) {
    page += fmt::format("\n### {}\n\n{}\n\n", shape.name, shape.text);
    page += table_head({"size", "without it", "meaning"});
    for (const parts::ShapeSize& size : parts::shape_sizes()) {
      if (size.shape == shape.name) {
        page += table_row(
            {code(size.name),
             size.default_value ? fmt::format("{}", *size.default_value) : "see there", size.text});
      }
    }
    add_worked_out(page, shape.name);
  }
}

void add_units(std::string& page) {
  page +=
      "\n## Units\n\nNumbers stay within what no machine goes beyond; one that must not be "
      "negative is 0, where that is allowed, or as large as the least.\n\n";
  page += table_head({"unit", "least", "most"});
  for (const setup::UnitBounds& unit : setup::bounded_units()) {
    page += table_row({unit.name, fmt::format("{:g}", unit.least), fmt::format("{:g}", unit.most)});
  }
}

void add_errors(std::string& page) {
  page += "\n## Errors\n\nEach is told with file, line and column.\n\n";
  page += table_head({"code", "message", "what to look at"});
  for (const setup::SetupErrorRow& row : setup::setup_error_rows()) {
    page += table_row({row.code, code_entries(row.code).front().text, row.about});
  }
}

}  // namespace

std::string sheet_page() {
  std::string page = page_head("Set-up sheets", "set-up-sheet.md");
  page += kAboutSheets;
  for (const setup::SectionRow& section : setup::section_rows()) {
    add_section(page, section);
  }
  add_shapes(page);
  add_true_places(page);
  add_units(page);
  add_errors(page);
  return page;
}

}  // namespace g31::manual
