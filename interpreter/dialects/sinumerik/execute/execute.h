#pragma once

#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/word_limits.h"
#include "interpreter/dialects/sinumerik/state/channel.h"

namespace g31::sinumerik {

/// One NC block with its words evaluated.
struct Block {
  /// @param block_words, packed_codes  outlive it
  Block(const BlockWords& block_words, std::span<const std::uint16_t> packed_codes,
        source::Location place);

  const BlockWords& words;
  std::span<const std::uint16_t> codes;  ///< packed
  source::Location where;
  std::uint64_t groups = 0;  ///< a bit for each group that a code is of

  /// The row of a group that stands in this block; nullptr: none.
  [[nodiscard]] const GCode* code_of(Group group) const {
    static_assert(kGroupCount <= 64);
    return (groups >> static_cast<unsigned>(group) & 1U) != 0 ? find_code(group) : nullptr;
  }

 private:
  [[nodiscard]] const GCode* find_code(Group group) const;
};

/// Whether the block moves along the path; in a block of TRANS, say, axis words do not.
bool commands_motion(const Block& block);

/// Does everything that a block commands.
MaybeFailure execute_block(Channel& channel, const Block& block);

/// Gives the machine what waits in the compensation, as if nothing came behind it: STOPRE, reading
/// where the axes stand, the end of the program.
MaybeFailure finish_motion(Channel& channel);

/// An alarm: what waits is never travelled.
void drop_motion(Channel& channel);

// The parts, one a file.

/// F, S, M3 to M5, M19, SPOS and the like.
MaybeFailure take_technology(Channel& channel, const Block& block);
/// The machine hears how fast the master spindle turns, if it does.
void tell_spindle(Channel& channel);
/// SETMS.  Under G96 the new master spindle cuts at its speed, and the old one keeps the speed that
/// it has (840D sl function manual V1, 2.1.3).
void change_master(Channel& channel, int number);
/// T, D and M6.
MaybeFailure select_tool(Channel& channel, const Block& block);
/// FZ and SVC, by the tool in force.
MaybeFailure take_tool_technology(Channel& channel, const Block& block);
/// Tells of a D without a tool: when the axes move, and when its tool comes with another D.
void tell_idle_edge(Channel& channel);
/// MOVT: along the tool as it stands.
MaybeFailure take_tool_way(const Channel& channel, const Block& block, AxisPositions& q_W_end);
/// TOFRAME, TOROT and their forms, TOROTOF.
void turn_to_tool(Channel& channel, const GCode& code);
/// TCARR, TCOABS and TCOFR, PAROT.
MaybeFailure take_tool_carrier(Channel& channel, const Block& block);
/// $P_PARTFRAME is that of the table as the carrier in force has turned it.
void follow_table(Channel& channel);
/// What TRAORI may say besides its number.
struct BasicPosition {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of the tool; 0: square to the plane
  std::array<double, 2> offsets_deg = {};               ///< added to the axes' basic positions
};
/// TRAORI by the data of a tool carrier, and TRAFOOF.
MaybeFailure switch_transformation_on(Channel& channel, int number, const BasicPosition& basic);
/// STAT and TU.
MaybeFailure take_joint_position(Channel& channel, const Block& block);
MaybeFailure switch_transformation_off(Channel& channel);
/// Alarm 4343: the machine data of the transformation in force are others than when it was switched
/// on.  Source: Diagnostics Manual 11/2006, page 2-59.
MaybeFailure transformation_is_unchanged(const Channel& channel);
/// ORIRESET: at rapid to positions of the transformation's axes; nullopt: the basic ones.
MaybeFailure turn_back(Channel& channel, const std::array<std::optional<double>, 2>& deg,
                       source::Location where);
/// Whether the block says a direction of the tool: A2 B2 C2, A3 B3 C3.
bool has_direction(const Block& block);
/// Takes it into the rotary axes.
MaybeFailure take_direction(const Channel& channel, const Block& block, AxisPositions& q_W_end);
/// TRANS, ROT, SCALE, MIRROR and their additive forms.
MaybeFailure program_frame(Channel& channel, const Block& block, const GCode& code);
/// G58 and G59
MaybeFailure shift_by_axis(Channel& channel, const Block& block, const GCode& code);
/// ROTS and AROTS
MaybeFailure turn_by_solid_angles(Channel& channel, const Block& block, const GCode& code);
/// G110, G111 and G112
MaybeFailure set_pole(Channel& channel, const Block& block, const GCode& code);
/// G25 and G26
MaybeFailure limit(Channel& channel, const Block& block, const GCode& code);
/// G74 and G75
MaybeFailure approach_reference(Channel& channel, const Block& block);
MaybeFailure approach_fixed_point(Channel& channel, const Block& block);
/// Straight moves: rapid, at feed, threads.
MaybeFailure move_straight(Channel& channel, const Block& block);
/// G2, G3, CIP and CT.
MaybeFailure move_along_circle(Channel& channel, const Block& block);
/// Whether the path of the block measures, or a synchronised action may end its move.
bool listens_to_probe(const Channel& channel, const Block& block);
/// MEAS, MEAW, MEASA, MEAWA and WHEN ... DO DELDTG
MaybeFailure measure(Channel& channel, const Block& block);
/// The same of a positioning axis.  @param feed_per_min  0: rapid
MaybeFailure measure_axis(Channel& channel, const Block& block, const AxisPositions& q_W_end,
                          double feed_per_min);
/// From here on motions are read and not travelled.
MaybeFailure begin_contour(Channel& channel);
/// Motions are travelled again, from where the axes stand.
/// @returns the ways behind the first motion, which leads to the contour; alarm 10933: none
Result<std::vector<path::PlaneWay>, Failure> end_contour(Channel& channel);
/// Ways beside those of a contour.
/// @param left_mm  how far, to the left of the direction of travel
Result<std::vector<path::PlaneWay>, Failure> contour_beside(std::vector<path::PlaneWay> ways,
                                                            double left_mm);
/// G4
MaybeFailure dwell(Channel& channel, const Block& block);

/// OVR, FA[axis], ACC[axis] and the like.
void take_axis_settings(Channel& channel, const Block& block);
/// POS[axis] and POSA[axis]: each axis for itself, before the path of the block.
MaybeFailure move_positioning_axes(Channel& channel, const Block& block);

/// How the words of U, V and W go with the others of their block.
enum class FurtherMotion {
  Alone,      ///< they take F or rapid
  WithPath,   ///< the path takes F, they arrive with it
  ToHome,     ///< G74
  IntoFrame,  ///< TRANS and the like take them
  Refused     ///< measuring, limits: words of the path are an alarm
};
/// Whether U, V or W has a word.
bool moves_further_axes(const Block& block);
/// What U, V and W need at rapid for their ways in a block with a path, s.
double further_rapid_seconds(const Channel& channel, const Block& block);
/// U, V and W: POS[W], then W.
MaybeFailure move_further_axes(Channel& channel, const Block& block, FurtherMotion motion);

/// Whether a word counts from where the program stands: IC, or G91 where no frame is suppressed.
bool counts_from_present(const Channel& channel, Modification modification);
/// Where the word of an axis sends it, work coordinates.  @param now  where it stands
Result<double, Failure> programmed_place(const Channel& channel, int axis,
                                         const BlockWords::Word& word, double now);
/// The end that the axis words or AP and RP say, work coordinates; axes without a word stay where
/// they are.
Result<AxisPositions, Failure> programmed_end(Channel& channel, const Block& block);
/// Whether AP or RP stands in the block.
bool is_polar(const Block& block);
/// Takes ANG into the axis of the plane that has no word.  @param q_W_from  where the line begins
MaybeFailure take_angle(const Channel& channel, const Block& block, AxisPositions& q_W_end,
                        const AxisPositions& q_W_from);
/// How many axes of the plane have a word.
int plane_words(const Channel& channel, const Block& block);
/// A line of which only ANG is known waits for the next one.
MaybeFailure hold_line(Channel& channel, const Block& block);
/// Moves along the line that waits, up to where the line of this block begins.
/// @param q_W_block_end  where the line of this block ends, work coordinates
MaybeFailure release_line(Channel& channel, const Block& block, const AxisPositions& q_W_block_end);
/// The alarm of a line that still waits.
MaybeFailure line_without_end(Channel& channel);
/// Takes AP and RP into the axes of the plane.
MaybeFailure take_polar(Channel& channel, const Block& block, AxisPositions& q_W_end);

/// Whether G9 or G60 stops the axes at the end of the block, and how near.
machine::BlockEnd block_end(const Channel& channel);
/// The control plans ahead in any case; FFWON drives the axes by the speed of their command, too.
machine::ContourControl contour_control(const Channel& channel);
/// Compensation tables that are in force now and were not before go to the machine.
MaybeFailure compensate_axes(Channel& channel);
/// Machine data that say of the axes what they did not say before go to the machine.
void take_axis_data(Channel& channel);
/// The same, and whether SOFT limits the jerk.
bool limits_jerk(Channel& channel);
/// All three for a motion, and what the compressor makes of it.
void take_modes(Channel& channel, path::PathBlock& path);

}  // namespace g31::sinumerik
