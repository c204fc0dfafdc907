#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/vocabulary/axis_words.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

/// A block that goes on in rotation (G68) and has a code of other origins or of reference points.
[[gnu::cold]] void tell_barred_in_rotation(Control& control, const Codes& codes,
                                           source::Location where) {
  const bool begins_it = codes.frame != nullptr;
  const GCode* const barred =
      codes.work_offset != nullptr ? codes.work_offset
      : codes.one_shot != nullptr && is_barred_in_rotation(codes.one_shot->action) ? codes.one_shot
                                                                                   : nullptr;
  if (barred != nullptr && !begins_it) {
    control.warn_once(source::DiagnosticId::OriginInRotation, where, to_text(barred->number));
  }
}

/// What a block commands while G68 turns a plane.
[[gnu::cold]] const BlockWords& words_in_rotation(Control& control, const BlockWords& words,
                                                  const Codes& codes, source::Location where) {
  if (control.profile.bars_origins_in_rotation) {
    tell_barred_in_rotation(control, codes, where);
  }
  const auto omitted = word_before_rotation(control, words, codes);
  if (!omitted) {
    return words;
  }
  control.completed = words.only([](const EvaluatedWord&) { return true; });
  control.completed.add(*omitted);
  return control.completed;
}

/// G22 with limits: the control would watch them, nothing here does.
MaybeFailure execute_stroke_check(Control& control, const NcBlock& block) {
  if (block.has_axis_word) {
    control.warn_once(source::DiagnosticId::NotSimulated, block.where, "the limits of G22");
  }
  return std::nullopt;
}

MaybeFailure execute_nothing(Control& control, const NcBlock& block) {
  control.warn_once(source::DiagnosticId::NotSimulated, block.where, to_text(block.code->number));
  return std::nullopt;
}

MaybeFailure end_data(Control&, const NcBlock&) {
  return std::nullopt;
}

/// A code that takes the words of its block for itself, and what does so.
struct ActionRow {
  GAction action;
  MaybeFailure (*execute)(Control&, const NcBlock&);
};

constexpr ActionRow kActions[] = {
    {GAction::Skip, execute_skip},
    {GAction::Dwell, execute_dwell},
    {GAction::MachineMove, execute_machine_move},
    {GAction::ToReference, execute_reference},
    {GAction::FromReference, execute_from_reference},
    {GAction::CheckReference, execute_check_reference},
    {GAction::SetData, execute_set_data},
    {GAction::EndData, end_data},
    {GAction::LocalShift, execute_local_shift},
    {GAction::SetPosition, execute_set_position},
    {GAction::PresetSystem, execute_preset},
    {GAction::Mirror, execute_mirror},
    {GAction::MirrorOff, execute_mirror_off},
    {GAction::Scaling, execute_scaling},
    {GAction::Rotation, execute_rotation},
    {GAction::TiltedPlane, execute_tilted_plane},
    {GAction::ToolToPlane, execute_tool_to_plane},
    {GAction::TableOffset, execute_table_offset},
    {GAction::SettingError, execute_setting_error},
    {GAction::MeasureTool, execute_tool_measurement},
    {GAction::MeasureDiameter, execute_diameter_measurement},
    {GAction::MeasureWork, execute_work_measurement},
    {GAction::MeasureCentre, execute_work_measurement},
    {GAction::StrokeCheck, execute_stroke_check},
    {GAction::ToolReplacement, execute_tool_replacement},
    {GAction::HolePattern, execute_hole_pattern},
    {GAction::Unsimulated, execute_nothing},
};

