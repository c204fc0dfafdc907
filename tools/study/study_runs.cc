#include "tools/study/study_runs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <filesystem>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/time_budget.h"
#include "interpreter/source/diagnostic.h"
#include "tools/disk/shipped.h"
#include "tools/session/heard.h"

namespace g31::study {

/// The parts of a set-up with their trees, made when the first run needs them.
struct StudyRuns::Geometry {
  std::once_flag once;
  std::optional<Parts> parts;
  std::atomic<std::size_t> points_left = 0;  ///< that still need it
};

/// A combination of listed values.
struct StudyRuns::Point {
  std::once_flag once;
  std::optional<Result<setup::Job, Refusal>> job;  ///< with what the programs before it left
  std::unique_ptr<Ended> failed_before;            ///< one of those did not complete
  Geometry* geometry = nullptr;
  std::atomic<std::size_t> runs_left = 0;
};

/// How a program ended.
struct StudyRuns::Ended {
  std::string status = "completed";
  session::Ending ending = session::Ending::Completed;
  std::string note;
  std::vector<std::optional<double>> variables;  ///< of the study's results
  std::map<std::string, double> permanent;
  std::optional<evaluate::Evaluation> evaluation = {};  ///< of the study's program
};

namespace {

using session::Refusal;

/// Whether a key changes the parts, or the balls and bodies that their trees are made for.
bool changes_geometry(const setup::VariedKey& key) {
  return key.section == setup::SectionId::Part || key.section == setup::SectionId::ToolProbe ||
         key.row->id == setup::KeyId::ProbeBallDiameter ||
         key.row->id == setup::KeyId::ProbeStemDiameter;
}

/// Within the time that a run of the study has.
Result<StudyParts, Refusal> parts_of(const setup::Job& job, const Study& study) {
  const runtime::TimeBudget time(study.max_time_s, study.interruption);
  const auto built = session::build_parts(job, &time);
  if (!built) {
    return built.error();
  }
  const auto sensed = session::sensed_parts(job, built.value().parts, &time);
  if (!sensed) {
    return sensed.error();
  }
  return StudyParts{sensed.value(), built.value().findings};
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string first_line(const Refusal& refusal) {
  return first_line(render(refusal));
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

Result<std::unique_ptr<StudyRuns>, Refusal> StudyRuns::create(const Study& study) {
  std::unique_ptr<StudyRuns> runs(new StudyRuns(study));
  if (const auto wrong = runs->read_sheets()) {
    return *wrong;
  }
  if (const auto wrong = runs->try_listed_values()) {
    return *wrong;
  }
  runs->make_points();
  if (const auto wrong = runs->try_control()) {
    return *wrong;
  }
  runs->describe();
  return runs;
}

StudyRuns::StudyRuns(const Study& study) : study_(study), paths_(study.before) {
  paths_.push_back(study.program);
  for (const StudyResult& result : study.results) {
    for (const std::string& name : result.expression.variables()) {
      if (std::ranges::find(variables_, name) == variables_.end()) {
        variables_.push_back(name);
      }
    }
  }
  draws_geometry_ = std::ranges::any_of(
      study.drawn, [](const DrawnAxis& axis) { return changes_geometry(axis.target); });
}

StudyRuns::~StudyRuns() = default;

std::optional<Refusal> StudyRuns::read_sheets() {
  const std::string machines = disk::shipped_folder("machine/library").value_or("");
  for (std::size_t point = 0; point < point_count(study_); ++point) {
    std::vector<std::string> sheets = study_.setups;
    const auto values = values_at(study_, point);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!study_.listed[i].target) {
        sheets.push_back(std::get<std::string>(values[i]->value));
      }
    }
    const bool all_alike = sheets.size() == study_.setups.size();
    const auto stack = setup::SheetStack::read(sheets, machines);
    if (!stack) {
      return session::refusal_of(stack.error());
    }
    stacks_.push_back(stack.value());
    if (all_alike) {
      break;
    }
  }
  return std::nullopt;
}

const setup::SheetStack& StudyRuns::stack_of(std::size_t point) const {
  return stacks_.size() == 1 ? stacks_.front() : stacks_.at(point);
}

/// Each value with the first ones of all other lists, so that a long grid is tried quickly.
std::optional<Refusal> StudyRuns::try_listed_values() {
  std::size_t stride = point_count(study_);
  if (const auto job = job_of(0, {}); !job) {
    return job.error();
  }
  for (const ListedAxis& axis : study_.listed) {
    stride /= axis.values.size();
    for (std::size_t i = 1; i < axis.values.size(); ++i) {
      if (const auto job = job_of(i * stride, {}); !job) {
        return job.error();
      }
    }
  }
  // What is drawn must have a place, too.
  std::vector<double> middle;
  for (const DrawnAxis& axis : study_.drawn) {
    middle.push_back(axis.distribution == Distribution::Normal ? axis.first
                                                               : 0.5 * (axis.first + axis.second));
  }
  const auto job = job_of(0, middle);
  return job ? std::nullopt : std::optional(job.error());
}

void StudyRuns::make_points() {
  const bool by_point =
      stacks_.size() > 1 || std::ranges::any_of(study_.listed, [](const ListedAxis& axis) {
        return axis.target && changes_geometry(*axis.target);
      });
  const std::size_t count = point_count(study_);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || by_point) {
      geometries_.push_back(std::make_unique<Geometry>());
      geometries_.back()->points_left = by_point ? 1 : count;
    }
    points_.push_back(std::make_unique<Point>());
    points_.back()->geometry = geometries_.back().get();
    points_.back()->runs_left = study_.repeats;
  }
}

