#include "tools/page/judged_measures.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::string named(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 3;
  const std::span<const std::string> first(names.data(), std::min(names.size(), kMostNamed));
  const std::string text = fmt::format("{}", fmt::join(first, ", "));
  return names.size() > kMostNamed ? fmt::format("{} … ({})", text, names.size()) : text;
}

void add_not_good(const plan::Judgement& judgement, const JudgedWords& words, Report& report) {
  std::vector<std::string> names;
  for (const plan::JudgedMeasure& judged : judgement.measures) {
    if (judged.verdict == plan::Verdict::Good) {
      continue;
    }
    const Characteristic row = characteristic_of(judged);
    report.findings.push_back(
        {source::Severity::Error,
         "",
         why_not_good(row, judged.verdict == plan::Verdict::Bad, words, report.language),
         {}});
    names.push_back(row.name);
  }
  if (names.empty()) {
    return;
  }
  report.verdict.sign = Sign::Bad;
  const bool is_any_bad = count(judgement, plan::Verdict::Bad) > 0;
  report.verdict.state =
      text_of(is_any_bad ? Word::StateOut : Word::StateIncomplete, report.language);
  report.verdict.headline = said(report.language, names.size() == 1 ? words.one : words.several,
                                 fmt::arg("names", named(names)));
}

}  // namespace g31::page
