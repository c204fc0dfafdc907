#include "tools/study/study_runs.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/diagnostic.h"
#include "tools/disk/disk.h"
#include "tools/study/grid.h"

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
  std::unique_ptr<EndedProgram> failed_before;     ///< one of those did not complete
  Geometry* geometry = nullptr;
  std::atomic<std::size_t> runs_left = 0;
};

namespace {

using session::Refusal;

/// Whether a key changes the parts, what carries them, or the balls and bodies that their trees are
/// made for.
bool changes_geometry(const setup::VariedKey& key, const setup::Job& job) {
  using setup::KeyId;
  using setup::SectionId;
  constexpr KeyId kGeometry[] = {
      KeyId::ProbeBallDiameter, KeyId::ProbeStemDiameter, KeyId::SecondBall,     KeyId::AxisCentre,
      KeyId::AxisDirection,     KeyId::MachineTableSide,  KeyId::MachineToolSide};
  return key.section == SectionId::Part || key.section == SectionId::ToolProbe ||
         (key.section == SectionId::WorkOffsets && job.has_parts_on_offsets) ||
         std::ranges::find(kGeometry, key.row->id) != std::end(kGeometry);
}

}  // namespace

Result<std::unique_ptr<StudyRuns>, Refusal> StudyRuns::create(const Study& study) {
  const auto jobs = StudyJobs::read(study);
  if (!jobs) {
    return jobs.error();
  }
  if (const auto wrong = jobs.value().why_not_all()) {
    return *wrong;
  }
  std::unique_ptr<StudyRuns> runs(new StudyRuns(study, jobs.value()));
  const auto first = runs->jobs_.at(0, {});
  if (!first) {
    return first.error();
  }
  runs->make_points(first.value());
  if (const auto wrong = runs->try_control(first.value())) {
    return *wrong;
  }
  runs->describe();
  return runs;
}

StudyRuns::StudyRuns(const Study& study, StudyJobs jobs)
    : study_(study), jobs_(std::move(jobs)), programs_(study) {}

StudyRuns::~StudyRuns() = default;

/// @param first  what a study of no variations would run
void StudyRuns::make_points(const setup::Job& first) {
  draws_geometry_ = std::ranges::any_of(
      study_.drawn, [&](const DrawnAxis& axis) { return changes_geometry(axis.target, first); });
  const bool by_point =
      jobs_.stacks().size() > 1 || std::ranges::any_of(study_.listed, [&](const ListedAxis& axis) {
        return axis.target && changes_geometry(*axis.target, first);
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
/// @param first  as for make_points()
std::optional<Refusal> StudyRuns::try_control(const setup::Job& first) {
  if (auto refusal = programs_.open(first)) {
    return refusal;
  }
  Geometry& geometry = *geometries_.front();
  std::call_once(geometry.once, [&] { geometry.parts.emplace(parts_of(first, study_)); });
  if (!geometry.parts->ok()) {
    return geometry.parts->error();
  }
  for (const source::Diagnostic& finding : geometry.parts->value().findings) {
    part_findings_ += programs_.rendered(finding);
  }
  return programs_.why_not(first);
}

void StudyRuns::describe() {
  description_ = {study_.name,
                  std::filesystem::path(study_.program).filename().string(),
                  std::string(session::name_of(programs_.control())),
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

std::vector<std::string> StudyRuns::files() const {
  std::vector<std::string> all = programs_.paths();
  std::ranges::move(jobs_.files(), std::back_inserter(all));
  return all;
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
  for (const setup::SheetStack& stack : jobs_.stacks()) {
    for (const auto& document : stack.documents()) {
      take(document->text);
    }
  }
  disk::Disk disk;
  for (const std::string& path : programs_.paths()) {
    take(disk.read(path).value_or(""));
  }
  return fmt::format("{:016x}", number);
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
  EndedProgram ended;
  if (!point.job->ok()) {
    ended = not_begun(point.job->error());
  } else if (point.failed_before != nullptr) {
    ended = *point.failed_before;
  } else if (row.drawn.empty()) {
    ended = run_all_programs(point.job->value(), *point.geometry->parts, row);
  } else {
    ended = run_drawn(number, row);
  }
  row.status = ended.status;
  row.note = ended.note;
  row.results = programs_.results_of(ended);
  let_go(number);
  return {std::move(row), ended.ending, std::move(ended.evaluation)};
}

EndedProgram StudyRuns::run_drawn(std::size_t number, const Row& row) {
  const Point& point = *points_[number];
  auto drawn = jobs_.at(number, row.drawn);
  if (!drawn) {
    return not_begun(drawn.error());
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

EndedProgram StudyRuns::run_all_programs(setup::Job job, const Parts& parts, const Row& row) {
  if (study_.before_when == BeforeWhen::Each) {
    if (auto failed = run_before(job, parts, SeedUse::BeforeRun, row.run)) {
      return *failed;
    }
  }
  return programs_.run(job, parts, programs_.main(), row.seed);
}

void StudyRuns::make_ready(std::size_t number) {
  Point& point = *points_[number];
  std::call_once(point.once, [&] {
    point.job.emplace(jobs_.at(number, {}));
    if (!point.job->ok()) {
      return;
    }
    setup::Job job = point.job->value();
    Geometry& geometry = *point.geometry;
    std::call_once(geometry.once, [&] { geometry.parts.emplace(parts_of(job, study_)); });
    if (study_.before_when == BeforeWhen::Once) {
      if (auto failed = run_before(job, *geometry.parts, SeedUse::BeforeAll, number)) {
        point.failed_before = std::make_unique<EndedProgram>(std::move(*failed));
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

std::optional<EndedProgram> StudyRuns::run_before(setup::Job& job, const Parts& parts, SeedUse use,
                                                  std::size_t event) {
  for (std::size_t i = 0; i < study_.before.size(); ++i) {
    const std::uint64_t seed = seed_of(study_.seed, use, event, static_cast<std::uint32_t>(i));
    EndedProgram ended = programs_.run(job, parts, i, seed);
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

}  // namespace g31::study
