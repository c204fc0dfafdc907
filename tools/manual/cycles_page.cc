#include <algorithm>

#include <fmt/format.h>

#include "tools/manual/cycle_parameters.h"
#include "tools/manual/markdown.h"
#include "tools/manual/pages.h"
#include "tools/manual/reference_pages.h"
#include "tools/session/shipped_macros.h"

namespace g31::manual {
namespace {

using runtime::Entry;

/// The call of a program, as its PROC has it.
std::string call_of(const Entry& entry) {
  const auto fact = std::ranges::find(entry.facts, "form", &runtime::Fact::name);
  return fact != entry.facts.end() ? fact->value : entry.name;
}

/// "INT S_MA=1" in its parts.
struct Parameter {
  std::string type;
  std::string name;
  std::string value;  ///< "1": what counts without it; else ""
};

std::vector<Parameter> parameters_of(const std::string& call) {
  std::vector<Parameter> parameters;
  std::size_t at = call.find('(');
  while (at != std::string::npos && at + 1 < call.size()) {
    // A comma within [] belongs to an array.
    std::size_t end = at + 1;
    for (int depth = 0; end < call.size() && (depth > 0 || (call[end] != ',' && call[end] != ')'));
         ++end) {
      depth += call[end] == '[' ? 1 : call[end] == ']' ? -1 : 0;
    }
    std::string text = call.substr(at + 1, end - at - 1);
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string value = text.substr(std::min(equals + 1, text.size()));
    text.resize(equals);
    const std::size_t blank = text.find_last_of(' ');
    if (blank != std::string::npos) {
      parameters.push_back(
          {text.substr(text.find_first_not_of(' '), blank), text.substr(blank + 1), value});
    }
    at = end < call.size() && call[end] == ',' ? end : std::string::npos;
  }
  return parameters;
}

void add_measuring_cycle(std::string& page, const Entry& entry) {
  page += fmt::format("\n### {}\n\n{}\n\n", entry.name, plain(entry.text));
  std::string names;
  std::string rows = table_head({"parameter", "type", "without it", "meaning"});
  for (const Parameter& parameter : parameters_of(call_of(entry))) {
    names += (names.empty() ? "" : ",") + parameter.name;
    rows += table_row({code(parameter.name), parameter.type, parameter.value,
                       plain(text_of_parameter(entry.name, parameter.name))});
  }
  page += fmt::format("    {}({})\n\n{}", entry.name, names, rows);
}

void add_program(std::string& page, const Entry& entry) {
  page += fmt::format("\n### {}\n\n{}\n\n    {}\n", entry.name, plain(entry.text), call_of(entry));
}

bool is_measuring_cycle(const Entry& entry) {
  return !text_of_parameter(entry.name, "S_MVAR").empty() &&
         call_of(entry).find("S_MVAR") != std::string::npos;
}

void add_macros(std::string& page) {
  page +=
      "\n## Macros for Fanuc controls\n\nIn `macros/fanuc`, as their own comments have it; a run "
      "finds them by their numbers.\n";
  for (const session::MacroText& macro : session::shipped_macros()) {
    page += fmt::format("\n### {}\n\n{}\n\n", macro.name, plain(macro.title));
    for (const std::string& line : macro.lines) {
      page += fmt::format("    {}\n", line);
    }
  }
}

}  // namespace

std::string cycles_page() {
  std::string page = page_head("Cycles and macros", "reference/cycles.md");
  page +=
      "What comes with g31, readable programs in the language of their control: "
      "`/usr/share/g31/macros`.\n\n## Measuring cycles of the SINUMERIK\n\nCalls and results are "
      "those of the 828D; results stand in `_OVR` and `_OVI`, see [data of the measuring "
      "cycles](measuring-data.md), alarms in [alarms](sinumerik-alarms.md).  Digits of a number "
      "count from its units: of 103 the units are 3 and the hundreds 1.  The 1st and 2nd axis are "
      "those of the plane, X and Y in G17.  [How the probe and the parts are "
      "described](../set-up-sheet.md).\n";
  std::string others;
  for (const session::Control& control : session::all_controls()) {
    if (std::holds_alternative<session::FanucControl>(control)) {
      continue;
    }
    for (const Entry& entry : entries_of_kind(control, "program")) {
      if (is_measuring_cycle(entry)) {
        add_measuring_cycle(page, entry);
      } else if (!entry.name.starts_with('_')) {
        add_program(others, entry);
      }
    }
    page += "\n## Further programs of the SINUMERIK\n" + others;
    page += "\n## Cycles that are not simulated\n\n" + table_head({"name", "what it is"});
    for (const Entry& entry : entries_of_kind(control, "cycle")) {
      page += table_row({code(entry.name), plain(entry.text)});
    }
  }
  add_macros(page);
  return page;
}

}  // namespace g31::manual
