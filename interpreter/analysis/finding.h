#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/source/diagnostic.h"

namespace g31::analysis {

/// Rows of rules.def.
enum class RuleId {
#define RULE(name, code, level, title, text) name,
#include "interpreter/analysis/rules.def"
#undef RULE
};

struct Rule {
  RuleId id;
  std::string_view code;
  source::Severity level;
  std::string_view title;
  std::string_view text;
};

/// All rows, in the order of RuleId.
std::span<const Rule> rules();

const Rule& info(RuleId id);

/// A text in the place of another.
struct Edit {
  source::Location where;  ///< known; of no length: put in there
  std::string text;
};

/// What mends a finding for certain.
struct Fix {
  std::string title;        ///< what it does: "remove the comment"
  std::vector<Edit> edits;  ///< none touches another
};

/// Something that can be said of a program without running it.
struct Finding {
  RuleId rule = RuleId::WrongBlock;
  int alarm = 0;           ///< what the control stops with; 0: no alarm
  source::Location where;  ///< known
  std::string message;     ///< one line, no final full stop
  std::string remedy;      ///< what would be right; may be empty
  std::optional<Fix> fix = {};
};

/// A finding as a message for people: with the alarm's number, if it has one.
source::Diagnostic diagnostic_of(const Finding& finding);

}  // namespace g31::analysis
