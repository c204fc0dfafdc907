#pragma once

#include <vector>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/path/path_block.h"

namespace g31::sinumerik {

// Every motion and pause of a program goes through here: roundings and chamfers, then the
// compensation stand between the programmed path and the machine.  Programs run one block ahead of
// the machine in each.  Places are in the coordinates of paths (Channel::to_path).

/// Moves along a path and tells the observer.
MaybeFailure travel(Channel& channel, const path::PathBlock& path);

/// The same, and the program stands at its end from then on.
/// @param q_W_end  where the path ends for the program
MaybeFailure travel_to(Channel& channel, const path::PathBlock& path, const AxisPositions& q_W_end);

/// Whether the tool turns in several pieces of a great circle, which no arc of the machine does.
/// @param q_M_end  the rotary axes at its end
bool turns_along_circle(const Channel& channel, const AxisPositions& q_M_end);

/// Where the pieces of a way end on which the tool turns along a great circle, in work coordinates;
/// one piece with ORIAXES.
/// @param q_M_end  the rotary axes at its end
/// @param least    so many pieces, where it turns so
Result<std::vector<AxisPositions>, Failure> pieces_of_turn(Channel& channel,
                                                           const AxisPositions& q_M_end,
                                                           const AxisPositions& q_W_end,
                                                           int least = 1);

/// `travel_to` with a programmed direction of the tool, which goes along a great circle with
/// ORIVECT.
MaybeFailure travel_with_direction(Channel& channel, const path::PathBlock& path,
                                   const AxisPositions& q_W_end);

/// Whether PTP lets the axes go straight: with TRAORI, without G41 and G42.
bool goes_by_axes(const Channel& channel);
/// PTP: the axes go straight to where the block ends.
/// @param path  as it would be without
MaybeFailure travel_by_axes(Channel& channel, const path::PathBlock& path,
                            const AxisPositions& q_W_end);

// Source of coupled axes: SINUMERIK job planning, coupled motion: the following axis adds the way
// of the leading one, by the factor, to its own.

/// Where axes that follow others end, too.
AxisPositions coupled_end(const Channel& channel, const AxisPositions& q_M_from,
                          const AxisPositions& q_M_end);
/// Whether one of U, V and W that follow would leave its travel.
MaybeFailure cannot_follow(const Channel& channel, const AxisPositions& q_M_way);
/// U, V and W go along.
void move_followers(Channel& channel, const AxisPositions& q_M_way);

/// Lets time pass and tells the observer.
MaybeFailure pause(Channel& channel, const path::Pause& wait);

/// What the block's RND, CHF, CHR and RNDM ask for; before its motion.
MaybeFailure read_corner(Channel& channel, const Block& block);
/// Before a block that is no line at feed, or has M codes: a line that waits for the corner that
/// G641 or G642 would round gets none.
MaybeFailure finish_passing_by(Channel& channel, const Block& block);
/// Whether G41 or G42 shifts the path: with an edge.
bool is_compensation_on(const Channel& channel);
/// What the block's G40 G41 G42, D and plane say; before its motion.
MaybeFailure read_compensation(Channel& channel, const Block& block);
/// Behind the block: one without motion counts as such.
MaybeFailure end_compensated_block(Channel& channel);
/// Does what waits and gives the axes free: the next compensated move starts from there.  A block
/// that waits for its corner gets none.
MaybeFailure leave_compensation(Channel& channel);

/// How the plane lies in the coordinates of paths, as the frames in force have it.
struct PlaneOfPath {
  bool is_parallel = false;  ///< to a plane of their axes, and evenly scaled
  bool is_even = false;      ///< both of its axes have the same scale
  bool is_mirrored = false;  ///< turns the other way round there
  double scale = 1.0;        ///< mm of a path to one of the program
};
PlaneOfPath plane_of_path(const Channel& channel);

/// What of a block no contour can have that is only read: alarm 10930.
MaybeFailure fits_into_contour(const Channel& channel, const Block& block);
/// A motion of a contour that is only read: its way in the plane is kept.
MaybeFailure note_way(Channel& channel, const path::PathBlock& path);

/// Gives the compensation the block that waits for its corner; it gets none.
MaybeFailure finish_corners(Channel& channel);

/// Whether coordinates, mm and degrees, are such as words can give.
bool is_place(const Eigen::Ref<const Eigen::VectorXd>& place);

/// Alarm 10730 for an end outside of G25 and G26, 12560 for one that no words could give: frames
/// may make such places.
MaybeFailure out_of_reach(const Channel& channel, const AxisPositions& q_P_end);

/// What a fault of the machine means here.
Failure from_fault(const machine::MachineFault& fault);

}  // namespace g31::sinumerik