/// What the control does not take, and what of it cannot be read, stops the study before it begins.
std::optional<Refusal> StudyRuns::try_control() {
  const auto job = job_of(0, {});
  const auto chosen = session::chosen_control(request_of(paths_.size() - 1), job.value(), disk_);
  if (!chosen) {
    return chosen.error();
  }
  control_ = chosen.value();
  comments_.emplace(disk_, *control_);
  for (std::size_t program = 0; program < paths_.size(); ++program) {
    const auto opened =
        session::open_programs(*control_, request_of(program), disk_, job.value().control);
    if (!opened) {
      return opened.error();
    }
    programs_.push_back(opened.value());
  }
  Geometry& geometry = *geometries_.front();
  std::call_once(geometry.once, [&] { geometry.parts.emplace(parts_of(job.value(), study_)); });
  if (!geometry.parts->ok()) {
    return geometry.parts->error();
  }
  for (const source::Diagnostic& finding : geometry.parts->value().findings) {
    part_findings_ += render_text(finding, programs_.back()->sources());
  }
  runtime::Observer nobody;
  machine::MachiningCentre machine(job.value().machine, nullptr);
  const auto control = programs_.back()->session(machine, nobody);
  if (const auto refused = control->configure(job.value().control); !refused.empty()) {
    return session::refused_settings(job.value(), refused);
  }
  for (const std::string& name : variables_) {
    if (const auto wrong = why_no_number(*control, name)) {
      return session::bad_input(fmt::format("a result reads {}", *wrong));
    }
  }
  return std::nullopt;
}

session::Request StudyRuns::request_of(std::size_t program) const {
  session::Request request;
  request.control = study_.control;
  request.programs = {paths_[program]};
  request.libraries = study_.libraries;
  return request;
}

void StudyRuns::describe() {
  description_ = {study_.name,
                  std::filesystem::path(study_.program).filename().string(),
                  std::string(session::name_of(*control_)),
                  study_.seed,
                  study_.repeats,
                  study_.confidence_percent,
                  study_.table,
                  study_.assumes,
                  inputs(),
                  {},
                  {},
                  {},
                  {}};
  for (const StudyResult& result : study_.results) {
    description_.results.push_back(result.form);
  }
  for (const ListedAxis& axis : study_.listed) {
    description_.listed.push_back(axis.key);
  }
  for (std::size_t point = 0; point < point_count(study_); ++point) {
    std::vector<std::string>& labels = description_.points.emplace_back();
    for (const ListedValue* const value : values_at(study_, point)) {
      labels.push_back(value->label);
    }
  }
  for (const DrawnAxis& axis : study_.drawn) {
    description_.drawn.push_back(axis.target.path);
  }
}

