#include "tools/cli/run_expectations.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/readable_text.h"
#include "tools/disk/disk.h"
#include "tools/setup/name_list.h"
#include "tools/setup/variable_name.h"

namespace g31::cli {
namespace {

using session::Refusal;

std::size_t count_findings(const runtime::Outcome& outcome) {
  return static_cast<std::size_t>(
      std::ranges::count_if(outcome.diagnostics, [](const source::Diagnostic& message) {
        return message.severity == source::Severity::Warning;
      }));
}

/// The one spelling of the variable that a row is about; "": it is about something else.
std::string variable_of(const expect::Expectation& row) {
  const auto* const variable = std::get_if<expect::Variable>(&row.what);
  return variable == nullptr ? std::string()
                             : setup::normal_variable_name(variable->name).value_or(variable->name);
}

/// Puts a row in the place of that of the same variable, as a later sheet would, or behind all.
void lay_over(expect::Expectations& below, const expect::Expectation& row) {
  const auto same = std::ranges::find(below.rows, variable_of(row), variable_of);
  if (same != below.rows.end()) {
    *same = row;
  } else {
    below.rows.push_back(row);
  }
}

/// What --expect has said of a variable.
struct Said {
  std::string text;
  bool is_alone;  ///< the variable is not one of several
};
using SaidOf = std::map<std::string, Said>;

/// Why a variable may not be expected once more; "": it may.  One alone may differ from the others
/// of a range that was given before it; all else would do away with what was asked for.
std::string why_not_again(SaidOf& said_of, const std::string& variable, const Said& said) {
  const auto [earlier, is_first] = said_of.try_emplace(variable, said);
  if (is_first) {
    return {};
  }
  if (!said.is_alone || earlier->second.is_alone) {
    return fmt::format("{} is expected by --expect {}, too: keep one of them", variable,
                       earlier->second.text);
  }
  earlier->second = said;
  return {};
}

}  // namespace

Result<expect::Expectations, Refusal> expectations_of(
    const setup::Job& job, const std::vector<std::string>& from_command_line) {
  expect::Expectations all = job.expectations;
  SaidOf said_of;
  for (const std::string& text : from_command_line) {
    const auto refused = [&](const std::string& why) {
      return session::bad_input(fmt::format("--expect {}: {}", text, why));
    };
    const auto expectation = expect::parse_expectation(text);
    if (!expectation) {
      return refused(expectation.error());
    }
    expect::Expectation row = expectation.value();
    auto& variable = std::get<expect::Variable>(row.what);
    const auto names = setup::parse_name_list(variable.name);
    if (!names) {
      return refused(names.error());
    }
    for (const std::string& name : names.value()) {
      variable.name = name;
      const auto again =
          why_not_again(said_of, variable_of(row), {text, names.value().size() == 1});
      if (!again.empty()) {
        return refused(again);
      }
      lay_over(all, row);
    }
  }
  return all;
}

std::optional<runtime::ShownValue> value_of(const OpenedRun& opened, const std::string& name) {
  const auto value = opened.run.session().variable(name);
  return value ? std::optional(value.value()) : std::nullopt;
}

expect::Actual actual_of(const OpenedRun& opened, const runtime::Outcome& outcome,
                         const ResultWatch& watch) {
  expect::Actual actual;
  actual.status = session::status_name(outcome);
  actual.alarm = outcome.alarm ? std::optional(outcome.alarm->number) : std::nullopt;
  actual.variable = [&](const std::string& name) { return value_of(opened, name); };
  actual.result = [&](const std::string& name) {
    auto value = value_of(opened, name);
    return value && watch.is_from_before(name, *value) ? std::nullopt : std::move(value);
  };
  actual.work_offset = [&](const std::string& name, char axis) {
    return opened.run.session().work_offset(name, axis_index(axis));
  };
  actual.file = [](const std::string& path) -> std::optional<std::string> {
    disk::Disk disk;
    const auto text = disk.read(path);
    return text ? std::optional(source::readable_text(*text)) : std::nullopt;
  };
  actual.output = opened.recorder.output();
  actual.touches = opened.recorder.touch_count();
  actual.findings = count_findings(outcome);
  actual.machine_time_s = opened.machine.time_s();
  return actual;
}

std::vector<source::Diagnostic> failures_of(const std::vector<expect::Judged>& judged) {
  std::vector<source::Diagnostic> failures;
  for (const expect::Judged& row : judged) {
    if (!row.holds) {
      failures.push_back(source::make_diagnostic(
          source::DiagnosticId::ExpectationFailed, {},
          fmt::format("{}: expected {}, got {}", row.name, row.expected, row.got)));
      failures.back().in_sheet = row.place;
      if (!row.remedy.empty()) {
        failures.back().remedy = row.remedy;
      }
    }
  }
  return failures;
}

}  // namespace g31::cli
