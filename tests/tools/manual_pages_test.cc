// The pages of docs that are made from tables: they are what the tables say now, and have all of
// it.

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/artefacts/worked_out.h"
#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/explain_command.h"
#include "tools/manual/cycle_parameters.h"
#include "tools/manual/entries.h"
#include "tools/manual/pages.h"
#include "tools/manual/reference_pages.h"
#include "tools/session/manual.h"
#include "tools/session/shipped_macros.h"
#include "tools/setup/true_sizes.h"

namespace g31::manual::manual_pages_test {
namespace {

/// What `g31 explain --page` prints, standard error behind it.
testing::CommandOutput printed_page(const std::string& name) {
  return testing::captured([&] { return cli::explain_command({.page = name}); });
}

/// The committed pages are what the tables say now: `g31 explain --page NAME > docs/NAME`.
TEST(Pages, AreWhatTheTablesSay) {
  for (const Page& page : pages()) {
    EXPECT_EQ(testing::text_of("docs/" + std::string(page.name)), page.make()) << page.name;
    EXPECT_EQ(printed_page(std::string(page.name)).out, page.make());
  }
  const testing::CommandOutput wrong = printed_page("nothing.md");
  EXPECT_NE(wrong.errors.find("there is no page 'nothing.md'; there are set-up"),
            std::string::npos);
  EXPECT_EQ(static_cast<cli::ExitCode>(wrong.exit_code), cli::ExitCode::BadUsage);
}

/// One row of the page for each key, shape, size and code, counted by hand-made patterns.
TEST(Pages, HaveARowForEveryRow) {
  const std::string sheet = sheet_page();
  const auto has_cell = [&](std::string_view name) {
    return sheet.find("| `" + std::string(name) + "` |") != std::string::npos;
  };
  for (const setup::KeyRow& row : setup::key_rows()) {
    if (row.name_form == setup::NameForm::Exact) {
      EXPECT_TRUE(has_cell(row.name)) << row.name;
    } else {
      EXPECT_NE(sheet.find("| " + std::string(row.name) + " |"), std::string::npos) << row.name;
    }
  }
  for (const parts::Shape& shape : parts::shapes()) {
    EXPECT_NE(sheet.find("\n### " + std::string(shape.name) + "\n"), std::string::npos);
  }
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    EXPECT_TRUE(has_cell(size.name)) << size.name;
  }
  for (const parts::WorkedOut& result : parts::worked_out()) {
    EXPECT_TRUE(has_cell(result.name)) << result.name;
  }
  for (const setup::TruePlace& place : setup::true_places()) {
    EXPECT_TRUE(has_cell(place.key)) << place.key;
  }
  const auto lines = static_cast<std::size_t>(std::ranges::count(sheet, '\n'));
  EXPECT_GE(lines, setup::key_rows().size() + parts::shape_sizes().size());
  const std::string codes = codes_page();
  for (const runtime::Entry& entry : all_code_entries()) {
    EXPECT_NE(codes.find("\n| " + entry.name + " |"), std::string::npos) << entry.name;
  }
}

/// The page that lists a kind of entries; kinds of sheets, studies and messages have their own.
std::string page_of_kind(const std::string& kind, bool is_fanuc) {
  for (const ReferencePage& page : reference_pages()) {
    if (page.is_fanuc == is_fanuc && std::ranges::find(page.kinds, kind) != page.kinds.end()) {
      return reference_page(page.name);
    }
  }
  if (kind == "program" || kind == "cycle") {
    return cycles_page();
  }
  return kind == "control" ? controls_page() : "";
}

/// Every row of every table of every control stands on a page, with its name and its text.
TEST(Pages, HaveEveryRowOfEveryControl) {
  std::size_t rows = 0;
  std::map<std::pair<std::string, bool>, std::string> pages;
  for (const session::Control& control : session::all_controls()) {
    const bool is_fanuc = std::holds_alternative<session::FanucControl>(control);
    std::set<std::string> kinds;
    for (const runtime::Entry& entry : session::everything(control)) {
      kinds.insert(entry.kind);
    }
    for (const std::string& kind : kinds) {
      const auto [known, is_new] = pages.try_emplace({kind, is_fanuc});
      std::string& page = known->second;
      page = is_new ? page_of_kind(kind, is_fanuc) : page;
      ASSERT_FALSE(page.empty()) << "no page lists: " << kind;
      for (const runtime::Entry& entry : entries_of_kind(control, kind)) {
        if (kind == "program" && entry.name.starts_with('_')) {
          continue;  // a part of a cycle
        }
        const bool is_heading = kind == "program" || kind == "control";
        const std::string row = is_heading ? "# " + entry.name + "\n\n" + plain(entry.text)
                                           : "| `" + entry.name + "` | " + plain(entry.text) + " |";
        EXPECT_NE(page.find(row), std::string::npos) << session::name_of(control) << ": " << row;
        ++rows;
      }
    }
  }
  EXPECT_GE(rows, 3000U) << "the tables are there at all";
}

/// As many rows as the tables have lines, counted in the texts of the tables.
TEST(Pages, HaveAsManyRowsAsTheTablesHaveLines) {
  struct Count {
    const char* page;
    const char* table;
  };
  constexpr Count kCounts[] = {
      {"fanuc-alarms", "fanuc/vocabulary/alarms"},
      {"fanuc-parameters", "fanuc/vocabulary/parameters"},
      {"sinumerik-g-codes", "sinumerik/vocabulary/g_codes"},
      {"machine-data", "sinumerik/vocabulary/machine_data"},
  };
  const auto matches = [](const std::string& text, const char* pattern) {
    const std::regex line(pattern, std::regex::multiline);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), line), {});
  };
  for (const Count& each : kCounts) {
    const std::string table =
        testing::text_of("interpreter/dialects/" + std::string(each.table) + ".def");
    std::string page = testing::text_of("docs/reference/" + std::string(each.page) + ".md");
    page.resize(std::min(page.find("\n### "), page.size()));  // what other controls have besides
    EXPECT_GE(matches(table, "^[A-Z_]+\\("), 60) << each.table;
    EXPECT_EQ(matches(page, "^\\| `"), matches(table, "^[A-Z_]+\\(")) << each.page;
  }
}

