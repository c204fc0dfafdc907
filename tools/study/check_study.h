#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tools/setup/check_value.h"
#include "tools/setup/document.h"
#include "tools/setup/setup_error.h"
#include "tools/study/study_keys.h"

namespace g31::study {

/// A checked value: a number, a text, texts, or the nodes of a list whose meaning its key tells.
using StudyValue =
    std::variant<double, std::string, std::vector<std::string>, std::vector<setup::Node>>;

struct StudyEntry {
  StudyValue value;
  setup::Location where;
};

/// One table of a study file: its checked keys.
struct StudyTable {
  std::string name;  ///< of a result
  setup::Location where;
  std::map<StudyKey, StudyEntry> entries;

  [[nodiscard]] const StudyEntry* find(StudyKey key) const {
    const auto entry = entries.find(key);
    return entry != entries.end() ? &entry->second : nullptr;
  }

  /// `Value` is the alternative of StudyValue that the key's type becomes.
  template <typename Value>
  [[nodiscard]] Value get(StudyKey key, const Value& otherwise) const {
    const StudyEntry* const entry = find(key);
    return entry != nullptr ? std::get<Value>(entry->value) : otherwise;
  }

  [[nodiscard]] std::optional<double> number(StudyKey key) const {
    const StudyEntry* const entry = find(key);
    return entry != nullptr ? std::optional(std::get<double>(entry->value)) : std::nullopt;
  }
};

/// A study file whose keys are known, of the right type and complete.
struct CheckedStudy {
  StudyTable study;
  std::optional<StudyTable> evaluation;
  std::vector<StudyTable> results;
  std::vector<StudyTable> variations;
};

/// A number of a key, or one of its numbers, within the limit of the row.
Result<double, setup::ValueProblem> number_of(const setup::Node& node, const StudyKeyRow& row);

/// Checks every key against study_keys.def.  What is wrong goes to `errors`.
CheckedStudy check_study(const setup::Document& document, setup::ErrorList& errors);

}  // namespace g31::study
