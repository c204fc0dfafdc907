#pragma once

#include "interpreter/dialects/fanuc/code/value_limits.h"

// What plain words take, whatever the control's state: the same for a run and for who looks at
// words without running, as value_limits.h.  Each function says nullopt of what is right.

namespace g31::fanuc {

using MaybeWrong = std::optional<WrongValue>;

inline constexpr double kCancelModal = 67.0;  ///< G67
inline constexpr int kReturn = 99;            ///< M99

inline bool has_point(const EvaluatedWord& word) {
  return word.form == syntax::ValueForm::Decimal;
}
/// Whether a whole number may have a point there, which counts for nothing.
bool takes_point(const EvaluatedWord& word, const Profile& profile);
/// Of a word whose value is an integer (M S T D H N O L P): a literal must have no point, a
/// computed one is rounded (MB-025, MB-026).
inline bool is_integer(const EvaluatedWord& word, const Profile& profile) {
  return !has_point(word) || takes_point(word, profile);
}
inline bool is_return(const EvaluatedWord& word) {
  return word.letter == 'M' && !has_point(word) && nearest_integer(word.number) == kReturn;
}
/// M99 of a block, or P or L, which are its own there.
inline bool is_of_return(const EvaluatedWord& word) {
  return word.letter == 'P' || word.letter == 'L' || is_return(word);
}
/// Of one that has a point.
WrongValue point_in(const EvaluatedWord& word);

/// Whether F, M, S, T, D and H take their number, whatever they are for.
inline bool fits_plain_word(const EvaluatedWord& word, const Profile& profile) {
  switch (word.letter) {
    case 'F':
      return word.number >= 0.0;
    case 'M':
    case 'S':
    case 'T':
      return is_integer(word, profile) && nearest_integer(word.number) >= 0;
    case 'D':
    case 'H':
      return is_integer(word, profile);
    default:
      return true;
  }
}
/// Of one that does not.
[[gnu::cold]] WrongValue wrong_plain_word(const EvaluatedWord& word, const Profile& profile);

/// D of G37, where it is a distance and no number of an offset.
/// @param code  that takes the block's words; null: none
bool is_measuring_distance(char letter, const GCode* code, const Profile& profile);

/// Whether a word of a block with G65, G66 or G66.1 is an argument: not the code itself, P and L,
/// nor, where the control has it so, a G word before G65, which takes effect first.
bool is_argument(const EvaluatedWord& word, const EvaluatedWord& code, const Profile& profile);
/// Of a letter that is none in G65 and the like (argument_letters.h).
WrongValue no_argument(char letter);

/// H.  @param code  of tool length, in force
MaybeWrong wrong_length_offset(int number, GNumber code);
/// D with G41 and G42.
MaybeWrong wrong_radius_offset(int number);
/// Whether a code names its work system by P: G54.1, G154, and G54 where there is one.
constexpr bool selects_by_number(GNumber code, bool has_p) {
  constexpr GNumber kAdditional{54, 1};
  constexpr int kAdditionalOfHaas = 154;
  return code == kAdditional || code.whole == kAdditionalOfHaas || (code.whole == 54 && has_p);
}
/// Its P.
MaybeWrong wrong_work_system(int number, GNumber code, const Profile& profile);
/// P of G54.2 and G54.4.
MaybeWrong wrong_part_error(int number, GNumber code);

/// Whether P of G04 is in seconds, else in milliseconds (MB-285).
inline bool is_dwell_in_seconds(const EvaluatedWord& p, const Profile& profile) {
  return p.form != syntax::ValueForm::Integer && profile.dwell_point_is_seconds;
}
/// The same of milliseconds.  A point is no slip to pass over, whatever the control does: P1. would
/// be a thousandth of the second that it looks like.
inline bool is_dwell_in_milliseconds(const EvaluatedWord& p) {
  return !has_point(p);
}
/// G04, and P of a canned cycle.
MaybeWrong wrong_dwell(double seconds);
/// P of M109.
MaybeWrong wrong_key_variable(int number);
/// P of G30.
MaybeWrong wrong_reference(int number);
/// P of G31, as far as parameters do not say it.
MaybeWrong wrong_skip(int number, SkipSelection selection);
/// P of G31 that has no signal.
WrongValue no_skip_signal(int number);
/// P98 and P99 of G31.
constexpr bool skips_by_torque(int number) {
  return number == 98 || number == 99;
}
/// Axes of G31 P98 and P99.
MaybeWrong wrong_skip_axes(int count);
inline constexpr double kThousandth = 0.001;
/// Whether P, I, J or K of G51 is a factor; else it counts thousandths, or what the control has for
/// them.
inline bool is_scale_factor(const EvaluatedWord& word, const Profile& profile) {
  return profile.scale.takes_fractions && word.form != syntax::ValueForm::Integer;
}
/// The factor that it is.  @pre is_scale_factor() or is_integer()
inline double scale_factor(const EvaluatedWord& word, const Profile& profile) {
  return is_scale_factor(word, profile) ? word.number
                                        : nearest_integer(word.number) / profile.scale.counts;
}
/// What it comes to.  @param by_axis  I, J or K: a factor below 0 mirrors
MaybeWrong wrong_scale(double factor, bool by_axis);
/// P of G68.2.
MaybeWrong wrong_plane_form(int number);
/// ,C and ,R.
MaybeWrong wrong_corner(double size);
/// A second one of them in a block.
WrongValue second_corner();

}  // namespace g31::fanuc
