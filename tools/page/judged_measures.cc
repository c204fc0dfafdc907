#include "tools/page/judged_measures.h"

#include <fmt/format.h>

#include "tools/page/said.h"

namespace g31::page {
namespace {

std::string why_not_good(const Characteristic& row, bool is_bad, const JudgedWords& words,
                         Language language) {
  if (!is_bad) {
    return said(language, words.missing, fmt::arg("name", row.name));
  }
  return said(language, words.bad, fmt::arg("name", row.name),
              fmt::arg("deviation", difference_text(row, deviation_of(row))),
              fmt::arg("lower", difference_text(row, row.tolerance->lower)),
              fmt::arg("upper", difference_text(row, row.tolerance->upper)));
}

}  // namespace

Characteristic characteristic_of(const plan::JudgedMeasure& judged) {
  const plan::Measure& measure = judged.measure;
  Characteristic row;
  row.name = measure.id;
  row.variable = measure.printed;
  row.unit = expect::kResultUnits[0];
  row.nominal = measure.nominal;
  if (measure.tolerance) {
    row.tolerance = expect::Limits{measure.tolerance->lower, measure.tolerance->upper};
  }
  row.measured = judged.actual;
  return row;
}

void add_not_good(const plan::Judgement& judgement, const JudgedWords& words, Report& report) {
  constexpr std::size_t kMostNamed = 3;
  std::string names;
  std::size_t out = 0;
  for (std::size_t i = 0; i < judgement.measures.size(); ++i) {
    const plan::Verdict verdict = judgement.measures[i].verdict;
    if (verdict == plan::Verdict::Good) {
      continue;
    }
    const Characteristic& row = report.results[i];
    report.findings.push_back(
        {source::Severity::Error,
         "",
         why_not_good(row, verdict == plan::Verdict::Bad, words, report.language),
         {}});
    names += ++out > kMostNamed ? "" : (names.empty() ? "" : ", ") + row.name;
  }
  if (out == 0) {
    return;
  }
  report.verdict.sign = Sign::Bad;
  const bool is_any_bad = count(judgement, plan::Verdict::Bad) > 0;
  report.verdict.state =
      text_of(is_any_bad ? Word::StateOut : Word::StateIncomplete, report.language);
  report.verdict.headline =
      said(report.language, out == 1 ? words.one : words.several,
           fmt::arg("names", out > kMostNamed ? fmt::format("{} … ({})", names, out) : names));
}

}  // namespace g31::page
