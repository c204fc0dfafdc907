#include "interpreter/dialects/fanuc/code/word_limits.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/vocabulary/offset_numbers.h"

namespace g31::fanuc {
namespace {

MaybeWrong wrong(AlarmId id, std::string detail) {
  return WrongValue{id, std::move(detail)};
}

bool is_out(int number, int least, int most) {
  return number < least || number > most;
}

}  // namespace

WrongValue point_in(const EvaluatedWord& word) {
  return {AlarmId::IllegalPoint, fmt::format("{} takes an integer", word.letter)};
}

bool takes_point(const EvaluatedWord& word, const Profile& profile) {
  return profile.whole_with_point.find(word.letter) != std::string_view::npos &&
         word.number == std::floor(word.number);
}

WrongValue wrong_plain_word(const EvaluatedWord& word, const Profile& profile) {
  if (word.letter == 'F') {
    return {AlarmId::IllegalMinus, "a feed cannot be negative"};
  }
  return is_integer(word, profile)
             ? WrongValue{AlarmId::IllegalMinus, fmt::format("{} counts from 0", word.letter)}
             : point_in(word);
}

bool is_measuring_distance(char letter, const GCode* code, const Profile& profile) {
  return letter == 'D' && code != nullptr && code->action == GAction::MeasureTool &&
         profile.tool_measurement == ToolMeasurement::NearPositionByWords;
}

bool is_argument(const EvaluatedWord& word, const EvaluatedWord& code, const Profile& profile) {
  const bool is_before = word.span.begin < code.span.begin;
  const bool takes_effect = profile.codes_before_call && code.number == 65.0 && is_before;
  return &word != &code && word.letter != 'P' && word.letter != 'L' &&
         !(takes_effect && word.letter == 'G');
}

WrongValue no_argument(char letter) {
  return {AlarmId::IllegalArgumentLetter,
          fmt::format("{} as argument", syntax::letter_text(letter))};
}

MaybeWrong wrong_length_offset(int number, GNumber code) {
  return is_out(number, 0, kToolOffsets)
             ? wrong(code.tenth != 0 ? AlarmId::TipControlOffset : AlarmId::IllegalOffsetNumber,
                     fmt::format("H is 0 to {}", kToolOffsets))
             : std::nullopt;
}

MaybeWrong wrong_radius_offset(int number) {
  return is_out(number, 0, kToolOffsets)
             ? wrong(AlarmId::IllegalOffsetNumber,
                     fmt::format("D{}: D is 0 to {}", number, kToolOffsets))
             : std::nullopt;
}

MaybeWrong wrong_work_system(int number, GNumber code, const Profile& profile) {
  return is_out(number, 1, profile.additional_systems)
             ? wrong(AlarmId::IllegalOffsetNumber,
                     fmt::format("{} has P1 to P{}", to_text(code), profile.additional_systems))
             : std::nullopt;
}

MaybeWrong wrong_part_error(int number, GNumber code) {
  constexpr GNumber kTableOffset{54, 2};
  const int most = code == kTableOffset ? kTableOffsets : kSettingErrors;
  return is_out(number, 0, most) ? wrong(AlarmId::IllegalOffsetNumber,
                                         fmt::format("{} has P0 to P{}", to_text(code), most))
                                 : std::nullopt;
}

MaybeWrong wrong_dwell(double seconds) {
  return seconds < 0.0 ? wrong(AlarmId::IllegalMinus, "a dwell cannot be negative") : std::nullopt;
}

MaybeWrong wrong_key_variable(int number) {
  constexpr int kAliases = 10000;
  const int common = number >= kAliases ? number - kAliases : number;
  return is_out(common, 500, 549)
             ? wrong(AlarmId::IllegalVariable, "M109 has P500 to P549, or P10500 to P10549")
             : std::nullopt;
}

MaybeWrong wrong_reference(int number) {
  return is_out(number, 2, 4) ? wrong(AlarmId::IllegalReference, fmt::format("P{}", number))
                              : std::nullopt;
}

MaybeWrong wrong_skip(int number, SkipSelection selection) {
  constexpr int kAllSignals = 255;
  constexpr int kSelections = 4;
  if (selection == SkipSelection::Mask) {
    return is_out(number, 1, kAllSignals)
               ? wrong(AlarmId::ValueOutOfRange, "P is 1 to 255, one bit for each signal")
               : std::nullopt;
  }
  const bool is_there = skips_by_torque(number) || !is_out(number, 1, kSelections);
  return is_there ? std::nullopt : MaybeWrong(no_skip_signal(number));
}

WrongValue no_skip_signal(int number) {
  return {AlarmId::SkipSignalSelect, fmt::format("P{}", number)};
}

MaybeWrong wrong_skip_axes(int count) {
  return count != 1 ? wrong(AlarmId::SkipFormat, "one axis is needed") : std::nullopt;
}

MaybeWrong wrong_scale(double factor, bool by_axis) {
  return factor == 0.0 || (!by_axis && factor < 0.0)
             ? wrong(AlarmId::IllegalScale, fmt::format("the factor is {}", factor))
             : std::nullopt;
}

MaybeWrong wrong_plane_form(int number) {
  return is_out(number, 0, 4) ? wrong(AlarmId::TiltedPlaneFormat, "P is 0 to 4") : std::nullopt;
}

MaybeWrong wrong_corner(double size) {
  return size < 0.0 ? wrong(AlarmId::IllegalMinus, "the size of a corner cannot be negative")
                    : std::nullopt;
}

WrongValue second_corner() {
  return {AlarmId::TwoCornerWords, "one of ,C and ,R in a block"};
}

}  // namespace g31::fanuc
