#include "tools/report/run_recorder.h"

#include <algorithm>

namespace g31::report {
namespace {

using runtime::Output;

// What an entry of a list of the document takes: most moves and touches are within half of it and
// twice of it.
constexpr std::uint64_t kMoveBytes = 128;
constexpr std::uint64_t kTouchBytes = 512;
constexpr std::uint64_t kStopBytes = 128;  // without its text
constexpr std::uint64_t kEventBytes = 192;

}  // namespace

void RunRecorder::on_move(const runtime::MoveEvent& event) {
  if (what_.moves == RecordWhat::Keep::Yes && budget_.charge(Output::Moves, kMoveBytes)) {
    moves_.push_back(event);
    if (clock_ != nullptr) {
      move_times_.push_back(clock_->time_s());
    }
  }
}

void RunRecorder::on_moves_undone(std::uint64_t count) {
  if (what_.moves == RecordWhat::Keep::Yes) {
    const auto fewer = std::min(static_cast<std::size_t>(count), moves_.size());
    moves_.resize(moves_.size() - fewer);
    move_times_.resize(std::min(moves_.size(), move_times_.size()));
    budget_.give_back(Output::Moves, fewer * kMoveBytes);
  }
}

void RunRecorder::on_touch(const runtime::TouchEvent& event) {
  touch_count_ += event.triggered ? 1 : 0;
  missed_skips_.skipped(event);
  if (what_.touches == RecordWhat::Keep::Yes && budget_.charge(Output::Touches, kTouchBytes)) {
    touches_.push_back(event);
  }
}

void RunRecorder::on_fault(const runtime::FaultEvent& event) {
  fault_ = event;
}

void RunRecorder::on_stop(const runtime::StopEvent& event) {
  if (stops_.size() == kMostStops) {
    ++stops_left_out_;
  } else if (budget_.charge(Output::Stops, kStopBytes + runtime::size_in_document(event.text))) {
    stops_.push_back(event);
  }
}

void RunRecorder::on_event(const runtime::RecordedEvent& event) {
  if (events_.size() == kMostEvents) {
    ++events_left_out_;
  } else if (budget_.charge(Output::Events, kEventBytes)) {
    events_.push_back(event);
  }
}

void RunRecorder::on_output(const runtime::OutputEvent& event) {
  if (budget_.charge(Output::Printouts, runtime::size_in_document(event.text))) {
    output_ += event.as_utf8(event.text);
  }
}

}  // namespace g31::report
