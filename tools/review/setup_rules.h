#pragma once

#include <span>
#include <string_view>

#include "interpreter/source/diagnostic.h"

namespace g31::review {

/// Rows of setup_rules.def.
enum class SetupRuleId {
#define SETUP_RULE(name, code, level, text, remedy) name,
#include "tools/review/setup_rules.def"
#undef SETUP_RULE
};

struct SetupRule {
  std::string_view code;
  source::Severity level;
  std::string_view text;  ///< fmt format with one {}
  std::string_view remedy;
};

/// All rows.
std::span<const SetupRule> setup_rules();

/// A finding of row `id`, without a place.
source::Diagnostic finding_of(SetupRuleId id, std::string_view detail);

}  // namespace g31::review
