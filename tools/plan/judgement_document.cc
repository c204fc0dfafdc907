#include "tools/plan/judgement_document.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace g31::plan {
namespace {

using Json = nlohmann::ordered_json;

Json length_or_null(const std::optional<double>& mm) {
  return mm ? Json(*mm + 0.0) : Json(nullptr);
}

std::string shown_or_dash(const std::optional<double>& mm, bool with_sign) {
  if (!mm) {
    return "-";
  }
  return with_sign ? fmt::format("{:+.5f}", *mm) : fmt::format("{:.5f}", *mm + 0.0);
}

std::string shown(const std::optional<Tolerance>& tolerance) {
  return tolerance ? fmt::format("{:+.5g} to {:+.5g}", tolerance->lower, tolerance->upper) : "-";
}

}  // namespace

std::string judgement_document(const Judgement& judgement) {
  Json rows = Json::array();
  for (const JudgedMeasure& row : judgement.measures) {
    const auto& tolerance = row.measure.tolerance;
    rows.push_back({{"id", row.measure.id},
                    {"nominal", row.measure.nominal},
                    {"actual", length_or_null(row.actual)},
                    {"deviation", length_or_null(row.deviation)},
                    {"tolerance",
                     tolerance ? Json::array({tolerance->lower, tolerance->upper}) : Json(nullptr)},
                    {"verdict", word_of(row.verdict)}});
  }
  constexpr int kIndent = 2;
  return Json{{"schema", "g31.judgement/1"}, {"measures", rows}}.dump(kIndent) + "\n";
}

std::string measures_table(const Judgement& judgement) {
  constexpr std::string_view kHead = "measure";
  std::size_t width = kHead.size();
  for (const JudgedMeasure& row : judgement.measures) {
    width = std::max(width, row.measure.id.size());
  }
  std::string text = fmt::format("{:<{}}  {:>12}  {:>12}  {:>10}  {:<20}  verdict\n", kHead, width,
                                 "nominal", "actual", "deviation", "tolerance");
  for (const JudgedMeasure& row : judgement.measures) {
    text += fmt::format("{:<{}}  {:>12}  {:>12}  {:>10}  {:<20}  {}\n", row.measure.id, width,
                        shown_or_dash(row.measure.nominal, false), shown_or_dash(row.actual, false),
                        shown_or_dash(row.deviation, true), shown(row.measure.tolerance),
                        is_only_reported(row) ? "good (no tolerance)" : word_of(row.verdict));
  }
  return text;
}

std::string judgement_table(const Judgement& judgement) {
  const auto reported = std::ranges::count_if(judgement.measures, is_only_reported);
  return measures_table(judgement) +
         fmt::format("{} of {} good{}, {} bad, {} missing\n", count(judgement, Verdict::Good),
                     judgement.measures.size(),
                     reported == 0 ? "" : fmt::format(" ({} without a tolerance)", reported),
                     count(judgement, Verdict::Bad), count(judgement, Verdict::Missing));
}

}  // namespace g31::plan
