#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/other_reports.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

/// Digits that a result is read to: a tenth of a micrometre, and as much of all else.
constexpr int kDecimals = 4;

Table results_table(const evaluate::Evaluation& evaluation, Language language) {
  Table table{std::string(text_of(Word::Results, language)),
              {std::string(text_of(Word::Characteristic, language)),
               std::string(text_of(Word::Measured, language)), "u",
               std::string(text_of(Word::Unit, language))},
              {}};
  for (const evaluate::Quantity& quantity : evaluation.results) {
    table.rows.push_back({quantity.name, number(quantity.value, kDecimals),
                          number(quantity.u, kDecimals), std::string(quantity.unit)});
  }
  return table;
}

}  // namespace

Report report_of(const evaluate::Evaluation& evaluation, const std::string& file,
                 const std::string& document, const Making& making) {
  const evaluate::KindRow& kind = evaluate::info(evaluation.kind);
  Report report;
  report.language = making.language;
  report.title = file;
  report.what = std::string(kind.text);
  report.verdict.state = std::string(kind.word);
  report.verdict.headline = std::string(kind.text);
  if (!evaluation.results.empty()) {
    const evaluate::Quantity& first = evaluation.results.front();
    report.verdict.headline =
        said(making.language, Word::SaysValue, fmt::arg("name", first.name),
             fmt::arg("value", number(first.value, kDecimals)), fmt::arg("unit", first.unit));
  }
  report.verdict.sentence =
      said(making.language, Word::SaysRowsEvaluated, fmt::arg("rows", evaluation.samples));
  for (const std::string& note : evaluation.notes) {
    report.findings.push_back({source::Severity::Note, "", note, {}});
  }
  report.facts = {{std::string(text_of(Word::File, making.language)), file},
                  {std::string(text_of(Word::Version, making.language)), making.version}};
  report.command = making.command;
  if (!evaluation.svg.empty()) {
    report.drawings.push_back({std::string(kind.word), evaluation.svg, ""});
  }
  report.tables.push_back(results_table(evaluation, making.language));
  report.inputs = making.inputs;
  report.document = document;
  return report;
}

}  // namespace g31::page
