#include "tools/manual/reference_pages.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/analysis/finding.h"
#include "machine/base/contract.h"
#include "tools/manual/markdown.h"
#include "tools/session/manual.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;

constexpr std::array<std::string_view, 5> kFanucVariables = {"variable", "local variable",
                                                             "common variable", "system variable",
                                                             "variable name (30i family)"};
constexpr std::array<std::string_view, 2> kFanucCodes = {"G code", "M code"};
constexpr std::array<std::string_view, 2> kFanucLanguage = {"function", "statement"};
constexpr std::array<std::string_view, 1> kParameters = {"parameter"};
constexpr std::array<std::string_view, 1> kAlarms = {"alarm"};
constexpr std::array<std::string_view, 2> kSinumerikVariables = {"variable", "system variable"};
constexpr std::array<std::string_view, 1> kSinumerikCodes = {"G code"};
constexpr std::array<std::string_view, 8> kSinumerikLanguage = {
    "statement", "function", "procedure",          "operator",
    "constant",  "address",  "address of an axis", "form of a value"};
constexpr std::array<std::string_view, 1> kMachineData = {"machine or setting datum"};
constexpr std::array<std::string_view, 2> kMeasuringData = {"global variable", "macro"};

constexpr auto kReferencePages = std::to_array<ReferencePage>({
    {"reference/fanuc-variables.md", "Variables of Fanuc controls",
     "`g31 explain '#5063' --control haas` says the same of one.", true, kFanucVariables},
    {"reference/fanuc-g-codes.md", "G and M codes of Fanuc controls",
     "`g31 explain G31` says the same of one.  Other M codes do nothing, unless `[macro_calls]` "
     "makes calls of them.",
     true, kFanucCodes},
    {"reference/fanuc-language.md", "Custom Macro B: functions and statements",
     "`g31 explain ATAN GOTO` says the same.", true, kFanucLanguage},
    {"reference/fanuc-parameters.md", "Parameters of Fanuc controls",
     "`[parameters]` of the set-up sheet sets them; others are kept and have no effect (PRB505).",
     true, kParameters},
    {"reference/fanuc-alarms.md", "Alarms of Fanuc controls",
     "An alarm ends the program: exit code 3, or 2 where a block cannot be understood, 4 where an "
     "axis would leave its travel.  `g31 explain 'alarm 115' --control haas` says the "
     "same of one.",
     true, kAlarms},
    {"reference/sinumerik-variables.md", "Variables of the SINUMERIK 828D",
     "`g31 explain '$AA_MW' --control sinumerik-828d` says the same of one.", false,
     kSinumerikVariables},
    {"reference/sinumerik-g-codes.md", "G codes of the SINUMERIK 828D",
     "`g31 explain G64 --control sinumerik-828d` says the same of one.", false, kSinumerikCodes},
    {"reference/sinumerik-language.md", "The language of the SINUMERIK 828D",
     "`g31 explain SUBSTR --control sinumerik-828d` says the same of one.", false,
     kSinumerikLanguage},
    {"reference/machine-data.md", "Machine and setting data of the SINUMERIK 828D",
     "`[machine_data]` of the set-up sheet sets them by their names.", false, kMachineData},
    {"reference/measuring-data.md", "Data of the measuring cycles",
     "What the definition files of `macros/sinumerik` have: results, and what programs for "
     "earlier software set.",
     false, kMeasuringData},
    {"reference/sinumerik-alarms.md", "Alarms of the SINUMERIK 828D",
     "Those of the measuring cycles, of their programs, at the end.  `g31 explain 61301 --control "
     "sinumerik-828d` says the same of one.",
     false, kAlarms},
});

/// Which facts have a column of their own: those of at least a quarter of the entries.
std::vector<std::string> columns_of(const Entries& entries) {
  std::map<std::string, std::size_t> count;
  std::vector<std::string> order;
  for (const Entry& entry : entries) {
    for (const runtime::Fact& fact : entry.facts) {
      if (count[fact.name]++ == 0) {
        order.push_back(fact.name);
      }
    }
  }
  std::erase_if(order, [&](const std::string& name) { return 4 * count[name] < entries.size(); });
  return order;
}

/// A line for each entry: name, text, a column for what most have, the rest in the last one.
std::vector<std::string> rows_of(const Entries& entries, const std::vector<std::string>& columns) {
  std::vector<std::string> rows;
  for (const Entry& entry : entries) {
    std::vector<std::string> cells(columns.size());
    std::string rest;
    for (const runtime::Fact& fact : entry.facts) {
      const auto column = std::ranges::find(columns, fact.name);
      if (column != columns.end()) {
        cells.at(static_cast<std::size_t>(column - columns.begin())) = plain(fact.value);
      } else {
        rest +=
            fmt::format("{}{}: {}", rest.empty() ? "" : "; ", plain(fact.name), plain(fact.value));
      }
    }
    cells.insert(cells.begin(), {code(entry.name), plain(entry.text)});
    cells.push_back(rest);
    rows.push_back(table_row(cells));
  }
  return rows;
}

std::string columns_head(const std::vector<std::string>& columns) {
  std::vector<std::string> cells = {"name", "meaning"};
  std::ranges::transform(columns, std::back_inserter(cells), plain);
  cells.emplace_back("more");
  return table_head(cells);
}

std::string title_of(std::string_view kind) {
  std::string title(kind);
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  return title;
}

