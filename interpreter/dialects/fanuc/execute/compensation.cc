#include "interpreter/dialects/fanuc/execute/compensation.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using namespace path;
using State = CompensationCommand::State;

/// Codes whose moves are no part of a path to be compensated.
constexpr GAction kNeedCancel[] = {
    GAction::CheckReference, GAction::ToReference,   GAction::FromReference,
    GAction::MachineMove,    GAction::MeasureTool,   GAction::MeasureDiameter,
    GAction::MeasureWork,    GAction::MeasureCentre, GAction::Skip,
    GAction::Scaling,        GAction::ToolToPlane,   GAction::SettingError};

CompensationRules rules_of(const Control& control) {
  CompensationRules rules;
  const Parameters& parameters = control.parameters;
  if (parameters.is_on(ParameterId::StartUpTypeB)) {
    rules.start_up = StartUp::TypeB;
  }
  if (parameters.is_on(ParameterId::NoInterferenceCheck)) {
    rules.check = CompensationRules::InterferenceCheck::Off;
  }
  rules.minute_mm = parameters.get(ParameterId::MinuteCorner);
  const int given = nearest_integer(parameters.get(ParameterId::BlocksRead));
  const int read = given >= 3 && given <= 8 ? given : control.profile.blocks_read;
  rules.idle_limit = read - 2;
  return rules;
}

AlarmId alarm_of(CompensationError error) {
  switch (error) {
    case CompensationError::NoIntersection:
    case CompensationError::StartOrEndWithinArc:  // of corners with arcs, which there are none of
      return AlarmId::NoIntersection;
    case CompensationError::ArcAtStartOrEnd:
      return AlarmId::ArcAtStartOrEnd;
    case CompensationError::PlaneChanged:
      return AlarmId::PlaneInCompensation;
    case CompensationError::ArcWithoutRadius:
      return AlarmId::ArcWithoutRadius;
    case CompensationError::Interference:
      return AlarmId::Interference;
  }
  contract_violated("every error has its alarm", __FILE__, __LINE__);
}

MaybeFailure to_machine(Control& control, const PathBlock& block, const OffsetPlane& plane) {
  if (const auto fault = control.outlet.move(block, plane)) {
    return from_late_fault(control, *fault);
  }
  return std::nullopt;
}

/// The same for a block that has waited for others.
MaybeFailure late_to_machine(Control& control, const PathBlock& block, const OffsetPlane& plane) {
  auto late = to_machine(control, block, plane);
  if (late && !late->block.is_known()) {
    late->block = block.where;
  }
  return late;
}

/// What came out of the compensation goes to the machine.
MaybeFailure carry_out(Control& control, const CompensationResult& result) {
  if (!result) {
    Failure failure;
    failure.id = alarm_of(result.error().error);
    failure.block = result.error().where;
    failure.calls = result.error().calls;
    return failure;
  }
  for (const PathItem& item : result.value()) {
    if (const auto* const pause = std::get_if<Pause>(&item)) {
      if (const auto late = control.outlet.pause(*pause)) {
        return from_late_fault(control, *late);
      }
      continue;
    }
    const PathBlock& block = std::get<PathBlock>(item);
    if (auto late = late_to_machine(control, block, control.cutter.command.plane)) {
      return late;
    }
  }
  return std::nullopt;
}

bool is_side(const EvaluatedWord& word) {
  return word.letter == 'G' && (word.number == 41.0 || word.number == 42.0);
}

bool needs_cancel(const Control& control, const NcBlock& block) {
  const bool by_code =
      block.code != nullptr && std::find(std::begin(kNeedCancel), std::end(kNeedCancel),
                                         block.code->action) != std::end(kNeedCancel);
  return by_code || in_canned_cycle(control);
}

/// Why this block cannot stand in G41 or G42.
Failure refusal(const NcBlock& block) {
  if (block.code == nullptr) {
    return block_failure(AlarmId::NotInCompensation, "a canned cycle in G41 or G42");
  }
  if (block.code->action == GAction::Scaling) {
    return block_failure(AlarmId::ScalingInCompensation);
  }
  return block_failure(
      block.code->action == GAction::Skip ? AlarmId::SkipNotAllowed : AlarmId::NotInCompensation,
      fmt::format("{} in G41 or G42", to_text(block.code->number)));
}

/// Executes what waits and gives the axes free: the next move starts from where they stand.
MaybeFailure leave(Control& control) {
  auto failure = end_read_ahead(control);
  control.cutter.compensation.disengage();
  return failure;
}

/// From the programmed path to that of the tool centre.
MaybeFailure compensate(Control& control, const PathBlock& block,
                        const CompensationCommand& command) {
  CutterCompensation& compensation = control.cutter.compensation;
  return compensation.engaged() ? carry_out(control, compensation.take(block, command))
                                : late_to_machine(control, block, offset_plane(control));
}

MaybeFailure compensate_pause(Control& control, const Pause& pause,
                              const CompensationCommand& command) {
  CutterCompensation& compensation = control.cutter.compensation;
  if (compensation.engaged()) {
    return carry_out(control, compensation.pass(pause, command));
  }
  const auto late = control.outlet.pause(pause);
  return late ? MaybeFailure(from_late_fault(control, *late)) : std::nullopt;
}

