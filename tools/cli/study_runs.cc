#include "tools/cli/study_runs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/library.h"
#include "interpreter/dialects/fanuc/program_windows.h"
#include "interpreter/source/diagnostic.h"
#include "machine/base/contract.h"
#include "tools/cli/scene.h"
#include "tools/disk/shipped.h"
#include "tools/report/run_document.h"

namespace g31::cli {

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

/// The programs as one thread has read them.
struct StudyRuns::Programs {
  std::vector<std::unique_ptr<fanuc::ProgramLibrary>> libraries;
};

/// How a program ended.
struct StudyRuns::Ended {
  std::string status = "completed";
  ExitCode code = ExitCode::Completed;
  std::string note;
  std::vector<std::optional<double>> variables;  ///< of the study's results
  std::map<std::string, double> permanent;
};

namespace {

using probe::TouchableParts;

/// Whether a key changes the parts, or the balls and bodies that their trees are made for.
bool changes_geometry(const setup::VariedKey& key) {
  return key.section == setup::SectionId::Part || key.row->id == setup::KeyId::ProbeBallDiameter ||
         key.row->id == setup::KeyId::ProbeStemDiameter;
}

Result<std::shared_ptr<const TouchableParts>, Refusal> touchable_parts(const setup::Job& job) {
  const auto parts = build_parts(job);
  if (!parts) {
    return Refusal{ExitCode::Setup, setup::render(parts.error())};
  }
  using Shared = std::shared_ptr<const TouchableParts>;
  return job.probe ? std::make_shared<const TouchableParts>(*job.probe, parts.value()) : Shared();
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// Why a run ended that did not complete: the last message says it.
std::string note_of(const runtime::Outcome& outcome) {
  return outcome.diagnostics.empty() ? std::string(report::status_name(outcome.status))
                                     : first_line(render_text(outcome.diagnostics.back()));
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

/// nullopt: vacant, a text, or no variable of this control
std::optional<double> number_of(ControlSession& session, const std::string& name) {
  const auto value = session.variable(name);
  const auto* const cell = value.ok() ? std::get_if<runtime::Cell>(&value.value()) : nullptr;
  return cell != nullptr && !cell->is_vacant() ? std::optional(cell->raw()) : std::nullopt;
}

/// Before the program ran.
std::optional<std::string> why_no_number(ControlSession& session, const std::string& name) {
  const auto value = session.variable(name);
  if (!value) {
    return fmt::format("{}: {}", name, value.error());
  }
  const bool is_text = std::holds_alternative<std::string>(value.value());
  return is_text ? std::optional(fmt::format("{}: it is a text", name)) : std::nullopt;
}

}  // namespace

Result<std::unique_ptr<StudyRuns>, Refusal> StudyRuns::create(const study::Study& study) {
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

StudyRuns::StudyRuns(const study::Study& study) : study_(study), programs_(study.before) {
  programs_.push_back(study.program);
  for (const study::StudyResult& result : study.results) {
    for (const std::string& name : result.expression.variables()) {
      if (std::ranges::find(variables_, name) == variables_.end()) {
        variables_.push_back(name);
      }
    }
  }
  draws_geometry_ = std::ranges::any_of(
      study.drawn, [](const study::DrawnAxis& axis) { return changes_geometry(axis.target); });
}

StudyRuns::~StudyRuns() = default;

std::optional<Refusal> StudyRuns::read_sheets() {
  const std::string machines = disk::shipped_folder("machine/library").value_or("");
  for (std::size_t point = 0; point < study::point_count(study_); ++point) {
    std::vector<std::string> sheets = study_.setups;
    const auto values = study::values_at(study_, point);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!study_.listed[i].target) {
        sheets.push_back(std::get<std::string>(values[i]->value));
      }
    }
    const bool all_alike = sheets.size() == study_.setups.size();
    const auto stack = setup::SheetStack::read(sheets, machines);
    if (!stack) {
      return refusal_of(stack.error());
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
  std::size_t stride = study::point_count(study_);
  if (const auto job = job_of(0, {}); !job) {
    return job.error();
  }
  for (const study::ListedAxis& axis : study_.listed) {
    stride /= axis.values.size();
    for (std::size_t i = 1; i < axis.values.size(); ++i) {
      if (const auto job = job_of(i * stride, {}); !job) {
        return job.error();
      }
    }
  }
  // What is drawn must have a place, too.
  std::vector<double> middle;
  for (const study::DrawnAxis& axis : study_.drawn) {
    middle.push_back(axis.distribution == study::Distribution::Normal
                         ? axis.first
                         : 0.5 * (axis.first + axis.second));
  }
  const auto job = job_of(0, middle);
  return job ? std::nullopt : std::optional(job.error());
}

void StudyRuns::make_points() {
  const bool by_point =
      stacks_.size() > 1 || std::ranges::any_of(study_.listed, [](const study::ListedAxis& axis) {
        return axis.target && changes_geometry(*axis.target);
      });
  const std::size_t count = study::point_count(study_);
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
  const auto control = chosen_control(options_of(programs_.size() - 1), job.value());
  if (!control) {
    return control.error();
  }
  control_ = control.value();
  runtime::Observer nobody;
  machine::MachiningCentre machine(job.value().machine, nullptr);
  for (std::size_t program = 0; program < programs_.size(); ++program) {
    if (const auto opened = open_session(*control_, options_of(program), machine, nobody);
        !opened) {
      return opened.error();
    }
  }
  Geometry& geometry = *geometries_.front();
  std::call_once(geometry.once, [&] { geometry.parts.emplace(touchable_parts(job.value())); });
  if (!geometry.parts->ok()) {
    return geometry.parts->error();
  }
  const SessionPointer session = session_of(programs_.size() - 1, machine, nobody).value();
  if (const auto refused = session->configure(job.value().control); !refused.empty()) {
    return refusal(ExitCode::Setup, fmt::format("{}", fmt::join(refused, "; ")));
  }
  for (const std::string& name : variables_) {
    if (const auto wrong = why_no_number(*session, name)) {
      return refusal(ExitCode::BadUsage, fmt::format("a result reads {}", *wrong));
    }
  }
  return std::nullopt;
}

RunOptions StudyRuns::options_of(std::size_t program) const {
  RunOptions options;
  options.control = study_.control;
  options.programs = {programs_[program]};
  options.libraries = study_.libraries;
  return options;
}

void StudyRuns::describe() {
  description_ = {study_.name,
                  std::filesystem::path(study_.program).filename().string(),
                  std::string(control_->name),
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
  for (const study::StudyResult& result : study_.results) {
    description_.results.push_back(result.form);
  }
  for (const study::ListedAxis& axis : study_.listed) {
    description_.listed.push_back(axis.key);
  }
  for (std::size_t point = 0; point < study::point_count(study_); ++point) {
    std::vector<std::string>& labels = description_.points.emplace_back();
    for (const study::ListedValue* const value : study::values_at(study_, point)) {
      labels.push_back(value->label);
    }
  }
  for (const study::DrawnAxis& axis : study_.drawn) {
    description_.drawn.push_back(axis.target.path);
  }
}

/// FNV-1a over all texts that a person writes for a study.
std::string StudyRuns::inputs() const {
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
  disk::Disk disk;
  for (const std::string& program : programs_) {
    take(disk.read(program).value_or(""));
  }
  return fmt::format("{:016x}", number);
}

Result<setup::Job, Refusal> StudyRuns::job_of(std::size_t point,
                                              const std::vector<double>& drawn) const {
  std::vector<setup::Override> overrides;
  const auto values = study::values_at(study_, point);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const auto& target = study_.listed[i].target) {
      overrides.push_back({*target, values[i]->value, values[i]->where});
    }
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const study::DrawnAxis& axis = study_.drawn[i];
    const auto value = setup::value_for(axis.target, setup::Node{1, 1, drawn[i]});
    if (!value) {
      return refusal(ExitCode::Setup,
                     fmt::format("{} was drawn as {}, it should be {}", axis.target.path,
                                 value.error().is, value.error().should_be));
    }
    overrides.push_back({axis.target, value.value(), axis.where});
  }
  const auto job = stack_of(point).job(overrides);
  if (!job) {
    return refusal_of(job.error());
  }
  setup::Job taken = job.value();
  const auto wrong = take_variables({}, taken);
  return wrong ? Result<setup::Job, Refusal>(*wrong)
               : Result<setup::Job, Refusal>(std::move(taken));
}

study::Row StudyRuns::run(std::size_t run) {
  study::Row row;
  row.run = run;
  row.seed = study::seed_of(study_.seed, study::SeedUse::Run, run);
  for (std::size_t i = 0; i < study_.drawn.size(); ++i) {
    row.drawn.push_back(study::drawn_value(study_.drawn[i], study_.seed, i, run));
  }
  const std::size_t number = run / study_.repeats;
  make_ready(number);
  const Point& point = *points_[number];
  Ended ended;
  if (!point.job->ok()) {
    ended = {"setup", point.job->error().code, first_line(point.job->error().text), {}, {}};
  } else if (point.failed_before != nullptr) {
    ended = *point.failed_before;
  } else if (row.drawn.empty()) {
    ended = run_all_programs(point.job->value(), *point.geometry->parts, row);
  } else {
    ended = run_drawn(number, row);
  }
  row.status = ended.status;
  row.exit_code = static_cast<int>(ended.code);
  row.note = ended.note;
  row.results = results_of(ended);
  let_go(number);
  return row;
}

StudyRuns::Ended StudyRuns::run_drawn(std::size_t number, const study::Row& row) {
  const Point& point = *points_[number];
  auto drawn = job_of(number, row.drawn);
  if (!drawn) {
    return {"setup", drawn.error().code, first_line(drawn.error().text), {}, {}};
  }
  setup::Job job = drawn.value();
  if (study_.before_when == study::BeforeWhen::Once && !study_.before.empty()) {
    // What the programs before left stays, unless it is what was drawn.
    auto variables = point.job->value().control.variables;
    for (const study::DrawnAxis& axis : study_.drawn) {
      if (axis.target.section == setup::SectionId::Variables) {
        variables[axis.target.key] = job.control.variables[axis.target.key];
      }
    }
    job.control.variables = std::move(variables);
  }
  const Parts parts = draws_geometry_ ? touchable_parts(job) : *point.geometry->parts;
  return run_all_programs(std::move(job), parts, row);
}

StudyRuns::Ended StudyRuns::run_all_programs(setup::Job job, const Parts& parts,
                                             const study::Row& row) {
  if (study_.before_when == study::BeforeWhen::Each) {
    if (auto failed = run_before(job, parts, study::SeedUse::BeforeRun, row.run)) {
      return *failed;
    }
  }
  return run_program(job, parts, programs_.size() - 1, row.seed);
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
    std::call_once(geometry.once, [&] { geometry.parts.emplace(touchable_parts(job)); });
    if (study_.before_when == study::BeforeWhen::Once) {
      if (auto failed = run_before(job, *geometry.parts, study::SeedUse::BeforeAll, number)) {
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
                                                      study::SeedUse use, std::size_t event) {
  for (std::size_t i = 0; i < study_.before.size(); ++i) {
    const std::uint64_t seed =
        study::seed_of(study_.seed, use, event, static_cast<std::uint32_t>(i));
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

fanuc::ProgramLibrary& StudyRuns::library_of(std::size_t program) {
  Programs* mine = nullptr;
  {
    const std::lock_guard lock(libraries_mutex_);
    auto& slot = libraries_[std::this_thread::get_id()];
    if (slot == nullptr) {
      slot = std::make_unique<Programs>();
      slot->libraries.resize(programs_.size());
    }
    mine = slot.get();
  }
  auto& library = mine->libraries[program];
  // A program in windows can be gone through once only.
  const bool is_long = disk_.size(programs_[program]).value_or(0) > fanuc::kWholeFileBytes;
  if (library == nullptr || is_long) {
    library = std::make_unique<fanuc::ProgramLibrary>(disk_);
    // That every file can be read was seen before the first run.
    (void)fill_library(*library, options_of(program));
  }
  return *library;
}

Result<SessionPointer, Refusal> StudyRuns::session_of(std::size_t program,
                                                      machine::MachinePort& machine,
                                                      runtime::Observer& observer) {
  if (control_->profile != nullptr) {
    return open_session(*control_->profile, library_of(program), machine, observer);
  }
  return open_session(*control_, options_of(program), machine, observer);
}

StudyRuns::Ended StudyRuns::run_program(const setup::Job& job, const Parts& parts,
                                        std::size_t program, std::uint64_t seed) {
  if (!parts) {
    return {"setup", parts.error().code, first_line(parts.error().text), {}, {}};
  }
  const auto surroundings = surroundings_of(job, parts.value(), seed);
  machine::MachiningCentre machine(job.machine, surroundings.get());
  runtime::Observer nobody;
  const auto opened = session_of(program, machine, nobody);
  if (!opened) {
    return {"setup", opened.error().code, first_line(opened.error().text), {}, {}};
  }
  ControlSession& session = *opened.value();
  if (const auto refused = session.configure(job.control); !refused.empty()) {
    return {"setup", ExitCode::Setup, refused.front(), {}, {}};
  }
  const runtime::Outcome outcome = session.run({study_.max_blocks, study_.max_time_s});
  Ended ended;
  ended.status = report::status_name(outcome.status);
  ended.code = exit_code_of(outcome);
  if (outcome.status != runtime::Status::Completed) {
    ended.note = note_of(outcome);
    return ended;
  }
  const bool is_main = program + 1 == programs_.size();
  for (std::size_t i = 0; is_main && i < variables_.size(); ++i) {
    ended.variables.push_back(number_of(session, variables_[i]));
  }
  if (!is_main) {
    ended.permanent = session.permanent_variables();
  }
  return ended;
}

std::vector<std::optional<double>> StudyRuns::results_of(const Ended& ended) const {
  std::vector<std::optional<double>> results(study_.results.size());
  if (ended.variables.size() != variables_.size()) {
    return results;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    const study::StudyResult& result = study_.results[i];
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

}  // namespace g31::cli