/// FNV-1a over all texts that a person writes for a study.
std::string StudyRuns::inputs() {
  std::uint64_t number = 0xCBF29CE484222325U;
  const auto take = [&](std::string_view text) {
    for (const char c : text) {
      number = (number ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    }
  };
  take(study_.document->text);
  for (const setup::SheetStack& stack : stacks_) {
    for (const auto& document : stack.documents()) {
      take(document->text);
    }
  }
  for (const std::string& path : paths_) {
    take(disk_.read(path).value_or(""));
  }
  return fmt::format("{:016x}", number);
}

Result<setup::Job, Refusal> StudyRuns::job_of(std::size_t point, const std::vector<double>& drawn) {
  std::vector<setup::Override> overrides;
  const auto values = values_at(study_, point);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const auto& target = study_.listed[i].target) {
      overrides.push_back({*target, values[i]->value, values[i]->where});
    }
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const DrawnAxis& axis = study_.drawn[i];
    const auto value = setup::value_for(axis.target, setup::Node{1, 1, drawn[i]});
    if (!value) {
      return session::bad_setup(fmt::format("{} was drawn as {}, it should be {}", axis.target.path,
                                            value.error().is, value.error().should_be));
    }
    overrides.push_back({axis.target, value.value(), axis.where});
  }
  const auto job = stack_of(point).job(overrides);
  if (!job) {
    return session::refusal_of(job.error());
  }
  setup::Job taken = job.value();
  const auto wrong = session::take_variables({}, disk_, taken);
  return wrong ? Result<setup::Job, Refusal>(*wrong)
               : Result<setup::Job, Refusal>(std::move(taken));
}

StudyRun StudyRuns::run(std::size_t run) {
  Row row;
  row.run = run;
  row.seed = seed_of(study_.seed, SeedUse::Run, run);
  for (std::size_t i = 0; i < study_.drawn.size(); ++i) {
    row.drawn.push_back(drawn_value(study_.drawn[i], study_.seed, i, run));
  }
  const std::size_t number = run / study_.repeats;
  make_ready(number);
  const Point& point = *points_[number];
  Ended ended;
  if (!point.job->ok()) {
    ended = {"setup", point.job->error().ending, first_line(point.job->error()), {}, {}};
  } else if (point.failed_before != nullptr) {
    ended = *point.failed_before;
  } else if (row.drawn.empty()) {
    ended = run_all_programs(point.job->value(), *point.geometry->parts, row);
  } else {
    ended = run_drawn(number, row);
  }
  row.status = ended.status;
  row.note = ended.note;
  row.results = results_of(ended);
  let_go(number);
  return {std::move(row), ended.ending, std::move(ended.evaluation)};
}

StudyRuns::Ended StudyRuns::run_drawn(std::size_t number, const Row& row) {
  const Point& point = *points_[number];
  auto drawn = job_of(number, row.drawn);
  if (!drawn) {
    return {"setup", drawn.error().ending, first_line(drawn.error()), {}, {}};
  }
  setup::Job job = drawn.value();
  if (study_.before_when == BeforeWhen::Once && !study_.before.empty()) {
    // What the programs before left stays, unless it is what was drawn.
    auto variables = point.job->value().control.variables;
    for (const DrawnAxis& axis : study_.drawn) {
      if (axis.target.section == setup::SectionId::Variables) {
        variables[axis.target.key] = job.control.variables[axis.target.key];
      }
    }
    job.control.variables = std::move(variables);
  }
  const Parts parts = draws_geometry_ ? parts_of(job, study_) : *point.geometry->parts;
  return run_all_programs(std::move(job), parts, row);
}

StudyRuns::Ended StudyRuns::run_all_programs(setup::Job job, const Parts& parts, const Row& row) {
  if (study_.before_when == BeforeWhen::Each) {
    if (auto failed = run_before(job, parts, SeedUse::BeforeRun, row.run)) {
      return *failed;
    }
  }
  return run_program(job, parts, paths_.size() - 1, row.seed);
}

