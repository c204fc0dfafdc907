#include "interpreter/dialects/fanuc/execute/codes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"
#include "interpreter/dialects/fanuc/execute/spindle.h"
#include "interpreter/dialects/fanuc/vocabulary/axis_words.h"
#include "interpreter/dialects/fanuc/vocabulary/fine_feed.h"

namespace g31::fanuc {
namespace {

constexpr GNumber kToolReplacement{100, 0};
constexpr int kSurfaceSpeed = 96;

void end_canned_cycle(Control& control) {
  control.modal.group[Group::CannedCycle] = {80, 0};
}

/// G50, G69, G15.
void end_mode(Control& control, GAction action, Codes& codes) {
  if (action == GAction::ScalingOff) {
    cancel_scaling(control);
  } else if (action == GAction::RotationOff) {
    cancel_rotation(control);
  } else {
    control.polar.reset();
    codes.starts_polar = false;
  }
}

/// What the rest of the block is to know of a modal code.
void note_modal_code(const Control& control, const GCode& code, Codes& codes) {
  codes.starts_plane = code.action == GAction::TiltedPlane ||
                       (codes.starts_plane && code.action != GAction::RotationOff);
  if (is_frame(code.action)) {
    codes.frame = &code;
  } else if (code.action == GAction::ToolLength || code.action == GAction::TipControl) {
    codes.tool_length = &code;
  } else if (code.action == GAction::WorkOffset) {
    codes.work_offset = &code;
  } else if (code.action == GAction::PolarOn) {
    codes.starts_polar = true;
  } else if (code.action == GAction::CannedCycle) {
    codes.starts_cycle = codes.starts_cycle || !in_canned_cycle(control);
  } else if (code.action == GAction::SurfaceSpeed) {
    codes.starts_surface_speed = code.number.whole == kSurfaceSpeed;
  } else if (code.action == GAction::LengthUnit) {
    codes.unit = &code;
  }
}

/// What a modal code does at once, before the other words of its block.
void take_modal_code(Control& control, const GCode& code, Codes& codes) {
  note_modal_code(control, code, codes);
  if (code.action == GAction::ScalingOff || code.action == GAction::RotationOff ||
      code.action == GAction::PolarOff) {
    end_mode(control, code.action, codes);
  } else if (code.action == GAction::OriginOnTable) {
    control.coordinates.shift_with_table(control.port.position());
  } else if (code.action == GAction::OriginOnTableOff) {
    control.coordinates.end_shift_with_table();
  } else if (code.action == GAction::Motion || code.action == GAction::CycleOff) {
    end_canned_cycle(control);
  } else if (code.action == GAction::FeedType && control.modal.inverse_time()) {
    control.modal.feed = 0.0;  // strokes in a minute are no feed (M700V programming manual, 7.5)
  }
  if (code.action == GAction::SurfaceSpeed && control.modal.surface_speed()) {
    control.spindle.turns = spindle_speed(control);
  }
  control.modal.group[code.group] = code.number;
}

/// G60: one-shot, or in the place of G00 by a parameter.
void take_single_direction(Control& control, const GCode& code) {
  const auto modal = control.profile.single_direction.modal;
  if (modal && control.parameters.is_on(*modal)) {
    end_canned_cycle(control);
    control.modal.group[Group::Motion] = code.number;
  } else {
    control.single_direction = true;
  }
}

/// Calls are taken out of a block before it comes here; these are left when another word calls,
/// too.
bool is_second_call(const EvaluatedWord& word) {
  constexpr double kCalls[] = {65.0, 66.0, 66.1, 67.0};
  return std::ranges::find(kCalls, word.number) != std::end(kCalls);
}

/// What leads the axes: tool centre point control, a tilted plane, or both.
struct Leaders {
  bool holds_tip = false;
  bool has_plane = false;
  bool is_rotation = false;  ///< the plane is what G68 with I J K turns
};

/// A code that ends a tilted plane while an offset of G41 or G42 is left, which is in its
/// coordinates (FANUC B-63664EN p. 392 of its G68 and G69).
MaybeFailure refuse_with_offset(const Control& control, const EvaluatedWord& word,
                                const GCode& code) {
  return code.action == GAction::RotationOff && control.coordinates.plane() &&
                 control.cutter.compensation.engaged()
             ? MaybeFailure(at_word(AlarmId::NotInCompensation, word,
                                    fmt::format("{} of a tilted plane while an offset of G41 or "
                                                "G42 is left: move in the plane with G40 first",
                                                to_text(code.number))))
             : std::nullopt;
}

/// A code that has no place in a tilted plane, or under tool centre point control.
MaybeFailure refuse_when_led(Leaders leaders, const EvaluatedWord& word, const GCode& code) {
  const bool holds_tip = leaders.holds_tip;
  if (holds_tip && code.action == GAction::TiltedPlane) {
    return at_word(AlarmId::TiltedPlaneNotAllowed, word,
                   fmt::format("{} under tool centre point control", to_text(code.number)));
  }
  const bool starts_side = code.group == Group::CutterCompensation && code.number.whole != 40;
  if (holds_tip && (starts_side || is_barred_under_tip_control(code.action))) {
    return at_word(AlarmId::NotUnderTipControl, word,
                   fmt::format("{} under tool centre point control", to_text(code.number)));
  }
  const bool turns_on = leaders.is_rotation && code.action == GAction::Rotation;
  return leaders.has_plane && !turns_on && is_barred_in_plane(code.action)
             ? MaybeFailure(at_word(
                   AlarmId::NotInTiltedPlane, word,
                   fmt::format("{} in {}", to_text(code.number),
                               leaders.is_rotation ? "space that G68 turns" : "a tilted plane")))
             : std::nullopt;
}

/// Codes that have no place beside the one that begins to lead the axes.  A work offset is selected
/// before a plane, whose words no other code may take.
[[gnu::cold]] MaybeFailure refuse_beside_leader(const Control& control, const BlockWords& words,
                                                Leaders leaders) {
  for (const EvaluatedWord& word : words.all()) {
    const GCode* const code =
        word.letter == 'G' ? find_g_code(word.number, control.profile) : nullptr;
    if (code == nullptr || code->action == GAction::WorkOffset) {
      continue;
    }
    if (auto failure = refuse_when_led(leaders, word, *code)) {
      return failure;
    }
    const bool is_other = code->group == Group::OneShot && !leaves_words(code->action);
    if (leaders.has_plane && is_other) {
      return at_word(
          AlarmId::TiltedPlaneNotAllowed, word,
          fmt::format("{} beside a tilted plane, whose words it would take: write it into "
                      "the next block",
                      to_text(code->number)));
    }
    if (leaders.has_plane && is_frame(code->action) && code->action != GAction::TiltedPlane) {
      return at_word(AlarmId::NotInTiltedPlane, word,
                     fmt::format("{} beside a tilted plane", to_text(code->number)));
    }
  }
  return std::nullopt;
}

/// Without the option the code is not there: FANUC 30i operator's manual B-63944EN, alarm PS0010.
MaybeFailure refuse_without_rotary_axes(const Control& control, const EvaluatedWord& word,
                                        const GCode& code) {
  if (!needs_rotary_axes(code.action)) {
    return std::nullopt;
  }
  for (int axis = kLinearAxisCount; axis < static_cast<int>(kAxisCount); ++axis) {
    if (control.port.travel(axis)) {
      return std::nullopt;
    }
  }
  return at_word(AlarmId::ImproperGCode, word,
                 fmt::format("{} is of machines with rotary axes: [machine.axes.C] of the set-up "
                             "sheet gives it one",
                             to_text(code.number)));
}

/// In line: a failure that is returned through memory costs lines a twentieth.
[[gnu::always_inline]] inline MaybeFailure take_g_word(Control& control, const EvaluatedWord& word,
                                                       Codes& codes) {
  if (is_second_call(word)) {
    return at_word(AlarmId::MixedStatement, word,
                   fmt::format("G{} together with another call", word.number));
  }
  const GCode* const code = find_g_code(word.number, control.profile);
  if (code == nullptr) {
    return at_word(AlarmId::ImproperGCode, word,
                   fmt::format("the control has no G{}", word.number));
  }
  if (code->action == GAction::Refused) {
    return at_word(AlarmId::ImproperGCode, word,
                   fmt::format("{}, {}", to_text(code->number), code->text));
  }
  if (auto failure = refuse_without_rotary_axes(control, word, *code)) {
    return failure;
  }
  constexpr int kB = axis_index('B');
  if (code->action == GAction::OriginOnTable && control.coordinates.shift()[kB] != 0.0) {
    return at_word(AlarmId::ImproperGCode, word, "G254 with a work offset whose B is not 0");
  }
  if (control.coordinates.leader()) {
    const Leaders leaders{control.coordinates.tip_system() != TipSystem::None,
                          control.coordinates.plane().has_value(),
                          control.transforms.space_centre.has_value()};
    if (auto failure = refuse_when_led(leaders, word, *code)) {
      return failure;
    }
    if (auto failure = refuse_with_offset(control, word, *code)) {
      return failure;
    }
  }
  if (code->group != Group::OneShot) {
    take_modal_code(control, *code, codes);
  } else if (code->action == GAction::ExactStop) {
    control.stops_exactly = true;
  } else if (code->action == GAction::ContourControl) {
    codes.contour_switch = code;
  } else if (code->action == GAction::SingleDirection) {
    take_single_direction(control, *code);
  } else if (!leaves_words(code->action)) {
    codes.one_shot = code;
  }
  return std::nullopt;
}

/// How many digits the control takes of an M, S or T that a variable gave, too (MB-032).
MaybeFailure refuse_long(const Control& control, const EvaluatedWord& word, int number) {
  const auto limit = word.letter == 'M'   ? std::optional(ParameterId::DigitsOfM)
                     : word.letter == 'S' ? std::optional(ParameterId::DigitsOfS)
                     : word.letter == 'T' ? std::optional(ParameterId::DigitsOfT)
                                          : std::nullopt;
  const double digits = limit ? control.parameters.get(*limit) : 0.0;
  return digits >= 1.0 && std::abs(number) >= std::pow(10.0, digits)
             ? MaybeFailure(at_word(AlarmId::TooManyDigits, word,
                                    fmt::format("{}{}: {} digits", word.letter, number, digits)))
             : std::nullopt;
}

/// F S T M and the like: recorded for #4102.., M codes otherwise skipped.
[[gnu::hot]] MaybeFailure take_plain_word(Control& control, const EvaluatedWord& word,
                                          Codes& codes) {
  const auto refused = [&] { return at_word(wrong_plain_word(word, control.profile), word); };
  switch (word.letter) {  // outside it whether a number fits would be asked by letter again
    case 'F':
      if (!fits_plain_word(word, control.profile)) {
        return refused();
      }
      control.modal.feed = written_feed(control, word);
      control.has_own_feed = true;
      return std::nullopt;
    case 'D':
      if (is_measuring_distance(word.letter, codes.one_shot, control.profile)) {
        return std::nullopt;
      }
      [[fallthrough]];
    case 'M':
    case 'S':
    case 'T':
    case 'H': {
      if (!fits_plain_word(word, control.profile)) {
        return refused();
      }
      const int number = nearest_integer(word.number);
      control.modal.word(word.letter) = number;
      if (word.letter == 'S') {
        take_speed(control, number, codes);
      }
      if (word.letter == 'M' && number == kToolChange && control.profile.replaces_tools) {
        codes.one_shot = find_g_code(kToolReplacement, control.profile);
      }
      return refuse_long(control, word, number);
    }
    default:
      return std::nullopt;
  }
}

/// The group of a G word; 0: none, or one that has effect in its block only.
int group_of(const EvaluatedWord& word, const Profile& profile) {
  const GCode* const code = find_g_code(word.number, profile);
  return code != nullptr ? static_cast<int>(code->group) : 0;
}

/// An address twice, or two G codes of one group (MB-014); several M are no repeat.
MaybeFailure refuse_repeats(const BlockWords& words, const Profile& profile) {
  std::set<int> seen;
  for (const EvaluatedWord& word : words.all()) {
    const int group = word.letter == 'G' ? group_of(word, profile) : -word.letter;
    if (word.letter != 'M' && group != 0 && !seen.insert(group).second) {
      return at_word(AlarmId::AddressTwice, word, fmt::format("{} appears twice", word.letter));
    }
  }
  return std::nullopt;
}

/// Addresses of axes that the machine does not have.  U of G04 is a time (MB-285), and a code that
/// is not simulated may take any word.
MaybeFailure refuse_missing_axes(const Control& control, const BlockWords& words,
                                 const Codes& codes) {
  const GAction action = codes.one_shot != nullptr ? codes.one_shot->action : GAction::Modal;
  if (action == GAction::Unsimulated) {
    return std::nullopt;
  }
  constexpr std::string_view kNotOnEachMachine = "ABCUVW";
  if (!words.has_any(letters_of(kNotOnEachMachine))) {
    return std::nullopt;
  }
  for (const char letter : kNotOnEachMachine) {
    if (!words.has(letter) || (action == GAction::Dwell && letter == 'U')) {
      continue;
    }
    const int axis = axis_index(letter);
    if (axis < 0 || !control.port.travel(axis)) {
      return at_word(
          AlarmId::IllegalAddress, *words.find(letter),
          axis < 0
              ? fmt::format("the machine has no axis {}: a mill has X, Y, Z, A, B and C", letter)
              : fmt::format("the machine has no axis {}: [machine.axes.{}] of the "
                            "set-up sheet gives it one",
                            letter, letter));
    }
  }
  return std::nullopt;
}

}  // namespace

/// A lead and a feed per revolution count hundredths of a mm, or thousandths with parameter
/// 1405.1 (inch: a tenth of that), one per minute what the control has for it, or parameter 1403.0.
double counted_feed(const Control& control, const EvaluatedWord& word) {
  if (control.modal.inverse_time()) {
    return word.number / control.profile.inverse_time.counts;
  }
  const bool inch = control.scale.unit == LengthUnit::Inch;
  if (!control.modal.per_revolution() && !control.modal.cuts_thread()) {
    const bool fine = control.parameters.is_on(ParameterId::FineFeed);
    const FeedCounts& counts = fine ? kFineFeedCounts : control.profile.feed_counts;
    return word.number / (inch ? counts.per_inch : counts.per_mm);
  }
  const double per_mm = control.parameters.is_on(ParameterId::FineFeedPerTurn) ? 1000.0 : 100.0;
  return word.number / (inch ? per_mm * 100.0 : per_mm);
}

bool commands_motion(const BlockWords& words, const Profile& profile) {
  bool has_axis = false;
  for (const EvaluatedWord& word : words.all()) {
    const GCode* const code = word.letter == 'G' ? find_g_code(word.number, profile) : nullptr;
    if (code != nullptr && takes_axis_words(code->action)) {
      return false;
    }
    has_axis = has_axis || axis_index(word.letter) >= 0;
  }
  return has_axis;
}

namespace {

/// G05.1 Q1 and Q0, G08 P1 and P0.
void switch_contour_control(Control& control, const BlockWords& words, const GCode* code) {
  if (code == nullptr) {
    return;
  }
  constexpr int kLookAhead = 8;
  const bool looks = code->number.whole == kLookAhead;
  if (const EvaluatedWord* const on = words.find(looks ? 'P' : 'Q')) {
    (looks ? control.rapids.looks_ahead : control.rapids.contour_control) = on->number == 1.0;
  }
}

/// G20 and G21.  Of a Haas they say what its setting 9 has to be: the manual (NGC 2017, G20 and
/// G21) makes G20 an alarm where it is another one, and to take G21 alike is ours.  Where no sheet
/// says how the setting is, it is as the first of them says.
MaybeFailure take_unit(Control& control, const GCode& code) {
  constexpr int kInches = 20;
  const auto unit = code.number.whole == kInches ? LengthUnit::Inch : LengthUnit::Millimetre;
  const bool differs = unit != control.scale.unit;
  const bool is_setting = control.profile.unit_is_setting;
  if (differs && is_setting && control.parameters.is_given(ParameterId::InchInput)) {
    return block_failure(
        AlarmId::ImproperGCode,
        fmt::format("{}, and setting 9 (#20009, parameter 0.2) is {}", to_text(code.number),
                    unit == LengthUnit::Inch ? "mm" : "inch"));
  }
  if (differs || is_setting) {
    control.set_unit(unit);
  }
  return std::nullopt;
}

}  // namespace

[[gnu::hot]] Result<Codes, Failure> take_words(Control& control, const BlockWords& words) {
  if (control.parameters.is_on(ParameterId::RefusesRepeats)) {
    if (auto failure = refuse_repeats(words, control.profile)) {
      return *std::move(failure);
    }
  }
  Codes codes;
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter == 'G') {
      if (auto failure = take_g_word(control, word, codes)) {
        return *std::move(failure);
      }
    }
  }
  const Leaders begun{
      codes.tool_length != nullptr && codes.tool_length->action == GAction::TipControl,
      codes.starts_plane};
  if (begun.holds_tip || begun.has_plane) {
    if (auto failure = refuse_beside_leader(control, words, begun)) {
      return *std::move(failure);
    }
  }
  if (auto failure = refuse_missing_axes(control, words, codes)) {
    return *std::move(failure);
  }
  if (control.modal.inverse_time()) {
    if (auto failure = refuse_in_inverse_time(control, codes)) {
      return *std::move(failure);
    }
  }
  switch_contour_control(control, words, codes.contour_switch);
  if (codes.unit != nullptr) {
    if (auto failure = take_unit(control, *codes.unit)) {
      return *std::move(failure);
    }
  }
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter != 'G') {
      if (auto failure = take_plain_word(control, word, codes)) {
        return *std::move(failure);
      }
    }
  }
  if (codes.starts_surface_speed) {
    if (auto failure = take_surface_axis(control, words)) {
      return *std::move(failure);
    }
  }
  return codes;
}

}  // namespace g31::fanuc
