#include "tools/review/listing.h"

#include <fmt/format.h>

#include "machine/sim/machining_centre.h"
#include "tools/session/expected_names.h"
#include "tools/session/run.h"
#include "tools/session/sheet_places.h"

namespace g31::review {
namespace {

/// Hears where measuring moves go.
class SkipRecorder final : public runtime::Observer {
 public:
  SkipRecorder(const AxisPositions& q_M_start, std::vector<SkipWay>& skips)
      : q_M_now_(q_M_start), skips_(skips) {}

  void on_move(const runtime::MoveEvent& event) override {
    q_M_before_ = q_M_now_;
    q_M_now_ = event.q_M_to;
  }
  void on_touch(const runtime::TouchEvent& event) override {
    if (skips_.size() < kMostSkips) {
      skips_.push_back({q_M_before_, event.q_M_commanded, event.where});
    }
  }

 private:
  AxisPositions q_M_before_ = AxisPositions::Zero();
  AxisPositions q_M_now_;
  std::vector<SkipWay>& skips_;
};

/// Where a run that did not complete came to, and why.
std::string end_of(const runtime::Outcome& outcome, const source::SourceMap& sources) {
  if (outcome.status == runtime::Status::Completed || outcome.diagnostics.empty()) {
    return "";
  }
  const source::Diagnostic& last = outcome.diagnostics.back();
  const source::ShownPlace place = source::place_of(last, sources);
  return place.file.empty() ? last.message
                            : fmt::format("{}:{}: {}", place.file, place.line, last.message);
}

}  // namespace

Result<Listing, session::Refusal> listing_of(const session::ProgramPaths& paths,
                                             const session::Prepared& prepared,
                                             source::FileSystem& files,
                                             const expect::Expectations& expected) {
  const setup::Job& job = prepared.job;
  Listing listing;
  machine::MachiningCentre machine(job.machine, nullptr);
  SkipRecorder recorder(job.machine.q_M_start, listing.skips);
  const auto programs = session::open_programs(prepared.control, paths, files, job.control);
  if (!programs) {
    return programs.error();
  }
  const auto run = session::Run::open(job, *programs.value(), machine, recorder);
  if (!run) {
    return run.error();
  }
  if (const auto wrong = session::wrong_expectation(expected, *run.value())) {
    return *wrong;
  }
  runtime::Budget budget;
  budget.blocks = kMostBlocks;
  budget.wall_seconds = kMostSeconds;
  listing.outcome = run.value()->session().run(budget);
  session::place_settings(job, listing.outcome.diagnostics);
  const source::SourceMap& sources = programs.value()->sources();
  listing.ended_at = end_of(listing.outcome, sources);
  if (listing.outcome.status == runtime::Status::SyntaxError) {
    return session::bad_input(listing.ended_at);
  }
  // Places are looked up while the programs are there.
  for (source::Diagnostic& diagnostic : listing.outcome.diagnostics) {
    diagnostic.in_sheet = source::place_of(diagnostic, sources);
    diagnostic.where = {};
    diagnostic.notes.clear();
  }
  return listing;
}

}  // namespace g31::review
