#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/run_report.h"

namespace g31::page {
namespace {

using runtime::Status;

std::string touched(const RunPage& run) {
  const std::size_t ways = run.recorder.touches().size();
  if (ways == 0) {
    return "It made no skip move.";
  }
  return fmt::format("{} of {} skip moves had their signal, in {} s of machine time.",
                     run.recorder.touch_count(), ways, number(run.result.machine_time_s, 1));
}

Verdict measured_out(const RunPage& run, std::span<const Characteristic> results) {
  const auto is_out = [](const Characteristic& row) { return excess_of(row) != 0.0; };
  const auto out = std::ranges::count_if(results, is_out);
  const Characteristic& first = *std::ranges::max_element(
      results, {}, [](const Characteristic& row) { return std::abs(excess_of(row)); });
  Verdict verdict{Sign::Bad, "Out of tolerance", "", ""};
  const double far = excess_of(first);
  verdict.headline =
      out == 1 ? fmt::format("{} is {} µm {} its {} limit.", first.name,
                             number(std::abs(far) * 1000.0, std::abs(far) < 1e-4 ? 4 : 1),
                             far > 0.0 ? "over" : "under", far > 0.0 ? "upper" : "lower")
               : fmt::format("{} of {} characteristics are out of tolerance.", out, results.size());
  verdict.sentence =
      fmt::format("{}: the program measured {}, allowed is {} to {}. ", first.name,
                  number(first.measured, 4), number(*first.nominal + first.tolerance[0], 4),
                  number(*first.nominal + first.tolerance[1], 4));
  if (first.true_size) {
    verdict.sentence +=
        fmt::format("The simulated part is {}: the measurement adds {} µm. ",
                    number(first.true_size, 4), micrometres(*first.measured - *first.true_size));
  }
  verdict.sentence += touched(run);
  return verdict;
}

Verdict completed(const RunPage& run, std::span<const Characteristic> results) {
  if (std::ranges::any_of(results,
                          [](const Characteristic& row) { return excess_of(row) != 0.0; })) {
    return measured_out(run, results);
  }
  const auto unmet = std::ranges::find(run.result.expectations, false, &expect::Judged::holds);
  if (unmet != run.result.expectations.end()) {
    return {Sign::Bad, "Not as expected", fmt::format("{} is not as expected.", unmet->name),
            fmt::format("Expected was {}, it came to {}. {}", unmet->expected, unmet->got,
                        touched(run))};
  }
  const auto judged = std::ranges::count_if(
      results, [](const Characteristic& row) { return row.nominal.has_value(); });
  if (run.result.exit_code != 0) {
    return {Sign::Bad, "Completed with findings", "The program ran to its end, with findings.",
            "What was found stands beside. " + touched(run)};
  }
  if (judged > 0) {
    return {Sign::Good, "In tolerance",
            judged == 1 ? "The characteristic is in tolerance."
                        : fmt::format("All {} characteristics are in tolerance.", judged),
            touched(run)};
  }
  return {Sign::Good, "Completed", "The program ran to its end.", touched(run)};
}

}  // namespace

Verdict verdict_of(const RunPage& run, std::span<const Characteristic> results) {
  const runtime::Outcome& outcome = run.result.outcome;
  if (outcome.status != Status::Completed && run.result.exit_code == 0) {
    return {Sign::Good, "As expected", "The run ended as it was expected to.", touched(run)};
  }
  switch (outcome.status) {
    case Status::Completed:
      return completed(run, results);
    case Status::Collision:
      return {Sign::Broken, "Collision",
              run.recorder.fault() ? fmt::format("{}.", run.recorder.fault()->what)
                                   : "The run ended in a collision.",
              "What the program did behind it is not known. " + touched(run)};
    case Status::Alarm:
    case Status::SyntaxError:
      if (outcome.alarm) {
        return {Sign::Broken, fmt::format("Alarm {}", outcome.alarm->number),
                fmt::format("Alarm {} stopped the program: {}", outcome.alarm->number,
                            outcome.alarm->text),
                touched(run)};
      }
      return outcome.status == Status::Alarm
                 ? Verdict{Sign::Broken, "Alarm", "An alarm stopped the program.", touched(run)}
                 : Verdict{Sign::Broken, "Not run", "The program cannot be read.", ""};
    case Status::Setup:
      return {Sign::Broken, "Set-up", "The set-up does not fit the program.", touched(run)};
    case Status::Budget:
      return {Sign::Broken, "Limit reached", "The run was ended by its limits.", touched(run)};
    case Status::Interrupted:
      return {Sign::Broken, "Interrupted", "The run was interrupted.", touched(run)};
    case Status::Defect:
      break;
  }
  return {Sign::Broken, "Defect of g31", "g31 itself has a defect here.", touched(run)};
}

}  // namespace g31::page
