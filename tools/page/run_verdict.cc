#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/run_report.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

using runtime::Status;
using Rows = std::span<const Characteristic>;

/// What a verdict is made of.
struct Case {
  const RunPage& run;
  Rows results;
  Language language;

  [[nodiscard]] std::string word(Word name) const { return std::string(text_of(name, language)); }
};

std::string touched(const Case& of) {
  const std::size_t ways = of.run.recorder.touches().size();
  return ways == 0 ? of.word(Word::SaysNoSkip)
                   : said(of.language, Word::SaysTouched,
                          fmt::arg("hits", of.run.recorder.touch_count()), fmt::arg("ways", ways),
                          fmt::arg("seconds", number(of.run.result.machine_time_s, 1)));
}

Verdict with_touches(Sign sign, const Case& of, Word state, Word headline) {
  return {sign, of.word(state), of.word(headline), touched(of)};
}

/// A value of a row with its unit.
std::string value_text(const Characteristic& row, const std::optional<double>& value) {
  const std::string_view unit = unit_name(row);
  return number(value, decimals_of(row)) +
         (unit.empty() ? std::string() : fmt::format(" {}", unit));
}

/// How far it is beyond its limit, without a sign; so small an amount has more digits.
std::string amount_text(const Characteristic& row) {
  constexpr double kSmallMm = 1e-4;
  const double far = std::abs(excess_of(row));
  if (row.unit && row.unit->mm > 0.0) {
    const double far_mm = far * row.unit->mm;
    return significant(far_mm * kUmPerMm, far_mm < kSmallMm ? 4 : 1) + " µm";
  }
  const std::string_view unit = unit_name(row);
  return significant(far, decimals_of(row)) +
         (unit.empty() ? std::string() : fmt::format(" {}", unit));
}

Verdict measured_out(const Case& of) {
  const auto out = std::ranges::count_if(of.results, is_out);
  const Characteristic& worst = *std::ranges::max_element(
      of.results, {}, [](const Characteristic& row) { return std::abs(excess_of(row)); });
  Verdict verdict{Sign::Bad, of.word(Word::StateOut), "", ""};
  verdict.headline = said(of.language, excess_of(worst) > 0.0 ? Word::SaysOver : Word::SaysUnder,
                          fmt::arg("name", worst.name), fmt::arg("amount", amount_text(worst)));
  if (out > 1) {
    verdict.sentence =
        said(of.language, Word::SaysOut, fmt::arg("out", out), fmt::arg("all", of.results.size())) +
        " ";
  }
  verdict.sentence +=
      said(of.language, Word::SaysMeasured, fmt::arg("name", worst.name),
           fmt::arg("measured", value_text(worst, worst.measured)),
           fmt::arg("lower", number(*worst.nominal + worst.tolerance->lower, decimals_of(worst))),
           fmt::arg("upper", value_text(worst, *worst.nominal + worst.tolerance->upper))) +
      " ";
  if (worst.true_size) {
    verdict.sentence +=
        said(of.language, Word::SaysTrue, fmt::arg("truth", value_text(worst, worst.true_size)),
             fmt::arg("error", difference_text(worst, *worst.measured - *worst.true_size))) +
        " ";
  }
  verdict.sentence += touched(of);
  return verdict;
}

/// @pre some of the results have a tolerance, and all of these are in it
Verdict measured_in(const Case& of) {
  std::vector<std::string> names;
  for (const Characteristic& row : of.results) {
    if (row.tolerance) {
      names.push_back(row.name);
    }
  }
  const Word sentence = names.size() == 1   ? Word::SaysOneIn
                        : names.size() == 2 ? Word::SaysTwoIn
                                            : Word::SaysAllIn;
  return {Sign::Good, of.word(Word::StateInTolerance),
          said(of.language, sentence, fmt::arg("name", names.front()),
               fmt::arg("other", names.back()), fmt::arg("others", names.size() - 1)),
          touched(of)};
}

Verdict completed(const Case& of) {
  if (std::ranges::any_of(of.results, is_out)) {
    return measured_out(of);
  }
  const report::RunResult& result = of.run.result;
  const auto unmet = std::ranges::find(result.expectations, false, &expect::Judged::holds);
  if (unmet != result.expectations.end()) {
    return {Sign::Bad, of.word(Word::StateNotAsExpected),
            said(of.language, Word::SaysNotExpected, fmt::arg("name", unmet->name)),
            said(of.language, Word::SaysExpected, fmt::arg("expected", unmet->expected),
                 fmt::arg("got", unmet->got)) +
                " " + touched(of)};
  }
  if (result.exit_code != 0) {
    return {Sign::Bad, of.word(Word::StateFindings), of.word(Word::SaysFindings),
            of.word(Word::SaysSeeFindings) + " " + touched(of)};
  }
  const bool is_judged = std::ranges::any_of(
      of.results, [](const Characteristic& row) { return row.tolerance.has_value(); });
  return is_judged ? measured_in(of)
                   : with_touches(Sign::Good, of, Word::StateCompleted, Word::SaysToEnd);
}

Verdict stopped(const Case& of) {
  const auto& alarm = of.run.result.outcome.alarm;
  if (alarm) {
    return {Sign::Broken,
            said(of.language, Word::StateAlarmNumber, fmt::arg("number", alarm->number)),
            said(of.language, Word::SaysAlarm, fmt::arg("number", alarm->number),
                 fmt::arg("text", alarm->text)),
            touched(of)};
  }
  return of.run.result.outcome.status == Status::Alarm
             ? with_touches(Sign::Broken, of, Word::StateAlarm, Word::SaysAnAlarm)
             : Verdict{Sign::Broken, of.word(Word::StateNotRun), of.word(Word::SaysUnreadable), ""};
}

Verdict collided(const Case& of) {
  const auto& fault = of.run.recorder.fault();
  return {Sign::Broken, of.word(Word::StateCollision),
          fault && fault->contact
              ? said(of.language, Word::SaysCollided, fmt::arg("what", fault->what),
                     fmt::arg("part", fault->contact->part))
              : of.word(Word::SaysCollision),
          of.word(Word::SaysNotKnown) + " " + touched(of)};
}

}  // namespace

Verdict verdict_of(const RunPage& run, Rows results, Language language) {
  const Case of{run, results, language};
  const Status status = run.result.outcome.status;
  if (status != Status::Completed && run.result.exit_code == 0) {
    return with_touches(Sign::Good, of, Word::StateAsExpected, Word::SaysAsExpected);
  }
  switch (status) {
    case Status::Completed:
      return completed(of);
    case Status::Collision:
      return collided(of);
    case Status::Alarm:
    case Status::SyntaxError:
      return stopped(of);
    case Status::Setup:
      return with_touches(Sign::Broken, of, Word::SetUp, Word::SaysSetUp);
    case Status::Budget:
      return with_touches(Sign::Broken, of, Word::StateLimit, Word::SaysLimit);
    case Status::Interrupted:
      return with_touches(Sign::Broken, of, Word::StateInterrupted, Word::SaysInterrupted);
    case Status::Defect:
      break;
  }
  return with_touches(Sign::Broken, of, Word::StateDefect, Word::SaysDefect);
}

}  // namespace g31::page
