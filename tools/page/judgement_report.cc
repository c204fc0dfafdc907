#include <fmt/format.h>

#include "tools/page/judged_measures.h"
#include "tools/page/other_reports.h"
#include "tools/page/said.h"
#include "tools/plan/judgement_document.h"

namespace g31::page {
namespace {

std::string counts_of(const plan::Judgement& judgement, Language language) {
  const auto of = [&](plan::Verdict verdict) { return count(judgement, verdict); };
  return said(language, Word::SaysJudged, fmt::arg("good", of(plan::Verdict::Good)),
              fmt::arg("all", judgement.measures.size()), fmt::arg("bad", of(plan::Verdict::Bad)),
              fmt::arg("missing", of(plan::Verdict::Missing)));
}

}  // namespace

Report report_of(const plan::Judgement& judgement, const JudgedFiles& files,
                 const PageOrigin& origin) {
  const Language language = origin.language;
  Report report;
  report.language = language;
  report.title = files.results;
  report.what = "g31 judge";
  report.verdict = {Sign::Good, std::string(text_of(Word::StateInTolerance, language)),
                    std::string(text_of(Word::SaysAllGood, language)),
                    counts_of(judgement, language)};
  for (const plan::JudgedMeasure& measure : judgement.measures) {
    report.results.push_back(characteristic_of(measure));
  }
  add_not_good(judgement,
               {Word::SaysJudgedBad, Word::SaysJudgedMissing, Word::SaysJudgedOut,
                Word::SaysJudgedSeveralOut},
               report);
  for (const plan::Remark& remark : judgement.remarks) {
    report.findings.push_back({source::Severity::Warning,
                               "",
                               fmt::format("{}:{}: {}", files.results, remark.line, remark.text),
                               {}});
  }
  report.facts = {{std::string(text_of(Word::Plan, language)), files.plan},
                  {std::string(text_of(Word::File, language)), files.results},
                  {std::string(text_of(Word::Version, language)), origin.version}};
  report.command = origin.command;
  report.inputs = origin.inputs;
  report.caution = Word::CarefulValues;
  report.document = plan::judgement_document(judgement);
  return report;
}

}  // namespace g31::page
