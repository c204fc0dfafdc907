#pragma once

#include <optional>

#include "interpreter/dialects/fanuc/code/word_limits.h"
#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/state/failure.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/source/location.h"

namespace g31::fanuc {

struct Codes;

inline constexpr int kToolAxis = 2;    ///< Z: the spindle of a vertical machining centre
inline constexpr int kToolChange = 6;  ///< M6

/// One NC block at work: its words and the G codes found in them.
struct NcBlock {
  const BlockWords& words;
  source::Location where;
  const GCode* code = nullptr;  ///< the one that takes the block's words for itself, if any
  bool has_axis_word = false;
  bool changes_length = false;  ///< the tool's axis moves for that, also where it is not named
};

/// Executes an NC block that is no call: modal codes, offsets, then its motion or one-shot code.
MaybeFailure execute_block(Control& control, const BlockWords& words, source::Location where);

// One function per GAction that does more than set its group.

MaybeFailure execute_motion(Control& control, const NcBlock& block);        // motion.cc
MaybeFailure execute_machine_move(Control& control, const NcBlock& block);  // motion.cc
MaybeFailure execute_arc(Control& control, const NcBlock& block);           // arc.cc
MaybeFailure execute_thread(Control& control, const NcBlock& block);        // thread.cc
MaybeFailure execute_skip(Control& control, const NcBlock& block);          // skip.cc
MaybeFailure execute_tool_measurement(Control& control,
                                      const NcBlock& block);              // measure_tool.cc
MaybeFailure execute_tool_touch(Control& control, const NcBlock& block);  // measure_work.cc
MaybeFailure execute_diameter_measurement(Control& control,
                                          const NcBlock& block);                // measure_work.cc
MaybeFailure execute_work_measurement(Control& control, const NcBlock& block);  // measure_work.cc
MaybeFailure execute_dwell(Control& control, const NcBlock& block);             // dwell.cc
MaybeFailure execute_reference(Control& control, const NcBlock& block);         // reference.cc
MaybeFailure execute_from_reference(Control& control, const NcBlock& block);    // reference.cc
MaybeFailure execute_check_reference(Control& control, const NcBlock& block);   // reference.cc
MaybeFailure execute_set_data(Control& control, const NcBlock& block);          // set_data.cc
MaybeFailure execute_local_shift(Control& control, const NcBlock& block);       // offsets.cc
MaybeFailure execute_set_position(Control& control, const NcBlock& block);      // offsets.cc
MaybeFailure execute_preset(Control& control, const NcBlock& block);            // offsets.cc
MaybeFailure select_work_offset(Control& control, const BlockWords& words,
                                GNumber code);  // offsets.cc
MaybeFailure select_tool_length(Control& control, NcBlock& block,
                                const GCode* commanded);                     // offsets.cc
MaybeFailure execute_mirror(Control& control, const NcBlock& block);         // transforms.cc
MaybeFailure execute_mirror_off(Control& control, const NcBlock& block);     // transforms.cc
MaybeFailure execute_scaling(Control& control, const NcBlock& block);        // transforms.cc
MaybeFailure execute_rotation(Control& control, const NcBlock& block);       // transforms.cc
MaybeFailure execute_tilted_plane(Control& control, const NcBlock& block);   // tilted_plane.cc
MaybeFailure execute_tool_to_plane(Control& control, const NcBlock& block);  // tool_axis.cc
MaybeFailure execute_table_offset(Control& control, const NcBlock& block);   // offsets.cc
MaybeFailure execute_setting_error(Control& control, const NcBlock& block);  // offsets.cc
MaybeFailure execute_canned_cycle(Control& control, const NcBlock& block);   // canned_cycle.cc
MaybeFailure execute_hole_pattern(Control& control, const NcBlock& block);   // hole_pattern.cc
MaybeFailure execute_tool_replacement(Control& control,
                                      const NcBlock& block);  // tool_replacement.cc

/// M75 of a Haas, at the end of its block (measure_work.cc).
void keep_marked_point(Control& control, const BlockWords& words);

/// What M, S and T have the machine do: the spindle, the tool, the codes for its own logic
/// (machine_codes.cc).
void command_machine(Control& control, const BlockWords& words);
/// The tool that T called comes, with the offset of its own number (machine_codes.cc).
void change_tool(Control& control);

/// A block between G10 L50 or L3 and G11 (data_input.cc).
MaybeFailure execute_data_block(Control& control, const BlockWords& words);

void start_polar(Control& control);      // G16; transforms.cc
void cancel_scaling(Control& control);   // G50; transforms.cc
void cancel_rotation(Control& control);  // G69; transforms.cc
/// The axis of the turned plane that a motion behind G68 does not name, as a word of its block;
/// nullopt: it stays where it is (transforms.cc).  @pre G68 is in force
std::optional<EvaluatedWord> word_before_rotation(Control& control, const BlockWords& words,
                                                  const Codes& codes);
/// G68 with I J K (tilted_plane.cc).
MaybeFailure rotate_in_space(Control& control, const NcBlock& block);
/// Points and vectors of G68.2 P2 and P3 stand in blocks that follow each other (tilted_plane.cc).
MaybeFailure refuse_unfinished_plane(const Control& control, const Codes& codes);
/// G43.4 and G43.5 begin, or another code of their group ends them (tool_axis.cc).
MaybeFailure select_tip_control(Control& control);
/// Alarm 5422: under tool centre point control an axis would be led faster than parameter 1422 has
/// it.
MaybeFailure is_led_too_fast(const Control& control, const path::PathBlock& block);
/// Whether the block turns the tool by I J K under G43.5, and to where (tool_axis.cc).
bool turns_by_direction(const Control& control, const BlockWords& words);
MaybeFailure take_tool_direction(const Control& control, const NcBlock& block,
                                 AxisPositions& q_L_end);

void start_canned_cycle(Control& control);  // the first after G80; canned_cycle.cc

/// Radius of the tool offset D in force, geometry and wear, mm; 0 for D0 (offsets.cc).
Result<double, Failure> cutter_radius(const Control& control);

// What several of them share.

/// The value of an axis word: mm, or deg of a rotary axis.
inline double axis_value(const Control& control, const EvaluatedWord& word, std::size_t axis) {
  return is_linear_axis(static_cast<int>(axis)) ? control.scale.length_mm(word)
                                                : control.scale.angle_deg(word);
}

/// The axis words of the block as they stand, absolute or incremental, on the present point (L).
AxisPositions cartesian_end(const Control& control, const NcBlock& block);
/// The same of words that are coordinates under G91, too: the centres of G51 and G68.
AxisPositions named_point(const Control& control, const NcBlock& block);

/// The end point of a motion (L): axis words, in polar coordinates where they are in force.  To be
/// asked once a motion, because radius and angle go on from block to block.
AxisPositions programmed_end(Control& control, const NcBlock& block);

/// Moves to a place in path coordinates at rapid, through cutter compensation, and tells the
/// observer.
MaybeFailure rapid_to(Control& control, const AxisPositions& q_B_end, machine::RapidPath way);
/// The same by G00 or G60, as the block is positioned (single_direction.cc).
MaybeFailure position_to(Control& control, const AxisPositions& q_B_end);
/// The same at the feed in force; `g` is how the document names the move.
MaybeFailure feed_to(Control& control, const AxisPositions& q_B_end, int g);
/// The same at a feed in mm/min, which override and dry run change.
MaybeFailure line_to(Control& control, const AxisPositions& q_B_end, int g, double feed_mm_min);
/// The axes to a machine position, whatever leads them, as G00 or G01 is in force.
MaybeFailure move_axes_to(Control& control, const AxisPositions& q_M_end, machine::RapidPath way);

/// Moves until the skip signal and tells the observer; #5061.. stay as they are.
/// @returns the latched position (M), or nullopt when no signal came: then the axes stand at the
///          end and the caller says which programmed point that is
Result<std::optional<AxisPositions>, Failure> move_and_latch(Control& control, const NcBlock& block,
                                                             const machine::SkipMove& move);

/// A fault of the machine as the end of the program.
[[gnu::cold]] Failure from_fault(const machine::MachineFault& fault);
/// Of a move that passed on; the coordinates are where the machine stopped.
[[gnu::cold]] Failure from_late_fault(Control& control, const machine::MachineFault& fault);

/// A failure of the whole block.
[[gnu::cold]] Failure block_failure(AlarmId id, std::string detail = {});

/// A failure at a place of the block.
[[gnu::cold]] Failure at_place(AlarmId id, syntax::ShortSpan where, std::string detail);

/// A failure at a word.
[[gnu::cold]] Failure at_word(AlarmId id, const EvaluatedWord& word, std::string detail);
[[gnu::cold]] Failure at_word(WrongValue wrong, const EvaluatedWord& word);
/// The same of what may be right.
MaybeFailure at_word(MaybeWrong wrong, const EvaluatedWord& word);

/// A word whose value is an integer (M S T D H N O L P): a literal must have no point, a computed
/// one is rounded (MB-025, MB-026).
Result<int, Failure> integer_of(const EvaluatedWord& word, const Profile& profile);
/// The same, where `limit` lets it stand: a function of word_limits.h.
template <typename Limit>
Result<int, Failure> integer_within(const EvaluatedWord& word, const Profile& profile,
                                    Limit limit) {
  const auto number = integer_of(word, profile);
  auto wrong = number ? limit(number.value()) : std::nullopt;
  return wrong ? at_word(*std::move(wrong), word) : number;
}
/// P of G04 and of hole cycles, in s: milliseconds, or seconds with a point on some controls
/// (MB-285).
Result<double, Failure> dwell_seconds(const Control& control, const EvaluatedWord& p);

}  // namespace g31::fanuc
