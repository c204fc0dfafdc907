#include "tools/plan/measures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/plan/json_document.h"

namespace g31::plan {
namespace {

using PlanJson = nlohmann::json;
using Problem = std::optional<std::string>;

constexpr std::size_t kLongestName = 64;
constexpr std::size_t kMostMeasures = 100'000;

Problem read_length(const PlanJson& value, double& length) {
  if (!value.is_number() || !(std::abs(value.get<double>()) <= kLongestMm)) {
    return fmt::format("expected a length from -{0} to {0} mm", kLongestMm);
  }
  length = value.get<double>();
  return std::nullopt;
}

Problem read_tolerance(const PlanJson& value, std::optional<Tolerance>& tolerance) {
  if (value.is_null()) {
    return std::nullopt;
  }
  Tolerance read;
  if (!value.is_array() || value.size() != 2 || read_length(value[0], read.lower) ||
      read_length(value[1], read.upper) || read.lower > read.upper) {
    return std::string("expected [lower, upper] in mm, the lower one first, or null");
  }
  tolerance = read;
  return std::nullopt;
}

Problem read_word(const PlanJson& value, std::string& word) {
  word = value.is_string() ? value.get<std::string>() : std::string();
  const auto stands_alone = [](char c) { return c > ' ' && c <= '~' && c != '='; };
  if (word.empty() || word.size() > kLongestName || !std::ranges::all_of(word, stands_alone)) {
    return fmt::format("expected 1 to {} ASCII characters without blanks and =", kLongestName);
  }
  return std::nullopt;
}

/// What is wrong with one measure, the field first.
Problem read_measure(const PlanJson& row, Measure& measure) {
  if (!row.is_object()) {
    return std::string("expected an object");
  }
  const auto field = [&row](const char* key) { return row.value(key, PlanJson()); };
  const auto named = [](const char* key, Problem problem) {
    return problem ? Problem(fmt::format("{}: {}", key, *problem)) : std::nullopt;
  };
  if (auto wrong = named("id", read_word(field("id"), measure.id))) {
    return wrong;
  }
  measure.printed = printed_name(measure.id);
  if (row.contains("printed")) {
    if (auto wrong = named("printed", read_word(field("printed"), measure.printed))) {
      return wrong;
    }
  }
  if (auto wrong = named("nominal", read_length(field("nominal"), measure.nominal))) {
    return wrong;
  }
  return named("tolerance", read_tolerance(field("tolerance"), measure.tolerance));
}

}  // namespace

std::string printed_name(std::string_view id) {
  std::string name(id);
  for (char& c : name) {
    if (c >= 'a' && c <= 'z') {
      c = static_cast<char>(c - 'a' + 'A');
    } else if (!(c >= 'A' && c <= 'Z') && !(c >= '0' && c <= '9')) {
      c = '-';
    }
  }
  return name;
}

Result<std::vector<Measure>, std::string> read_measures(const std::string& name,
                                                        std::string_view text) {
  const auto read = json_document(name, text, "a whole plan.json of g31 plan");
  if (!read) {
    return read.error();
  }
  const PlanJson& document = read.value();
  if (!document.is_object() || document.value("schema", PlanJson()) != "g31.plan/1") {
    return fmt::format("{}: expected a document with \"schema\": \"g31.plan/1\"", name);
  }
  const PlanJson rows = document.value("measures", PlanJson());
  if (!rows.is_array() || rows.empty() || rows.size() > kMostMeasures) {
    return fmt::format("{}: measures: expected a list of 1 to {}", name, kMostMeasures);
  }
  std::vector<Measure> measures;
  std::set<std::string> names;
  for (const PlanJson& row : rows) {
    Measure measure;
    const std::string place = fmt::format("{}: measures[{}]", name, measures.size());
    if (const auto wrong = read_measure(row, measure)) {
      return fmt::format("{}: {}", place, *wrong);
    }
    // The id serves as a name in results too, so it may be no other measure's printed one.
    const bool is_new = names.insert(measure.id).second;
    if (!is_new || (measure.printed != measure.id && !names.insert(measure.printed).second)) {
      return fmt::format("{}: {}: another measure has the same id or printed name", place,
                         measure.id);
    }
    measures.push_back(std::move(measure));
  }
  return measures;
}

}  // namespace g31::plan
