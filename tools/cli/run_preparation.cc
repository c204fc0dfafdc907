#include "tools/cli/run_preparation.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/diagnostic.h"
#include "machine/base/contract.h"
#include "tools/cli/variables_file.h"
#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"
#include "tools/setup/assignment.h"
#include "tools/setup/duration.h"
#include "tools/setup/name_list.h"
#include "tools/setup/toml_reader.h"

namespace g31::cli {

Result<ChosenControl, Refusal> chosen_control(const RunOptions& options, const setup::Job& job) {
  std::string name = !options.control.empty() ? options.control : job.control.profile;
  if (name.empty() && !options.programs.empty()) {
    constexpr std::size_t kBeginning = 64;  // bytes: a header stands first
    disk::Disk disk;
    const auto beginning = disk.read_part(options.programs.front(), 0, kBeginning);
    name = control_of_program(options.programs.front(), beginning.value_or(""));
  }
  const auto control = control_named(name.empty() ? kDefaultControl : std::string_view(name));
  if (!control) {
    return refusal(ExitCode::Setup, control.error());
  }
  return control.value();
}

std::optional<Refusal> take_variables(const RunOptions& options, setup::Job& job) {
  auto& variables = job.control.variables;
  disk::Disk disk;
  if (!job.control.variables_file.empty()) {
    if (const auto text = disk.read(job.control.variables_file)) {
      auto kept = parse_variables_text(*text);
      if (!kept) {
        return refusal(ExitCode::BadUsage,
                       fmt::format("{}: {}", job.control.variables_file, kept.error()));
      }
      auto merged = kept.value();
      for (const auto& [name, value] : variables) {
        merged[name] = value;
      }
      variables = std::move(merged);
    }
  }
  for (const std::string& text : options.assignments) {
    auto assignment = setup::parse_assignment(text);
    if (!assignment) {
      return refusal(ExitCode::BadUsage, fmt::format("--set {}: {}", text, assignment.error()));
    }
    variables[assignment.value().name] = assignment.value().value;
  }
  return std::nullopt;
}

Refusal refusal(ExitCode code, std::string_view message) {
  return {code, fmt::format("g31: error: {}\n", message)};
}

Refusal refusal_of(const setup::SetupErrors& errors) {
  Refusal wrong;
  for (const setup::SetupError& error : errors) {
    wrong.text += setup::render(error);
    if (error.code == setup::code_of(setup::SetupErrorId::FileNotFound)) {
      wrong.code = ExitCode::Setup;
    }
  }
  return wrong;
}

Result<Prepared, Refusal> prepare(const RunOptions& options) {
  Prepared prepared;
  auto job = setup::read_job(options.setups, disk::shipped_folder("machine/library").value_or(""));
  if (!job) {
    return refusal_of(job.error());
  }
  prepared.job = job.value();
  const auto control = chosen_control(options, prepared.job);
  if (!control) {
    return control.error();
  }
  prepared.control = control.value();
  if (auto wrong = take_variables(options, prepared.job)) {
    return *wrong;
  }
  const auto period = setup::parse_duration(options.trace_period);
  if (!period) {
    return refusal(ExitCode::BadUsage, fmt::format("--trace-period: {}", period.error()));
  }
  prepared.trace_period_s = period.value();
  for (const std::string& list : options.prints) {
    auto names = setup::parse_name_list(list);
    if (!names) {
      return refusal(ExitCode::BadUsage, fmt::format("--print {}: {}", list, names.error()));
    }
    prepared.prints.insert(prepared.prints.end(), names.value().begin(), names.value().end());
  }
  return prepared;
}

ExitCode exit_code_of(const runtime::Outcome& outcome) {
  switch (outcome.status) {
    case runtime::Status::Completed: {
      const bool findings =
          std::ranges::any_of(outcome.diagnostics, [](const source::Diagnostic& diagnostic) {
            return diagnostic.severity != source::Severity::Note;
          });
      return findings ? ExitCode::Findings : ExitCode::Completed;
    }
    case runtime::Status::Alarm:
      return ExitCode::Alarm;
    case runtime::Status::Collision:
      return ExitCode::Collision;
    case runtime::Status::Setup:
      return ExitCode::Setup;
    case runtime::Status::Budget:
      return ExitCode::Budget;
    case runtime::Status::SyntaxError:
      return ExitCode::BadUsage;
  }
  contract_violated("every status has an exit code", __FILE__, __LINE__);
}

void print_diagnostics(const runtime::Outcome& outcome) {
  for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
    std::fputs(render_text(diagnostic).c_str(), stderr);
  }
}

ExitCode refuse(const Refusal& wrong) {
  std::fputs(wrong.text.c_str(), stderr);
  return wrong.code;
}

}  // namespace g31::cli
