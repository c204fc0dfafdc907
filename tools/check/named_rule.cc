#include "tools/check/named_rule.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/diagnostic.h"
#include "machine/base/letters.h"
#include "machine/base/nearest_name.h"

namespace g31::check {

std::optional<std::string> why_no_rule(std::string_view word) {
  const std::string code = in_capitals(word);
  const auto rules = analysis::rules();
  if (std::ranges::find(rules, code, &analysis::Rule::code) != rules.end()) {
    return std::nullopt;
  }
  const auto messages = source::diagnostics();
  if (std::ranges::find(messages, code, &source::DiagnosticInfo::code) != messages.end()) {
    return fmt::format("{} is a message of g31 run, which g31: allow {} leaves out", code, code);
  }
  std::vector<std::string_view> known;
  for (const analysis::Rule& rule : rules) {
    known.push_back(rule.code);
  }
  const auto nearest = nearest_name(code, known);
  return fmt::format("{} is no rule{}; g31 check --rules lists them", word,
                     nearest ? fmt::format(", did you mean {}?", *nearest) : "");
}

}  // namespace g31::check
