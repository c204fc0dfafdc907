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

Table results_table(const evaluate::Evaluation& evaluation, Language language) {
  Table table{std::string(text_of(Word::Results, language)),
              {std::string(text_of(Word::Characteristic, language)),
               std::string(text_of(Word::Measured, language)), "u",
               std::string(text_of(Word::Unit, language))},
              {},
              {},
              true};
  for (const evaluate::Quantity& quantity : evaluation.results) {
    table.rows.push_back({quantity.name, significant(quantity.value, kDecimals),
                          significant(quantity.u, kDecimals), unit_sign(quantity.unit)});
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
    const evaluate::Quantity& first = evaluation.results.front();
    report.verdict.headline = said(origin.language, Word::SaysValue, fmt::arg("name", first.name),
                                   fmt::arg("value", significant(first.value, kDecimals)),
                                   fmt::arg("unit", unit_sign(first.unit)));
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