void StudyRuns::make_ready(std::size_t number) {
  Point& point = *points_[number];
  std::call_once(point.once, [&] {
    point.job.emplace(job_of(number, {}));
    if (!point.job->ok()) {
      return;
    }
    setup::Job job = point.job->value();
    Geometry& geometry = *point.geometry;
    std::call_once(geometry.once, [&] { geometry.parts.emplace(parts_of(job, study_)); });
    if (study_.before_when == BeforeWhen::Once) {
      if (auto failed = run_before(job, *geometry.parts, SeedUse::BeforeAll, number)) {
        point.failed_before = std::make_unique<Ended>(std::move(*failed));
      }
      point.job.emplace(std::move(job));
    }
  });
}

/// What no run needs any more need not stay in memory.
void StudyRuns::let_go(std::size_t number) {
  Point& point = *points_[number];
  if (--point.runs_left == 0) {
    point.job.reset();
    if (--point.geometry->points_left == 0) {
      point.geometry->parts.reset();
    }
  }
}

std::optional<StudyRuns::Ended> StudyRuns::run_before(setup::Job& job, const Parts& parts,
                                                      SeedUse use, std::size_t event) {
  for (std::size_t i = 0; i < study_.before.size(); ++i) {
    const std::uint64_t seed = seed_of(study_.seed, use, event, static_cast<std::uint32_t>(i));
    Ended ended = run_program(job, parts, i, seed);
    if (ended.status != "completed") {
      ended.note = "before: " + ended.note;
      return ended;
    }
    for (const auto& [name, value] : ended.permanent) {
      job.control.variables[name] = value;
    }
  }
  return std::nullopt;
}

/// A defect fails its run alone.
StudyRuns::Ended StudyRuns::run_program(const setup::Job& job, const Parts& parts,
                                        std::size_t program, std::uint64_t seed) {
  try {
    return carry_out(job, parts, program, seed);
  } catch (const std::exception& defect) {
    return {"defect", session::Ending::Defect, defect.what(), {}, {}};
  }
}

StudyRuns::Ended StudyRuns::carry_out(const setup::Job& job, const Parts& parts,
                                      std::size_t program, std::uint64_t seed) {
  if (!parts) {
    return {"setup", parts.error().ending, first_line(parts.error()), {}, {}};
  }
  const auto surroundings = session::surroundings_of(job, parts.value().sensed, seed);
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
  const bool is_main = program + 1 == paths_.size();
  std::optional<PathRecorder> path;
  if (is_main && study_.evaluation) {
    machine.trace(study_.evaluation->trace_period_s, path.emplace(*study_.evaluation, output));
  }
  runtime::Outcome outcome =
      control->run({study_.max_blocks, study_.max_time_s, &output, study_.interruption});
  Ended ended;
  ended.status = session::status_name(outcome);
  if (inside) {
    ended.note = first_line(render_text(*inside, programs_[program]->sources()));
    outcome = session::with_findings({*inside}, outcome);
  }
  const source::SourceMap& sources = programs_[program]->sources();
  outcome = session::heard(session::with_findings(parts.value().findings, outcome), *comments_,
                           paths_[program], {}, sources)
                .outcome;
  ended.ending = session::ending_of(outcome);
  if (ended.note.empty() && ended.ending == session::Ending::Findings) {
    ended.note = first_finding(outcome, sources);
  }
  if (outcome.status != runtime::Status::Completed) {
    ended.note = note_of(outcome, sources);
    return ended;
  }
  if (path) {
    take_evaluation(*path, ended);
  }
  for (std::size_t i = 0; is_main && i < variables_.size(); ++i) {
    ended.variables.push_back(number_of(*control, variables_[i]));
  }
  if (!is_main) {
    ended.permanent = control->permanent_variables();
  }
  return ended;
}

void StudyRuns::take_evaluation(const PathRecorder& path, Ended& ended) {
  const auto evaluated = path.evaluated();
  if (evaluated) {
    ended.evaluation = evaluated.value();
    return;
  }
  ended.note = "evaluation: " + evaluated.error();
  ended.ending = session::Ending::Findings;
}

std::vector<std::optional<double>> StudyRuns::results_of(const Ended& ended) const {
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
