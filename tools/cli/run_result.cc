#include "tools/cli/run_result.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"
#include "tools/cli/write_out.h"
#include "tools/session/analysed_programs.h"

namespace g31::cli {
namespace {

/// What is the matter with the probe; "" for nothing.
std::string probe_state_of(const setup::Job& job) {
  for (const auto& [state, name] : probe::kProbeStateNames) {
    if (job.probe && job.probe->state == state && state != probe::ProbeState::Ready) {
      return std::string(name);
    }
  }
  return {};
}

std::string shown(const runtime::ShownValue& value) {
  return std::visit(runtime::Overloaded{
                        [](runtime::Cell cell) {
                          return cell.is_vacant() ? "null" : fmt::format("{}", cell.raw());
                        },
                        [](const std::string& text) { return source::text_as_utf8(text); },
                    },
                    value);
}

/// The document has as much time as the run, but a minute at least: a run that has spent its own is
/// told, too.
std::optional<session::Refusal> write_document(const OpenedRun& opened,
                                               const report::RunResult& result) {
  constexpr double kLeastSeconds = 60.0;
  runtime::TimeBudget time(std::max(kLeastSeconds, opened.options.budget.wall_seconds));
  const RunOptions& options = opened.options;
  const auto write = [&](disk::PartFile& file) {
    report::write_run_document(result, opened.recorder, opened.sources,
                               {options.moves, options.touches, options.blocks},
                               [&](std::string_view piece) {
                                 file.write(piece);
                                 time.look();
                               });
  };
  try {
    return write_out(opened.options.json, write);
  } catch (const runtime::BudgetSpent&) {
    return session::Refusal{
        session::Ending::Budget,
        fmt::format("{}: the limit of computing time is reached with the writing of the "
                    "document: --max-time raises it",
                    opened.options.json)};
  }
}

/// What of the programs ran.
std::vector<coverage::FileCoverage> coverage_of(const OpenedRun& opened) {
  source::SourceMap texts(opened.sources.files());
  const auto programs =
      session::analysed_programs(opened.prepared.control, texts, opened.prepared.job.control);
  return coverage::coverage_of(opened.chronicle->counts(), opened.sources, *programs, texts);
}

}  // namespace

report::RunResult result_of(const OpenedRun& opened, const session::Heard& heard) {
  report::RunResult result;
  result.version = opened.options.version;
  if (opened.inputs != nullptr) {
    opened.inputs->add(opened.disk);
    result.inputs = opened.inputs->files();
  }
  result.program = opened.options.programs.front();
  result.control = session::name_of(opened.prepared.control);
  result.seed = opened.options.seed;
  result.outcome = heard.outcome;
  result.allowed = heard.allowed;
  result.optional_stop = opened.options.optional_stop;
  result.files = opened.run.changed_files();
  result.machine_time_s = opened.machine.time_s();
  result.probe_state = probe_state_of(opened.prepared.job);
  if (opened.chronicle != nullptr) {
    result.chronicle = opened.chronicle;
    result.coverage = coverage_of(opened);
  }
  return result;
}

std::optional<session::Refusal> print_values(const OpenedRun& opened,
                                             const report::RunResult& result) {
  if (opened.options.json == "-" || opened.options.jsonl == "-") {
    return std::nullopt;
  }
  std::string text;
  for (const auto& [name, value] : result.variables) {
    text += fmt::format("{} = {}\n", name, shown(value));
  }
  for (const report::ValueChange& change :
       result.changes.value_or(std::vector<report::ValueChange>())) {
    text +=
        fmt::format("{} = {} (was {})\n", change.name, shown(change.after), shown(change.before));
  }
  return write_out("-", text);
}

std::optional<session::Refusal> deliver(const OpenedRun& opened, const report::RunResult& result) {
  return opened.options.json.empty() ? std::nullopt : write_document(opened, result);
}

}  // namespace g31::cli