bool is_fanuc(const session::Control& control) {
  return std::holds_alternative<session::FanucControl>(control);
}

/// The controls of a page; of the Fanuc dialect that of most machines of today first.
std::vector<session::Control> controls_of(const ReferencePage& page) {
  std::vector<session::Control> controls = session::all_controls();
  std::erase_if(controls, [&](const auto& control) { return is_fanuc(control) != page.is_fanuc; });
  std::stable_partition(controls.begin(), controls.end(), [](const auto& control) {
    return session::name_of(control) == "fanuc-30i";
  });
  return controls;
}

/// All of the first control, then what each of the others has otherwise.
void add_kind(std::string& page, const ReferencePage& about, std::string_view kind) {
  const std::vector<session::Control> controls = controls_of(about);
  const Entries first = entries_of_kind(controls.front(), kind);
  const std::vector<std::string> columns = columns_of(first);
  std::set<std::string> shown;
  page += fmt::format("\n## {}\n\n{}", title_of(kind), columns_head(columns));
  for (const std::string& row : rows_of(first, columns)) {
    page += row;
    shown.insert(row);
  }
  for (const session::Control& control : std::span(controls).subspan(1)) {
    std::string others;
    const Entries entries = entries_of_kind(control, kind);
    for (const std::string& row : rows_of(entries, columns)) {
      others += shown.insert(row).second ? row : "";
    }
    std::vector<std::string> missing;
    for (const Entry& entry : first) {
      // An alarm is there, too, by another number: the columns of the first table have it.
      if (kind != "alarm" &&
          std::ranges::find(entries, entry.name, &Entry::name) == entries.end()) {
        missing.push_back(code(entry.name));
      }
    }
    if (!others.empty() || !missing.empty()) {
      page += fmt::format("\n### {}: {}\n", title_of(kind), session::name_of(control));
      page += missing.empty() ? "" : fmt::format("\nNot there: {}.\n", fmt::join(missing, ", "));
      page += others.empty() ? "" : "\n" + columns_head(columns) + others;
    }
  }
}

}  // namespace

std::string plain(std::string_view text) {
  const auto is_letter = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    // Within a word a _ is one; ]( would be a link.
    const bool is_mark = text[i] == '*' || text[i] == '`' ||
                         (text[i] == '_' && !(i > 0 && is_letter(i - 1) && is_letter(i + 1))) ||
                         (text[i] == '(' && i > 0 && text[i - 1] == ']');
    if (text[i] == '<') {
      shown += "&lt;";
    } else {
      shown += is_mark ? std::string{'\\', text[i]} : std::string(1, text[i]);
    }
  }
  return shown;
}

runtime::Entries entries_of_kind(const session::Control& control, std::string_view kind) {
  Entries entries = session::everything(control);
  std::erase_if(entries, [&](const Entry& entry) {
    // Programs define names for themselves; those with a text are for others.
    const bool is_local = (kind == "global variable" || kind == "macro") && entry.text.empty();
    return entry.kind != kind || is_local;
  });
  return entries;
}

std::span<const ReferencePage> reference_pages() {
  return kReferencePages;
}

std::string reference_page(std::string_view name) {
  const auto* const about = std::ranges::find(kReferencePages, name, &ReferencePage::name);
  G31_EXPECTS(about != kReferencePages.end());
  std::string page = page_head(about->title, about->name);
  page += fmt::format("{}\n", about->about);
  if (about->is_fanuc) {
    page +=
        "\nThe tables are those of fanuc-30i (30i, 31i, 0i-D, 0i-F); below each stands what the "
        "other controls have otherwise.  [Controls](controls.md) has them side by side.\n";
  }
  for (const std::string_view kind : about->kinds) {
    add_kind(page, *about, kind);
  }
  return page;
}

std::string controls_page() {
  std::string page = page_head("Controls", "reference/controls.md");
  page +=
      "What `--control` and `[control] profile` take; models run as the control does that covers "
      "them.  The SINUMERIK 828D has pages of its own.\n";
  for (const session::Control& control : session::all_controls()) {
    const Entries all = session::everything(control);
    const auto entry = std::ranges::find_if(all, [&](const Entry& each) {
      return each.kind == "control" && each.name == session::name_of(control);
    });
    G31_EXPECTS(entry != all.end());
    page += fmt::format("\n## {}\n\n{}\n\n{}", entry->name, plain(entry->text),
                        table_head({"property", "here"}));
    for (const runtime::Fact& fact : entry->facts) {
      page += table_row({plain(fact.name), plain(fact.value)});
    }
  }
  return page;
}

std::string rules_page() {
  std::string page = page_head("Rules of g31 check", "reference/rules.md");
  page +=
      "What `g31 check` finds without running a program.  `--disable NC007` leaves a rule out, "
      "`--fail-on` says from which level a finding gives exit code 1.  In a program "
      "`(g31: disable=NC005 reason)` or `; g31: disable=NC005 reason` leaves findings out: for its "
      "own line; alone on a line, for the next block; before the first block, for the file.  "
      "`--baseline FILE` leaves out what an earlier document has: the same rule, file and text of "
      "the line.\n\n" +
      table_head({"code", "title", "level", "what it finds"});
  for (const analysis::Rule& rule : analysis::rules()) {
    page +=
        table_row({rule.code, plain(rule.title), source::name_of(rule.level), plain(rule.text)});
  }
  return page;
}

}  // namespace g31::manual