/// Whether something does what a row of g_codes.def says: a row above, or what sees the code first.
consteval bool is_done(Group group, GAction action) {
  constexpr GAction kDoneBefore[] = {GAction::ExactStop,       GAction::ContourControl,
                                     GAction::SingleDirection, GAction::NoEffect,
                                     GAction::Refused,         GAction::MacroCall};
  return group != Group::OneShot ||
         std::ranges::find(kDoneBefore, action) != std::end(kDoneBefore) ||
         std::ranges::find(kActions, action, &ActionRow::action) != std::end(kActions);
}
#define G_CODE_OF(set, whole, tenth, group, action, text) \
  static_assert(is_done(Group::group, GAction::action), "G" #whole ": nothing does " #action);
#define G_CODE(whole, tenth, group, action, text) \
  G_CODE_OF(Family, whole, tenth, group, action, text)
#include "interpreter/dialects/fanuc/vocabulary/g_codes.def"
#undef G_CODE
#undef G_CODE_OF

MaybeFailure execute_action(Control& control, const NcBlock& block) {
  // G27 to G30 have no place between holes (MB-312).
  if (in_canned_cycle(control) && is_of_reference_point(block.code->action)) {
    return block_failure(AlarmId::NotAllowedInCycle, to_text(block.code->number));
  }
  if (is_fence(*block.code, control.profile)) {
    if (const auto late = control.outlet.stand_still()) {
      return from_late_fault(control, *late);
    }
  }
  const auto* const row = std::ranges::find(kActions, block.code->action, &ActionRow::action);
  G31_EXPECTS(row != std::end(kActions));  // the other codes leave their block's words to others
  return row->execute(control, block);
}

constexpr std::uint32_t kAxisWords = letters_of({kAxisLetters, kAxisCount});

MaybeFailure select_offsets(Control& control, NcBlock& block, const Codes& codes) {
  if (codes.work_offset != nullptr) {
    if (auto failure = select_work_offset(control, block.words, codes.work_offset->number)) {
      return failure;
    }
  }
  const bool is_commanded = codes.tool_length != nullptr || block.words.has('H');
  if (!is_commanded && !control.parameters.is_on(ParameterId::LengthAtNextBlock)) {
    return std::nullopt;
  }
  auto failure = select_tool_length(control, block, codes.tool_length);
  block.changes_length = block.changes_length && is_commanded;
  return failure;
}

/// An arc without an end: it has a centre, so it goes round (MB-302).
bool is_full_circle(const Control& control, const NcBlock& block) {
  const int g = control.modal.group[Group::Motion].whole;
  const Plane plane = control.modal.plane();
  return (g == 2 || g == 3) &&
         (block.words.has(plane.first_centre) || block.words.has(plane.second_centre));
}

/// G43, G44, G49 or H without an axis (MB-296): not along an arc, which its words would have to
/// say.
bool moves_by_length(const Control& control, const NcBlock& block) {
  return block.changes_length && control.modal.group[Group::Motion].whole <= 1;
}

/// What the words command when the modal codes and offsets are in force.
[[gnu::hot]] MaybeFailure execute_words(Control& control, const NcBlock& block,
                                        double feed_before) {
  if (block.code != nullptr) {
    auto failure = execute_action(control, block);
    const bool measures =
        block.code->action == GAction::Skip || block.code->action == GAction::MeasureTool;
    if (measures && control.profile.skip_feed == SkipFeed::OneBlock) {
      control.modal.feed = feed_before;
    }
    return failure;
  }
  if (in_canned_cycle(control)) {
    return execute_canned_cycle(control, block);
  }
  const bool moves = block.has_axis_word || is_full_circle(control, block) ||
                     turns_by_direction(control, block.words) || moves_by_length(control, block);
  return moves ? execute_motion(control, block) : std::nullopt;
}

}  // namespace

[[gnu::hot]] MaybeFailure execute_block(Control& control, const BlockWords& words,
                                        source::Location where) {
  control.block = where;
  if (control.data_input != DataInput::None) {
    return execute_data_block(control, words);
  }
  const double feed_before = control.modal.feed;
  control.stops_exactly = false;
  control.has_own_feed = false;
  control.single_direction = false;
  const auto codes = take_words(control, words);
  if (!codes) {
    return codes.error();
  }
  const BlockWords& commanded =
      control.transforms.rotation ? words_in_rotation(control, words, codes.value(), where) : words;
  NcBlock block{commanded, where, codes.value().frame, commanded.has_any(kAxisWords)};
  if (auto failure = select_offsets(control, block, codes.value())) {
    return failure;
  }
  if (auto failure = refuse_unfinished_plane(control, codes.value())) {
    return failure;
  }
  command_machine(control, words);
  if (codes.value().starts_polar) {
    start_polar(control);
  }
  if (codes.value().starts_cycle && in_canned_cycle(control)) {
    start_canned_cycle(control);
  }
  if (block.code == nullptr) {
    block.code = codes.value().one_shot;
  }
  if (auto failure = read_corner(control, block)) {
    return failure;
  }
  if (auto failure = read_compensation(control, block)) {
    return failure;
  }
  if (auto failure = execute_words(control, block, feed_before)) {
    return failure;
  }
  keep_marked_point(control, words);
  return end_compensated_block(control);
}

Failure block_failure(AlarmId id, std::string detail) {
  Failure failure;
  failure.id = id;
  failure.detail = std::move(detail);
  return failure;
}

Failure at_place(AlarmId id, syntax::ShortSpan where, std::string detail) {
  Failure failure = block_failure(id, std::move(detail));
  failure.where = where;
  return failure;
}

Failure at_word(AlarmId id, const EvaluatedWord& word, std::string detail) {
  return at_place(id, word.span, std::move(detail));
}

Failure at_word(WrongValue wrong, const EvaluatedWord& word) {
  return at_word(wrong.id, word, std::move(wrong.detail));
}

MaybeFailure at_word(MaybeWrong wrong, const EvaluatedWord& word) {
  return wrong ? MaybeFailure(at_word(*std::move(wrong), word)) : std::nullopt;
}

Result<int, Failure> integer_of(const EvaluatedWord& word, const Profile& profile) {
  return is_integer(word, profile) ? Result<int, Failure>(nearest_integer(word.number))
                                   : at_word(point_in(word), word);
}

Failure from_fault(const machine::MachineFault& fault) {
  Failure failure;
  failure.status = runtime::Status::Collision;
  failure.id = AlarmId::SoftLimit;
  failure.alarm_number = fault.kind == machine::FaultKind::Collision ? -1 : 0;
  failure.detail = fault.what;
  failure.block = path::Outlet::place_of(fault);
  return failure;
}

Failure from_late_fault(Control& control, const machine::MachineFault& fault) {
  control.coordinates.arrived_at_machine(control.port.position());
  return from_fault(fault);
}

}  // namespace g31::fanuc
