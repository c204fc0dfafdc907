#include <algorithm>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/other_reports.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

/// Digits that a result is read to: a tenth of a micrometre, and as much of all else.
constexpr int kDecimals = 4;

/// "um/m" as people write it: "µm/m".
std::string unit_sign(std::string_view unit) {
  return unit.starts_with("um") ? "µ" + std::string(unit.substr(1)) : std::string(unit);
}

/// As many as its uncertainty has, which else would be finer than the value.
int decimals_of(const evaluate::Quantity& quantity) {
  return std::max(kDecimals, evaluate::decimals_by_u(quantity).value_or(kDecimals));
}

/// "circular_error is 4.2 µm."
std::string headline_of(const evaluate::Evaluation& evaluation, Language language) {
  std::string headline;
  for (const evaluate::Quantity* const quantity : evaluate::leading(evaluation)) {
    headline += (headline.empty() ? "" : " ") +
                said(language, Word::SaysValue, fmt::arg("name", quantity->name),
                     fmt::arg("value", significant(quantity->value, decimals_of(*quantity))),
                     fmt::arg("unit", unit_sign(quantity->unit)));
  }
  return headline;
}

Table results_table(const evaluate::Evaluation& evaluation, Language language) {
  Table table{std::string(text_of(Word::Results, language)),
              {std::string(text_of(Word::Characteristic, language)),
               std::string(text_of(Word::Measured, language)), "u",
               std::string(text_of(Word::Unit, language))},
              {},
              {},
              true};
  for (const evaluate::Quantity& quantity : evaluation.results) {
    const int decimals = decimals_of(quantity);
    table.rows.push_back({quantity.name, significant(quantity.value, decimals),
                          significant(quantity.u, decimals), unit_sign(quantity.unit)});
  }
  return table;
}

Word word_of(evaluate::Kind kind) {
  switch (kind) {
    case evaluate::Kind::Circle:
      return Word::OfCircle;
    case evaluate::Kind::Square:
      return Word::OfSquare;
    case evaluate::Kind::Speed:
      return Word::OfSpeed;
    case evaluate::Kind::Diagonal:
      return Word::OfDiagonal;
    case evaluate::Kind::Straightness:
      return Word::OfStraightness;
    case evaluate::Kind::Flatness:
      return Word::OfFlatness;
    case evaluate::Kind::Cylindricity:
      return Word::OfCylindricity;
    case evaluate::Kind::Positioning:
      break;
  }
  return Word::OfPositioning;
}

}  // namespace

Report report_of(const evaluate::Evaluation& evaluation, const std::string& file,
                 const std::string& document, const PageOrigin& origin) {
  const evaluate::KindRow& kind = evaluate::info(evaluation.kind);
  Report report;
  report.language = origin.language;
  report.title = file;
  const std::string word(text_of(word_of(evaluation.kind), origin.language));
  report.what = origin.language == Language::English ? std::string(kind.text) : word;
  report.verdict.state = word;
  report.verdict.headline = report.what;
  if (!evaluation.results.empty()) {
    report.verdict.headline = headline_of(evaluation, origin.language);
  }
  report.verdict.sentence =
      said(origin.language, Word::SaysRowsEvaluated, fmt::arg("rows", evaluation.samples));
  for (const std::string& note : evaluation.notes) {
    report.findings.push_back({source::Severity::Note, "", note, {}});
  }
  report.facts = {{std::string(text_of(Word::File, origin.language)), file},
                  {std::string(text_of(Word::Version, origin.language)), origin.version}};
  report.command = origin.command;
  if (!evaluation.svg.empty()) {
    report.drawings.push_back({word, evaluation.svg, ""});
  }
  report.tables.push_back(results_table(evaluation, origin.language));
  report.inputs = origin.inputs;
  report.caution = Word::CarefulReadings;
  report.document = document;
  return report;
}

}  // namespace g31::page
