#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/runtime/overloaded.h"

namespace g31::fanuc {
namespace {

using machine::AlreadyTouching;
using machine::NoTouch;
using machine::SkipOutcome;
using machine::Touched;

/// The event of a skip move, and the warning that a missing signal deserves (MB-270, MB-277).
runtime::TouchEvent event_of(Control& control, const NcBlock& block, const SkipOutcome& outcome) {
  runtime::TouchEvent event;
  event.block = "G31";
  event.where = block.where;
  event.q_M_latched = control.port.position();
  event.q_M_stopped = control.port.position();
  std::visit(runtime::Overloaded{
                 [&](const Touched& touched) {
                   event.triggered = true;
                   event.q_M_latched = touched.q_M_latched;
                   event.q_M_stopped = touched.q_M_stopped;
                   event.contact = touched.contact;
                 },
                 [&](const NoTouch&) { control.silent_skip = block.where; },
                 [&](const AlreadyTouching& touching) {
                   event.triggered = true;
                   event.contact = touching.contact;
                   control.diagnostics.push_back(
                       make_diagnostic(source::DiagnosticId::SkipSignalAlreadyOn, block.where));
                 },
             },
             outcome);
  return event;
}

/// mm/min: F of the block, else the parameter that some controls have, else the feed in force.
Result<double, Failure> skip_feed(const Control& control, const NcBlock& block) {
  const auto parameter = control.profile.skip_feed_parameter;
  const double preset = parameter ? control.parameters.get(*parameter) : 0.0;
  if (!block.words.has('F') && preset > 0.0) {
    return preset;
  }
  auto feed = feed_in_force(control);
  if (!feed && control.profile.skip_feed == SkipFeed::OneBlock) {
    Failure failure;
    failure.id = AlarmId::NoSkipFeed;
    return failure;
  }
  return feed;
}

}  // namespace

/// G31: latched position to #5061.., the axes stay where they stopped (MB-265 to MB-284).
MaybeFailure execute_skip(Control& control, const NcBlock& block) {
  if (control.modal.group[7].whole != 40) {
    Failure failure;
    failure.id = AlarmId::SkipNotAllowed;
    return failure;
  }
  const auto feed = skip_feed(control, block);
  if (!feed) {
    return feed.error();
  }
  const AxisPositions q_W_end = programmed_end(control, block);
  machine::LinearMove move;
  move.q_M_end = control.coordinates.to_machine(q_W_end);
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = feed.value();
  control.silent_skip.reset();
  const auto outcome = control.port.move_until_skip(move);
  if (!outcome) {
    control.coordinates.arrived_at_machine(control.port.position());
    return from_fault(outcome.error());
  }
  runtime::TouchEvent event = event_of(control, block, outcome.value());
  event.q_M_commanded = move.q_M_end;
  event.feed_mm_min = move.feed_mm_min;
  control.q_W_skip = control.coordinates.to_work(event.q_M_latched);
  control.q_skip_offset = control.coordinates.tool_offset();
  if (event.triggered) {
    control.coordinates.arrived_at_machine(event.q_M_stopped);
  } else {
    control.coordinates.arrived_at_programmed(q_W_end);
  }
  control.observer.on_move({31, event.q_M_stopped, move.feed_mm_min, 0.0});
  control.observer.on_touch(event);
  return std::nullopt;
}

}  // namespace g31::fanuc
