#include <algorithm>

#include <fmt/format.h>

#include "tools/page/charts.h"
#include "tools/page/html.h"
#include "tools/page/other_reports.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

constexpr int kStudyDecimals = 6;

/// The rows of one point, in the order of their runs.
std::vector<double> readings_at(const study::Record& record, std::size_t point,
                                std::size_t result) {
  std::vector<double> values;
  const std::size_t repeats = std::max<std::size_t>(record.description.repeats, 1);
  for (const study::Row& row : record.rows) {
    if (row.run / repeats == point && result < row.results.size() && row.results[result]) {
      values.push_back(*row.results[result]);
    }
  }
  return values;
}

std::string point_name(const study::Description& study, std::size_t point) {
  std::string name;
  for (std::size_t i = 0; i < study.listed.size() && point < study.points.size(); ++i) {
    name += fmt::format("{}{} = {}", i > 0 ? ", " : "", study.listed[i], study.points[point][i]);
  }
  return name;
}

/// Of a result, where listed values stand at a point.
std::string result_name(const study::Description& study, std::size_t result, std::size_t point) {
  const std::string where = point_name(study, point);
  const std::string& name = study.results[result].name;
  return where.empty() ? name : fmt::format("{}, {}", name, where);
}

std::string interval_text(const std::optional<study::Interval>& interval) {
  return interval ? fmt::format("{} … {}", significant(interval->low, kStudyDecimals),
                                significant(interval->high, kStudyDecimals))
                  : number(std::nullopt, kStudyDecimals);
}

Table summary_table(const study::Record& record, Language language) {
  const study::Description& study = record.description;
  const auto say = [language](Word name) { return std::string(text_of(name, language)); };
  Table table{say(Word::Results),
              {say(Word::Characteristic), "n", say(Word::Mean),
               said(language, Word::MeanInterval, fmt::arg("percent", study.confidence_percent)),
               "s", say(Word::Least), say(Word::Most), say(Word::Bias), "U (k = 2)",
               say(Word::Known), say(Word::Published), say(Word::Unit)},
              {},
              {},
              true};
  const std::size_t points = std::max<std::size_t>(study.points.size(), 1);
  for (std::size_t point = 0; point < points; ++point) {
    for (std::size_t i = 0; i < study.results.size(); ++i) {
      const study::ResultForm& form = study.results[i];
      const study::Summary summary = study::summary_of(record, point, i);
      std::string published;
      for (const double value : form.published) {
        published += (published.empty() ? "" : ", ") + significant(value, kStudyDecimals);
      }
      table.rows.push_back(
          {result_name(study, i, point), fmt::format("{}", summary.n),
           significant(summary.mean, kStudyDecimals), interval_text(summary.mean_confidence),
           significant(summary.standard_deviation, kStudyDecimals),
           significant(summary.min, kStudyDecimals), significant(summary.max, kStudyDecimals),
           significant(summary.bias, kStudyDecimals, ShowSign::Always),
           significant(summary.expanded_uncertainty, kStudyDecimals),
           significant(form.expected, kStudyDecimals), published.empty() ? "–" : published,
           form.unit});
    }
  }
  return table;
}

void add_charts(const study::Record& record, Report& report) {
  const study::Description& study = record.description;
  const std::size_t points = std::max<std::size_t>(study.points.size(), 1);
  for (std::size_t point = 0; point < points; ++point) {
    for (std::size_t i = 0; i < study.results.size(); ++i) {
      if (report.drawings.size() + 2 > kMostCharts) {
        return;
      }
      const study::ResultForm& form = study.results[i];
      const study::Summary summary = study::summary_of(record, point, i);
      const Readings readings{
          readings_at(record, point, i), form.unit, form.expected, form.published, summary.mean,
          summary.standard_deviation};
      if (readings.values.empty()) {
        continue;
      }
      const std::string name = result_name(study, i, point);
      report.drawings.push_back({name, histogram(readings, report.language),
                                 std::string(text_of(Word::SaysHistogram, report.language)), true});
      report.drawings.push_back({name, run_chart(readings, report.language),
                                 std::string(text_of(Word::SaysRunChart, report.language)), true});
    }
  }
}

}  // namespace

Report report_of(const study::Record& record, const std::string& document,
                 const PageOrigin& origin) {
  const study::Description& study = record.description;
  const auto statuses = study::count_by_status(record);
  const auto completed = statuses.find("completed");
  const std::size_t whole = completed == statuses.end() ? 0 : completed->second;
  Report report;
  report.language = origin.language;
  report.title = study.name;
  report.what = fmt::format("{}, {}", study.program, study.control);
  const bool is_whole = whole == record.rows.size();
  report.verdict = {
      is_whole ? Sign::Good : Sign::Bad,
      std::string(text_of(is_whole ? Word::StateAllRuns : Word::StateRunsLeftOut, origin.language)),
      said(origin.language, Word::SaysRuns, fmt::arg("whole", whole),
           fmt::arg("all", record.rows.size())),
      ""};
  if (!study.results.empty()) {
    const study::Summary summary = study::summary_of(record, 0, 0);
    const study::ResultForm& form = study.results.front();
    report.verdict.sentence = said(
        origin.language, Word::SaysMean, fmt::arg("name", result_name(study, 0, 0)),
        fmt::arg("mean", significant(summary.mean, kStudyDecimals)), fmt::arg("unit", form.unit),
        fmt::arg("deviation", significant(summary.standard_deviation, kStudyDecimals)),
        fmt::arg("readings", summary.n));
  }
  for (const auto& [status, count] : statuses) {
    if (status != "completed") {
      report.findings.push_back({source::Severity::Warning,
                                 "",
                                 said(origin.language, Word::SaysRunsEnded,
                                      fmt::arg("count", count), fmt::arg("status", status)),
                                 {}});
    }
  }
  const auto fact = [&](Word name, std::string value) {
    report.facts.emplace_back(text_of(name, origin.language), std::move(value));
  };
  fact(Word::Program, study.program);
  fact(Word::Control, study.control);
  fact(Word::Runs, fmt::format("{}", record.rows.size()));
  fact(Word::Seed, fmt::format("{}", study.seed));
  fact(Word::ExitCode, fmt::format("{}", origin.exit_code));
  fact(Word::Version, origin.version);
  report.command = origin.command;
  report.tables.push_back(summary_table(record, origin.language));
  add_charts(record, report);
  report.inputs = origin.inputs;
  report.limits = study.assumes;
  report.document = document;
  return report;
}

}  // namespace g31::page