/// No parameter of a measuring cycle without a meaning, no meaning without a parameter.
TEST(Pages, SayWhatEachParameterOfAMeasuringCycleMeans) {
  const std::string page = cycles_page();
  const std::size_t begin = page.find("### CYCLE961");
  const std::size_t end = page.find("## Further programs");
  ASSERT_LT(begin, end);
  const std::string cycles = page.substr(begin, end - begin);
  EXPECT_EQ(cycles.find("|  |\n"), std::string::npos) << "a parameter without a text";
  for (const char* const cycle :
       {"961", "971", "973", "974", "976", "977", "978", "979", "982", "994", "998"}) {
    EXPECT_NE(cycles.find("### CYCLE" + std::string(cycle) + "\n"), std::string::npos) << cycle;
  }
  for (const CycleParameter& row : cycle_parameters()) {
    EXPECT_NE(cycles.find(plain(row.text) + " |"), std::string::npos) << row.cycles << row.name;
  }
}

TEST(Pages, HaveTheMacrosInTheirOwnWords) {
  const session::MacroText macro =
      session::text_of_macro("%\nO9100 (A BORE)\n(CALL  G65 P9100 D_)\n(D (NOT E))\n#1=2 (NO)\n");
  EXPECT_EQ(macro.name, "O9100");
  EXPECT_EQ(macro.title, "A BORE");
  EXPECT_EQ(macro.lines, (std::vector<std::string>{"CALL  G65 P9100 D_", "D (NOT E)"}));
  const std::string page = cycles_page();
  EXPECT_EQ(session::shipped_macros().size(), 21U);
  EXPECT_NE(page.find("### O9851\n\nCALIBRATES A TOOL SETTER WITH A TOOL OF KNOWN SIZE\n\n"
                      "    G65 P9851 X_ Y_ Z_ K_ D_ S_ F_\n"),
            std::string::npos);
}

}  // namespace
}  // namespace g31::manual::manual_pages_test
