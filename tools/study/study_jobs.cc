#include "tools/study/study_jobs.h"

#include <set>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"
#include "tools/session/prepare.h"
#include "tools/setup/job_files.h"
#include "tools/study/grid.h"

namespace g31::study {

using session::Refusal;

namespace {

/// Programs are read for one control.
Refusal two_controls(const ListedAxis& axis, const session::Control& one,
                     const session::Control& other) {
  return session::bad_setup(fmt::format(
      "{}: the runs of a study are on one control, here on {} and {}; write a study for "
      "each, or name the control in [study]",
      axis.key, session::name_of(one), session::name_of(other)));
}

}  // namespace

Result<StudyJobs, Refusal> StudyJobs::read(const Study& study) {
  StudyJobs jobs(study);
  const std::string machines = disk::shipped_folder("machine/library").value_or("");
  for (std::size_t point = 0; point < point_count(study); ++point) {
    std::vector<std::string> sheets = study.setups;
    const auto values = values_at(study, point);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!study.listed[i].target) {
        sheets.push_back(std::get<std::string>(values[i]->value));
      }
    }
    const bool all_alike = sheets.size() == study.setups.size();
    const auto stack = setup::SheetStack::read(sheets, machines);
    if (!stack) {
      return session::refusal_of(stack.error());
    }
    jobs.stacks_.push_back(stack.value());
    if (all_alike) {
      break;
    }
  }
  return jobs;
}

Result<session::Control, Refusal> StudyJobs::control_of(const setup::Job& job) const {
  session::Request request;
  request.control = study_->control;
  request.programs = {study_->program};
  disk::Disk disk;
  return session::chosen_control(request, job, disk);
}

std::vector<StudyJobs::TriedPoint> StudyJobs::tried_points() const {
  std::vector<TriedPoint> points = {{}};
  std::size_t stride = point_count(*study_);
  for (const ListedAxis& axis : study_->listed) {
    stride /= axis.values.size();
    for (std::size_t i = 1; i < axis.values.size(); ++i) {
      points.push_back({i * stride, &axis});
    }
  }
  return points;
}

std::vector<std::string> StudyJobs::files() const {
  std::set<std::string> all;
  for (const setup::SheetStack& stack : stacks_) {
    for (const auto& document : stack.documents()) {
      all.insert(document->path);
    }
  }
  for (const TriedPoint& tried : tried_points()) {
    if (const auto job = at(tried.point, {})) {
      const std::vector<std::string> files = setup::files_of(job.value());
      all.insert(files.begin(), files.end());
    }
  }
  return {all.begin(), all.end()};
}

std::optional<Refusal> StudyJobs::why_not_all() const {
  std::optional<session::Control> first;
  for (const TriedPoint& tried : tried_points()) {
    const auto job = at(tried.point, {});
    if (!job) {
      return job.error();
    }
    const auto control = control_of(job.value());
    if (!control) {
      return control.error();
    }
    if (!first) {
      first = control.value();
    } else if (session::name_of(control.value()) != session::name_of(*first)) {
      return two_controls(*tried.axis, *first, control.value());
    }
  }
  // What is drawn must have a place, too.
  std::vector<double> middle;
  for (const DrawnAxis& axis : study_->drawn) {
    middle.push_back(axis.distribution == Distribution::Normal ? axis.first
                                                               : 0.5 * (axis.first + axis.second));
  }
  const auto job = at(0, middle);
  return job ? std::nullopt : std::optional(job.error());
}

Result<setup::Job, Refusal> StudyJobs::at(std::size_t point,
                                          const std::vector<double>& drawn) const {
  std::vector<setup::Override> overrides;
  const auto values = values_at(*study_, point);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const auto& target = study_->listed[i].target) {
      overrides.push_back({*target, values[i]->value, values[i]->where});
    }
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const DrawnAxis& axis = study_->drawn[i];
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
  disk::Disk disk;
  const auto wrong = session::take_variables({}, disk, taken);
  return wrong ? Result<setup::Job, Refusal>(*wrong)
               : Result<setup::Job, Refusal>(std::move(taken));
}

const setup::SheetStack& StudyJobs::stack_of(std::size_t point) const {
  return stacks_.size() == 1 ? stacks_.front() : stacks_.at(point);
}

}  // namespace g31::study
