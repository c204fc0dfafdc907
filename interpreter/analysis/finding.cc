#include "interpreter/analysis/finding.h"

#include <array>

#include <fmt/format.h>

namespace g31::analysis {
namespace {

constexpr auto kRules = std::to_array<Rule>({
#define RULE(name, code, level, title, text) \
  {RuleId::name, code, source::Severity::level, title, text},
#include "interpreter/analysis/rules.def"
#undef RULE
});

}  // namespace

std::span<const Rule> rules() {
  return kRules;
}

const Rule& info(RuleId id) {
  return kRules.at(static_cast<std::size_t>(id));
}

source::Diagnostic diagnostic_of(const Finding& finding) {
  const Rule& rule = info(finding.rule);
  return {rule.level,
          std::string(rule.code),
          finding.where,
          finding.alarm != 0 ? fmt::format("alarm {}, {}", finding.alarm, finding.message)
                             : finding.message,
          finding.remedy,
          {}};
}

}  // namespace g31::analysis
