#include "interpreter/dialects/fanuc/execute/compensation.h"

#include <algorithm>
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
    GAction::MeasureWork,    GAction::MeasureCentre, GAction::Skip};

OffsetPlane offset_plane(const Control& control) {
  const Plane plane = control.modal.plane();
  return {plane.first, plane.second};
}

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

/// What came out of the compensation goes to the machine.
MaybeFailure carry_out(Control& control, const CompensationResult& result) {
  if (!result) {
    Failure failure;
    failure.id = alarm_of(result.error().error);
    failure.block = result.error().where;
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
    if (auto late = to_machine(control, block, control.cutter.command.plane)) {
      late->block = late->block.is_known() ? late->block : block.where;
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

}  // namespace

MaybeFailure travel(Control& control, const PathBlock& block) {
  control.stopped_skip.reset();
  CutterStage& cutter = control.cutter;
  if (!cutter.compensation.engaged()) {
    return to_machine(control, block, offset_plane(control));
  }
  cutter.fed = true;
  return carry_out(control, cutter.compensation.take(block, cutter.command));
}

MaybeFailure pause(Control& control, double seconds) {
  const Pause pause{seconds, control.block};
  if (!control.cutter.compensation.engaged()) {
    const auto late = control.outlet.pause(pause);
    return late ? MaybeFailure(from_late_fault(control, *late)) : std::nullopt;
  }
  control.cutter.fed = true;
  return carry_out(control, control.cutter.compensation.pass(pause, control.cutter.command));
}

MaybeFailure read_compensation(Control& control, const NcBlock& block) {
  const int code = control.modal.group[Group::CutterCompensation].whole;
  CutterStage& cutter = control.cutter;
  if (code == 40 && !cutter.compensation.engaged()) {
    return std::nullopt;
  }
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
  // A mirrored path has its part on the other side.
  const bool mirrored = control.coordinates.transform().reverses_turns(control.modal.plane());
  command.offset = (code == 42) != mirrored ? -radius.value() : radius.value();
  const auto& words = block.words.all();
  command.written = std::any_of(words.begin(), words.end(), is_side)
                        ? CompensationCommand::Written::Here
                        : CompensationCommand::Written::Before;
  command.where = block.where;
  cutter.command = command;
  cutter.fed = false;
  if (command.state == State::On && !cutter.compensation.engaged()) {
    cutter.compensation.set_rules(rules_of(control));
    cutter.compensation.engage(control.port.position(), command.plane);
  }
  return std::nullopt;
}

MaybeFailure end_compensated_block(Control& control) {
  CutterStage& cutter = control.cutter;
  if (!cutter.compensation.engaged() || cutter.fed) {
    return std::nullopt;
  }
  return carry_out(control, cutter.compensation.pass(std::nullopt, cutter.command));
}

MaybeFailure end_read_ahead(Control& control) {
  return control.cutter.compensation.engaged()
             ? carry_out(control, control.cutter.compensation.flush())
             : std::nullopt;
}

}  // namespace g31::fanuc
