#include "tools/study/study_programs.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/time_budget.h"
#include "interpreter/source/diagnostic.h"

namespace g31::study {
namespace {

using session::Refusal;

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// Why a run ended that did not complete: the last message says it.
std::string note_of(const runtime::Outcome& outcome, const source::SourceMap& sources) {
  return outcome.diagnostics.empty() ? std::string(session::status_name(outcome))
                                     : first_line(render_text(outcome.diagnostics.back(), sources));
}

/// The first message of a completed run that makes it one with findings.
std::string first_finding(const runtime::Outcome& outcome, const source::SourceMap& sources) {
  const auto finding = std::ranges::find_if(outcome.diagnostics, [](const auto& message) {
    return message.severity != source::Severity::Note;
  });
  return finding != outcome.diagnostics.end() ? first_line(render_text(*finding, sources)) : "";
}

double rounded(double reading, const std::optional<double>& resolution) {
  if (!resolution) {
    return reading;
  }
  // 0.001 is no double, 1000 is one.
  const double steps = std::round(1.0 / *resolution);
  return std::fabs(steps * *resolution - 1.0) < 1e-9
             ? std::round(reading * steps) / steps
             : std::round(reading / *resolution) * *resolution;
}

std::optional<double> evaluated_value(const std::optional<evaluate::Evaluation>& evaluation,
                                      const std::string& name) {
  if (!evaluation) {
    return std::nullopt;
  }
  const auto found = std::ranges::find(evaluation->results, name, &evaluate::Quantity::name);
  return found != evaluation->results.end() ? found->value : std::nullopt;
}

/// nullopt: vacant, a text, or no variable of this control
std::optional<double> number_of(session::Session& session, const std::string& name) {
  const auto value = session.variable(name);
  const auto* const cell = value.ok() ? std::get_if<runtime::Cell>(&value.value()) : nullptr;
  return cell != nullptr && !cell->is_vacant() ? std::optional(cell->raw()) : std::nullopt;
}

/// Before the program ran.
std::optional<std::string> why_no_number(session::Session& session, const std::string& name) {
  const auto value = session.variable(name);
  if (!value) {
    return fmt::format("{}: {}", name, value.error());
  }
  const bool is_text = std::holds_alternative<std::string>(value.value());
  return is_text ? std::optional(fmt::format("{}: it is a text", name)) : std::nullopt;
}

}  // namespace

EndedProgram not_begun(const Refusal& refusal) {
  return {"setup", refusal.ending, first_line(render(refusal)), {}, {}};
}

StudyPrograms::StudyPrograms(const Study& study) : study_(study), paths_(study.before) {
  paths_.push_back(study.program);
  for (const StudyResult& result : study.results) {
    for (const std::string& name : result.expression.variables()) {
      if (std::ranges::find(variables_, name) == variables_.end()) {
        variables_.push_back(name);
      }
    }
  }
}

std::optional<Refusal> StudyPrograms::open(const setup::Job& job) {
  const auto chosen = session::chosen_control(request_of(main()), job, disk_);
  if (!chosen) {
    return chosen.error();
  }
  control_ = chosen.value();
  comments_.emplace(disk_, *control_);
  for (std::size_t program = 0; program < paths_.size(); ++program) {
    const auto opened = session::open_programs(*control_, request_of(program), disk_, job.control);
    if (!opened) {
      return opened.error();
    }
    programs_.push_back(opened.value());
  }
  return std::nullopt;
}

std::optional<Refusal> StudyPrograms::why_not(const setup::Job& job) {
  runtime::Observer nobody;
  machine::MachiningCentre machine(job.machine, nullptr);
  const auto control = programs_.back()->session(machine, nobody);
  if (const auto refused = control->configure(job.control); !refused.empty()) {
    return session::refused_settings(job, refused);
  }
  for (const std::string& name : variables_) {
    if (const auto wrong = why_no_number(*control, name)) {
      return session::bad_input(fmt::format("a result reads {}", *wrong));
    }
  }
  return std::nullopt;
}

std::string StudyPrograms::rendered(const source::Diagnostic& finding) const {
  return render_text(finding, programs_.back()->sources());
}

session::Request StudyPrograms::request_of(std::size_t program) const {
  session::Request request;
  request.control = study_.control;
  request.programs = {paths_[program]};
  request.libraries = study_.libraries;
  return request;
}

EndedProgram StudyPrograms::run(const setup::Job& job, const Result<StudyParts, Refusal>& parts,
                                std::size_t program, std::uint64_t seed) {
  if (!parts) {
    return not_begun(parts.error());
  }
  try {
    return carry_out(job, parts.value(), program, seed);
  } catch (const std::exception& defect) {
    return {"defect", session::Ending::Defect, defect.what(), {}, {}};
  }
}

EndedProgram StudyPrograms::carry_out(const setup::Job& job, const StudyParts& parts,
                                      std::size_t program, std::uint64_t seed) {
  const auto surroundings = session::surroundings_of(job, parts.sensed, seed);
  machine::MachiningCentre machine(job.machine, surroundings.get());
  runtime::TimeBudget time(study_.max_time_s, study_.interruption);
  machine.watch(time);
  runtime::Observer nobody;
  const auto control = programs_[program]->session(machine, nobody);
  if (const auto refused = control->configure(job.control); !refused.empty()) {
    return {"setup", session::Ending::Setup, refused.front().message, {}, {}};
  }
  runtime::OutputBudget output(study_.max_output);
  const auto inside = session::start_inside(job, machine);
  std::optional<PathRecorder> path;
  if (program == main() && study_.evaluation) {
    machine.trace(study_.evaluation->trace_period_s, path.emplace(*study_.evaluation, output));
  }
  runtime::Outcome outcome =
      control->run({study_.max_blocks, study_.max_time_s, &output, study_.interruption});
  machine.end_trace();
  EndedProgram ended;
  ended.status = session::status_name(outcome);
  const source::SourceMap& sources = programs_[program]->sources();
  if (inside) {
    ended.note = first_line(render_text(*inside, sources));
    outcome = session::with_findings({*inside}, outcome);
  }
  outcome = session::heard(session::with_findings(parts.findings, outcome), *comments_,
                           paths_[program], {}, sources)
                .outcome;
  ended.ending = session::ending_of(outcome);
  if (ended.note.empty() && ended.ending == session::Ending::Findings) {
    ended.note = first_finding(outcome, sources);
  }
  if (outcome.status != runtime::Status::Completed) {
    ended.note = note_of(outcome, sources);
  } else if (program == main()) {
    take_results(*control, path, ended);
  } else {
    ended.permanent = control->permanent_variables();
  }
  return ended;
}

/// Of the main program.
void StudyPrograms::take_results(session::Session& control, const std::optional<PathRecorder>& path,
                                 EndedProgram& ended) const {
  if (path) {
    const auto evaluated = path->evaluated();
    if (evaluated) {
      ended.evaluation = evaluated.value();
    } else {
      ended.note = "evaluation: " + evaluated.error();
      ended.ending = session::Ending::Findings;
    }
  }
  for (const std::string& name : variables_) {
    ended.variables.push_back(number_of(control, name));
  }
}

std::vector<std::optional<double>> StudyPrograms::results_of(const EndedProgram& ended) const {
  std::vector<std::optional<double>> results(study_.results.size());
  if (ended.variables.size() != variables_.size()) {
    return results;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    const StudyResult& result = study_.results[i];
    if (!result.evaluated.empty()) {
      const auto value = evaluated_value(ended.evaluation, result.evaluated);
      results[i] = value ? std::optional(rounded(*value, result.form.resolution)) : std::nullopt;
      continue;
    }
    std::vector<std::optional<double>> values;
    for (const std::string& name : result.expression.variables()) {
      const auto known = std::ranges::find(variables_, name);
      values.push_back(ended.variables[static_cast<std::size_t>(known - variables_.begin())]);
    }
    if (const auto value = result.expression.value(values)) {
      results[i] = rounded(*value, result.form.resolution);
    }
  }
  return results;
}

}  // namespace g31::study
