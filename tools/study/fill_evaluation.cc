#include "tools/study/fill_evaluation.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/nearest_name.h"
#include "tools/evaluate/request_words.h"
#include "tools/setup/duration.h"

namespace g31::study {
namespace {

using setup::SetupErrorId;

/// Columns of a trace that a path can be taken from, behind the letter of the axis.
bool is_of_trace(const std::string& axis, const std::string& column) {
  return column == axis || column == axis + "_true" || column == axis + "_encoder" ||
         column == axis + "_commanded";
}

std::optional<std::string> wrong_columns(const evaluate::Request& request) {
  for (const auto& [axis, column] : request.columns.names) {
    if (!is_of_trace(axis, column)) {
      return fmt::format("--columns {0}={1}: a trace has {0}_true, {0}_encoder and {0}_commanded",
                         axis, column);
    }
  }
  return request.interval_s ? std::optional<std::string>(
                                  "--interval is of files without times; trace_period says it here")
                            : std::nullopt;
}

}  // namespace

std::optional<StudyEvaluation> fill_evaluation(const StudyTable& table, setup::ErrorList& errors) {
  const StudyEntry* const kind = table.find(StudyKey::Kind);
  if (kind == nullptr) {
    errors.add(SetupErrorId::KeyMissing, table.where, {"[evaluation]", "kind"},
               fmt::format("for example: {}", row_of(StudyKey::Kind).example));
    return std::nullopt;
  }
  const StudyEntry* const options = table.find(StudyKey::Options);
  const std::string line = options != nullptr ? std::get<std::string>(options->value) : "";
  const setup::Location where = options != nullptr ? options->where : kind->where;
  const auto refused = [&](const std::string& why) {
    errors.add(SetupErrorId::OutOfRange, where, {"options", fmt::format("\"{}\"", line), why});
    return std::nullopt;
  };
  const auto words = evaluate::request_words(std::get<std::string>(kind->value), line);
  if (!words) {
    return refused("options of g31 evaluate: " + words.error());
  }
  const auto request = evaluate::request_of(words.value());
  if (!request) {
    return refused("options of g31 evaluate: " + request.error());
  }
  if (const auto wrong = wrong_columns(request.value())) {
    return refused("options of a path that is run: " + *wrong);
  }
  StudyEvaluation evaluation{request.value()};
  if (const StudyEntry* const period = table.find(StudyKey::TracePeriod)) {
    const auto seconds = setup::parse_duration(std::get<std::string>(period->value));
    if (!seconds) {
      errors.add(SetupErrorId::OutOfRange, period->where,
                 {"trace_period", fmt::format("\"{}\"", std::get<std::string>(period->value)),
                  "a time such as \"1ms\""});
      return std::nullopt;
    }
    evaluation.trace_period_s = seconds.value();
  }
  return evaluation;
}

void fill_evaluated(const StudyTable& table, const std::optional<StudyEvaluation>& evaluation,
                    StudyResult& result, setup::ErrorList& errors) {
  const StudyEntry& entry = *table.find(StudyKey::Evaluated);
  result.evaluated = std::get<std::string>(entry.value);
  if (!evaluation) {
    errors.add(SetupErrorId::KeyMissing, entry.where, {"the study", "[evaluation]"},
               fmt::format("for example: [evaluation] {}", row_of(StudyKey::Kind).example));
    return;
  }
  std::vector<std::string_view> names;
  for (const evaluate::ResultRow& row : evaluate::results()) {
    if (!evaluate::belongs_to(row, evaluation->request.kind)) {
      continue;
    }
    if (evaluate::names(row, result.evaluated)) {
      if (table.find(StudyKey::Unit) == nullptr) {
        result.form.unit = row.unit;
      }
      return;
    }
    names.push_back(row.name);
  }
  errors.add(SetupErrorId::OutOfRange, entry.where,
             {"evaluated", fmt::format("\"{}\"", result.evaluated),
              fmt::format("one of {}, with a letter or a number for *", fmt::join(names, ", "))});
}

}  // namespace g31::study
