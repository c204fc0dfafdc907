#pragma once

#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/state/failure.h"
#include "interpreter/dialects/fanuc/text/word_values.h"

namespace g31::fanuc {

/// What the G codes of a block are to do with its other words.
struct Codes {
  const GCode* one_shot = nullptr;  ///< of group 0
  const GCode* frame = nullptr;  ///< takes the axis words for mirror, scaling, rotation or limits
  const GCode* tool_length = nullptr;
  const GCode* unit = nullptr;
  const GCode* work_offset = nullptr;
  bool starts_surface_speed = false;  ///< G96
  bool starts_polar = false;
  bool starts_cycle = false;
  bool starts_plane = false;              ///< a tilted one
  const GCode* contour_switch = nullptr;  ///< by Q, G08 by P
};

/// F without a point, as the control counts it.
double counted_feed(const Control& control, const EvaluatedWord& word);
/// F as a number in the unit in force, per minute or per revolution.
inline double written_feed(const Control& control, const EvaluatedWord& word) {
  const bool counts = word.form == syntax::ValueForm::Integer && !control.scale.calculator_point;
  return counts ? counted_feed(control, word) : word.number;
}

/// Whether the block moves axes, or would if they were not there already: axis words that no code
/// takes for something else (MB-203).
bool commands_motion(const BlockWords& words, const Profile& profile);

/// Modal codes, feed, S T M and the like of a block: everything that the rest of it builds on.
Result<Codes, Failure> take_words(Control& control, const BlockWords& words);

/// nullptr: none.
inline const CannedCycle* cycle_in_force(const Control& control) {
  return find_canned_cycle(control.modal.group[Group::CannedCycle].whole);
}
inline bool in_canned_cycle(const Control& control) {
  return control.modal.group[Group::CannedCycle].whole != 80;
}

}  // namespace g31::fanuc
