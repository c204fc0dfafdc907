#include <algorithm>
#include <array>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/diagnostic.h"
#include "machine/base/letters.h"
#include "tools/evaluate/data_error.h"
#include "tools/manual/entries.h"
#include "tools/review/setup_rules.h"
#include "tools/setup/setup_error.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;

/// Codes whose messages are all said at their place: what they have in common.
struct SaidInPlace {
  std::string_view code;
  std::string_view text;
};
constexpr auto kSaidInPlace = std::to_array<SaidInPlace>({
    {"PRB401",
     "something touched that must not, or an axis came to the end of its travel: the "
     "message says what met what, and where"},
    {"PRB504", "two programs have one number: the message says which, and where they are"},
    {"SET111", "a part cannot be made: the message says what is wrong with its file or shape"},
    {"SET125", "there is no control of this name: the message says which there are"},
    {"SET126", "the control does not take a setting: the message says why"},
    {"SET127", "this is no assignment: the message says what is missing"},
    {"DAT113", "the record does not allow this evaluation: the message says why"},
});

std::string text_of_code(std::string_view code, std::string_view text) {
  const auto* const row = std::ranges::find(kSaidInPlace, code, &SaidInPlace::code);
  return row != kSaidInPlace.end() ? std::string(row->text) : readable(text);
}

Entry entry_of_code(std::string kind, std::string_view code, std::string_view text,
                    std::string_view remedy) {
  Entry entry{std::move(kind), std::string(code), text_of_code(code, text), {}};
  if (!remedy.empty()) {
    entry.facts.push_back({"what to do", std::string(remedy)});
  }
  return entry;
}

}  // namespace

std::string readable(std::string_view text) {
  // A detail at the end begins with its own colon or blank.
  std::string shown(text.ends_with("{}") && !text.ends_with(" {}") ? text.substr(0, text.size() - 2)
                                                                   : text);
  for (std::size_t at = shown.find("{}"); at != std::string::npos; at = shown.find("{}")) {
    shown.replace(at, 2, "...");
  }
  return shown;
}

Entries all_code_entries() {
  Entries all;
  for (const source::DiagnosticInfo& row : source::diagnostics()) {
    all.push_back(entry_of_code("message of g31", row.code, row.text, row.remedy));
    all.back().facts.push_back({"counts as", std::string(source::name_of(row.severity))});
  }
  for (const setup::SetupErrorRow& row : setup::setup_error_rows()) {
    all.push_back(entry_of_code("error of a sheet", row.code, row.text, row.about));
  }
  for (const review::SetupRule& row : review::setup_rules()) {
    all.push_back(entry_of_code("finding of g31 setup", row.code, row.text, row.remedy));
    all.back().facts.push_back({"counts as", std::string(source::name_of(row.level))});
  }
  for (const analysis::Rule& row : analysis::rules()) {
    all.push_back(entry_of_code("rule of g31 check", row.code, row.text, ""));
    all.back().facts.push_back({"title", std::string(row.title)});
    all.back().facts.push_back({"counts as", std::string(source::name_of(row.level))});
  }
  for (const evaluate::DataErrorRow& row : evaluate::data_error_rows()) {
    all.push_back(entry_of_code("error of a record", row.code, row.text, ""));
  }
  return all;
}

Entries code_entries(std::string_view topic) {
  const std::string code = in_capitals(topic);
  Entries found = all_code_entries();
  std::erase_if(found, [&](const Entry& entry) { return entry.name != code; });
  return found;
}

}  // namespace g31::manual
