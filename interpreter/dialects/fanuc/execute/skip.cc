#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"
#include "interpreter/runtime/overloaded.h"
#include "interpreter/runtime/touch_event.h"

namespace g31::fanuc {
namespace {

using machine::NoEdge;
using machine::NoTouch;
using machine::SkipOutcome;
using machine::Touched;
using runtime::MissedTouches;

/// G37 that wants its signal near the position: nobody has to be told beside the alarm.
bool is_alarm_without_signal(const Control& control, const NcBlock& block) {
  return block.code->action == GAction::MeasureTool &&
         control.profile.tool_measurement != ToolMeasurement::ToTravelEnd;
}

/// What a missing signal, or one that was there already, deserves (MB-270, MB-277).
void note_outcome(Control& control, const NcBlock& block, const SkipOutcome& outcome) {
  std::visit(runtime::Overloaded{
                 [&](const Touched&) {
                   control.stopped_skip = block.where;
                   control.touches.missed.touched();
                 },
                 [&](const NoTouch&) {
                   if (!is_alarm_without_signal(control, block)) {
                     control.touches.missed.missed(
                         block.where, {MissedTouches::Result::End, control.scale.mm_per_unit()});
                   }
                 },
                 [&](const NoEdge&) {
                   control.touches.missed.touched();
                   control.warn(source::DiagnosticId::SkipSignalAlreadyOn, block.where);
                 },
             },
             outcome);
}

/// What P of G31 says about the signal (MB-278, MB-279).
struct SkipKind {
  bool is_torque_limit = false;  ///< P98: only the torque limit would end it, which nothing reaches
  unsigned signals = 0;          ///< bit i: skip signal i + 1 ends it; 0: any
};

/// As documents name a measuring block.
std::string_view name_of(GAction action) {
  return action == GAction::MeasureDiameter ? "G35"
         : action == GAction::MeasureWork   ? "G36"
         : action == GAction::MeasureTool   ? "G37"
         : action == GAction::MeasureCentre ? "G136"
                                            : "G31";
}

int axes_named(const BlockWords& words) {
  int count = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    count += words.has(kAxisLetters[axis]) ? 1 : 0;
  }
  return count;
}

/// Of G31.1 to G31.3 the first of their two parameters; nullopt: another code (MB-283).
std::optional<int> step_parameter(const NcBlock& block) {
  constexpr int kParametersOfStep = 2;
  const int step = block.code->number.tenth;
  return step > 0 ? std::optional(kParametersOfStep * (step - 1)) : std::nullopt;
}

Result<SkipKind, Failure> skip_kind(Control& control, const NcBlock& block) {
  if (const auto step = step_parameter(block)) {
    return SkipKind{false, control.parameters.signals(ParameterId::MultiStepSkip, *step)};
  }
  const EvaluatedWord* const p = block.words.find('P');
  if (p == nullptr) {
    return SkipKind();
  }
  const SkipSelection selection = control.profile.skip_selection;
  const auto number = integer_within(
      *p, control.profile, [selection](int given) { return wrong_skip(given, selection); });
  if (!number) {
    return number.error();
  }
  if (selection == SkipSelection::Mask) {
    return SkipKind{false, static_cast<unsigned>(number.value())};
  }
  if (skips_by_torque(number.value())) {
    control.warn_once(source::DiagnosticId::NotSimulated, block.where,
                      fmt::format("the torque limit that ends G31 P{}", number.value()));
    auto wrong = wrong_skip_axes(axes_named(block.words));
    return wrong ? at_word(*std::move(wrong), *p)
                 : Result<SkipKind, Failure>({number.value() == 98, 0});
  }
  const unsigned signals = control.parameters.signals(ParameterId::SkipSignals, number.value() - 1);
  return signals != 0 ? Result<SkipKind, Failure>({false, signals})
                      : at_word(no_skip_signal(number.value()), *p);
}

/// The measuring input that a skip move listens to: the one among its signals that something is
/// wired to.  Skip signal n is input n.
int listened_input(const Control& control, unsigned signals) {
  constexpr int kSignals = 8;
  int wired = machine::kAnyInput;
  int silent = machine::kAnyInput;
  for (int input = kSignals; input >= 1 && signals != 0; --input) {
    const bool is_asked = (signals >> (input - 1) & 1U) != 0;
    const bool is_wired = control.port.sensor_state(input).has_value();
    wired = is_asked && is_wired ? input : wired;
    silent = is_asked ? input : silent;
  }
  return wired != machine::kAnyInput ? wired : silent;
}

/// G31 P98: a feed move that no skip signal ends; #5061.. hold its end.
MaybeFailure execute_torque_skip(Control& control, const NcBlock& block) {
  const AxisPositions q_L_end = programmed_end(control, block);
  if (auto failure = feed_to(control, control.coordinates.to_path(q_L_end), 31)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  control.q_W_skip = control.coordinates.to_work(control.port.position());
  control.touches.latched();
  return std::nullopt;
}

/// Override and dry run leave a skip move alone, unless parameter 6200.7 lets them (MB-268).
double skip_speed(const Control& control, double feed_mm_min) {
  return control.parameters.is_on(ParameterId::SkipFollowsSwitches)
             ? switched_feed(control, feed_mm_min)
             : feed_mm_min;
}

/// mm/min: F of the block, else the parameter that some controls have, else the feed in force.
Result<double, Failure> skip_feed(Control& control, const NcBlock& block,
                                  const AxisPositions& q_M_end) {
  const auto parameter = control.profile.skip_feed_parameter;
  const auto step = step_parameter(block);
  const double preset = step        ? control.parameters.get(ParameterId::MultiStepSkip, *step + 1)
                        : parameter ? control.parameters.get(*parameter)
                                    : 0.0;
  if (!block.words.has('F') && preset > 0.0) {
    return preset;
  }
  auto feed = feed_over(control, [&] { return axes_way(control, q_M_end); });
  if (!feed && control.profile.skip_feed == SkipFeed::OneBlock) {
    Failure failure;
    failure.id = AlarmId::NoSkipFeed;
    return failure;
  }
  return feed;
}

/// The axes at the end of a skip move, which is straight for them.
Result<AxisPositions, Failure> skip_end(const Control& control, const NcBlock& block,
                                        const AxisPositions& q_L_end) {
  const Coordinates& coordinates = control.coordinates;
  const AxisPositions q_B_end = coordinates.to_path(q_L_end);
  if (coordinates.leader() && rotary_axes(q_B_end) != rotary_axes(control.port.position())) {
    return block_failure(AlarmId::NotUnderTipControl,
                         fmt::format("{} turns a rotary axis", to_text(block.code->number)));
  }
  const auto q_M_end = coordinates.axes_at(q_B_end);
  return q_M_end ? Result<AxisPositions, Failure>(*q_M_end)
                 : block_failure(AlarmId::NoReachablePosition);
}

}  // namespace

Result<std::optional<AxisPositions>, Failure> move_and_latch(Control& control, const NcBlock& block,
                                                             const machine::SkipMove& move) {
  control.report_stopped_skip();
  const auto state = control.port.sensor_state(move.input);
  control.warn_of(state, block.where);
  control.last_skip.q_M_from = control.port.position();
  const auto outcome = control.outlet.move_until_skip(move, block.where);
  if (!outcome) {
    control.coordinates.arrived_at_machine(control.port.position());
    return from_fault(outcome.error());
  }
  note_outcome(control, block, outcome.value());
  runtime::TouchEvent event = runtime::touch_event(
      move.way, outcome.value(), control.last_skip.q_M_from, control.port.position());
  event.block = name_of(block.code->action);
  event.where = block.where;
  if (event.triggered) {
    control.coordinates.arrived_at_machine(event.q_M_stopped);
  }
  control.last_skip.q_M_latched = event.q_M_latched;
  control.touches.touched(event, state);
  control.outlet.touched(std::move(event));
  return event.triggered ? std::optional(event.q_M_latched) : std::nullopt;
}

/// G31: latched position to #5061.., the axes stay where they stopped (MB-265 to MB-284).  Without
/// an axis it waits until they stand (MB-161) and nothing else: builders' tool changes write it so.
MaybeFailure execute_skip(Control& control, const NcBlock& block) {
  const auto kind = skip_kind(control, block);
  if (!kind) {
    return kind.error();
  }
  if (kind.value().is_torque_limit) {
    return execute_torque_skip(control, block);
  }
  if (!block.has_axis_word && !turns_by_direction(control, block.words)) {
    return std::nullopt;
  }
  if (!control.coordinates.transform().is_identity()) {
    control.warn(source::DiagnosticId::SkipInTurnedPlane, block.where);
  }
  const AxisPositions q_L_end = programmed_end(control, block);
  const auto q_M_end = skip_end(control, block, q_L_end);
  if (!q_M_end) {
    return q_M_end.error();
  }
  const auto feed = skip_feed(control, block, q_M_end.value());
  if (!feed) {
    return feed.error();
  }
  machine::LinearMove way;
  way.q_M_end = q_M_end.value();
  way.traverse = machine::Traverse::Feed;
  way.feed_mm_min = skip_speed(control, feed.value());
  way.mm_per_degree = control.scale.mm_per_unit();
  machine::SkipMove move = way;
  move.input = listened_input(control, kind.value().signals);
  const auto q_M_latched = move_and_latch(control, block, move);
  if (!q_M_latched) {
    return q_M_latched.error();
  }
  control.q_W_skip = control.coordinates.to_work(control.last_skip.q_M_latched);
  if (!q_M_latched.value()) {
    control.coordinates.arrived_at_programmed(q_L_end);
  }
  return std::nullopt;
}

}  // namespace g31::fanuc