MaybeFailure compensate_all(Control& control, const PathItems& items,
                            const CompensationCommand& command) {
  for (const PathItem& item : items) {
    const auto* const wait = std::get_if<Pause>(&item);
    if (auto failure = wait != nullptr ? compensate_pause(control, *wait, command)
                                       : compensate(control, std::get<PathBlock>(item), command)) {
      return failure;
    }
  }
  return std::nullopt;
}

/// A block that has ,C or ,R, or stands behind one that has.
MaybeFailure past_corner(Control& control, const PathBlock& block) {
  CutterStage& cutter = control.cutter;
  const bool waits = cutter.corners.holds();
  if (auto failure = waits ? refuse_corner_before(control, block) : std::nullopt) {
    return failure;
  }
  const AxisPositions q_M_from =
      waits ? cutter.corners.held_end()
            : control.coordinates.to_path(control.coordinates.programmed());
  const auto given = cutter.corners.take(block, q_M_from, offset_plane(control), cutter.wish);
  if (!given) {
    return from_corner_fault(given.error());
  }
  auto failure = compensate_all(control, given.value().before, cutter.held_command);
  if (!failure) {
    failure = compensate_all(control, std::exchange(cutter.behind_corner, {}), cutter.held_command);
  }
  if (!failure) {
    failure = compensate_all(control, given.value().now, cutter.command);
  }
  cutter.held_command = cutter.command;
  return failure;
}

/// What G40, G41 and G42 of a block, or of one before it, command.
MaybeFailure command_compensation(Control& control, const NcBlock& block) {
  const int code = control.modal.group[Group::CutterCompensation].whole;
  CutterStage& cutter = control.cutter;
  if (needs_cancel(control, block)) {
    return code == 40 ? leave(control) : refusal(block);
  }
  const auto radius = cutter_radius(control);
  if (!radius) {
    return radius.error();
  }
  CompensationCommand command;
  command.state = code != 40 && control.modal.word('D') != 0.0 ? State::On : State::Off;
  command.plane = offset_plane(control);
  if (command.state == State::On && control.coordinates.tilts_unled(control.modal.plane().across)) {
    return block_failure(AlarmId::TiltedBySettingError, "G41 or G42 in a part that G54.4 tilts");
  }
  // A mirrored path has its part on the other side.
  const bool mirrored = control.coordinates.transform().reverses_turns(control.modal.plane());
  command.offset = (code == 42) != mirrored ? -radius.value() : radius.value();
  const auto& words = block.words.all();
  command.written = std::any_of(words.begin(), words.end(), is_side)
                        ? CompensationCommand::Written::Here
                        : CompensationCommand::Written::Before;
  command.where = block.where;
  if (command.state == State::Off && command.written == CompensationCommand::Written::Here &&
      !block.words.has('D')) {
    control.warn_once(source::DiagnosticId::WordWithoutEffect, block.where,
                      fmt::format("G{} without D, which is 0", code));
  }
  cutter.command = command;
  if (command.state == State::On && control.transforms.turns_other_than(control.modal.plane())) {
    return block_failure(AlarmId::PlaneInRotation);
  }
  if (command.state == State::On && !cutter.compensation.engaged()) {
    if (cutter.corners.holds()) {
      return block_failure(AlarmId::CornerWithoutMove, "G41 and G42 begin behind a corner");
    }
    cutter.compensation.set_rules(rules_of(control));
    cutter.compensation.engage(control.path_position(), command.plane);
  }
  return std::nullopt;
}

}  // namespace

OffsetPlane offset_plane(const Control& control) {
  const Plane plane = control.modal.plane();
  return {plane.first, plane.second};
}

MaybeFailure travel(Control& control, const PathBlock& block) {
  control.stopped_skip.reset();
  CutterStage& cutter = control.cutter;
  cutter.fed = true;
  const bool has_corner = cutter.corners.holds() || cutter.wish.kind != CornerWish::Kind::Sharp;
  if (!has_corner && !cutter.compensation.engaged()) {
    return to_machine(control, block, offset_plane(control));
  }
  PathBlock waiting = block;
  waiting.calls = control.outlet.calls_now();
  waiting.leads = control.coordinates.leader();  // an offset may be another one when it goes
  return has_corner ? past_corner(control, waiting) : compensate(control, waiting, cutter.command);
}

MaybeFailure pause(Control& control, double seconds) {
  CutterStage& cutter = control.cutter;
  const Pause pause{seconds, control.block};
  cutter.fed = true;
  if (cutter.corners.holds()) {
    cutter.behind_corner.emplace_back(pause);
    return std::nullopt;
  }
  return compensate_pause(control, pause, cutter.command);
}

MaybeFailure read_compensation(Control& control, const NcBlock& block) {
  CutterStage& cutter = control.cutter;
  cutter.fed = false;
  const bool is_off = control.modal.group[Group::CutterCompensation].whole == 40;
  return is_off && !cutter.compensation.engaged() ? std::nullopt
                                                  : command_compensation(control, block);
}

MaybeFailure end_compensated_block(Control& control) {
  CutterStage& cutter = control.cutter;
  if (!cutter.compensation.engaged() || cutter.fed) {
    return std::nullopt;
  }
  return carry_out(control, cutter.compensation.pass(std::nullopt, cutter.command));
}

MaybeFailure end_read_ahead(Control& control) {
  if (auto failure = refuse_waiting_corner(control)) {
    return failure;
  }
  return control.cutter.compensation.engaged()
             ? carry_out(control, control.cutter.compensation.flush())
             : std::nullopt;
}

}  // namespace g31::fanuc
