#include "tools/review/setup_rules.h"

#include <array>

#include <fmt/format.h>

namespace g31::review {
namespace {

constexpr auto kSetupRules = std::to_array<SetupRule>({
#define SETUP_RULE(name, code, level, text, remedy) {code, source::Severity::level, text, remedy},
#include "tools/review/setup_rules.def"
#undef SETUP_RULE
});

}  // namespace

std::span<const SetupRule> setup_rules() {
  return kSetupRules;
}

source::Diagnostic finding_of(SetupRuleId id, std::string_view detail) {
  const SetupRule& row = kSetupRules.at(static_cast<std::size_t>(id));
  source::Diagnostic finding;
  finding.severity = row.level;
  finding.code = row.code;
  finding.message = fmt::format(fmt::runtime(row.text), detail);
  finding.remedy = row.remedy;
  return finding;
}

}  // namespace g31::review
