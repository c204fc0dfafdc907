#pragma once

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

// Cutter compensation stands between the programmed path in machine coordinates and the machine.
// Every motion and pause of a program goes through here.
//
// Programs run one block ahead of the machine in it.  #5001.. show the programmed end; #5021.. and
// #5041.. the position as if nothing more were to be read, without breaking the read-ahead.  Fences
// (BlockEffect::Finishes), #3000 and #3006 do break it: the block that waits then ends beside its
// end.  Any other alarm ends the program with that block not done.

// What ,C and ,R make of a corner stands in front of it (corners.cc): the block with the word waits
// for the next one.

/// The plane in force, as paths have it.
path::OffsetPlane offset_plane(const Control& control);

/// Moves along a block, machine coordinates, and tells the observer.
MaybeFailure travel(Control& control, const path::PathBlock& block);

/// Lets time pass and tells the observer.
MaybeFailure pause(Control& control, double seconds);

/// What the block's G40 G41 G42, D and plane say; before its motion.  Alarms for what cannot stand
/// in compensation (MB-273, MB-297).
MaybeFailure read_compensation(Control& control, const NcBlock& block);

/// What the block's ,C and ,R say, and whether it may stand behind one that has them; before its
/// motion.
MaybeFailure read_corner(Control& control, const NcBlock& block);
/// Alarm where a corner waits that no block comes to.
MaybeFailure refuse_waiting_corner(const Control& control);
/// Alarm where this block cannot make the corner that waits.
MaybeFailure refuse_corner_before(const Control& control, const path::PathBlock& block);
Failure from_corner_fault(const path::CornerFault& fault);

/// Behind the block: one without motion counts as such.
MaybeFailure end_compensated_block(Control& control);

/// Executes the block that waits, as if nothing came behind it.
MaybeFailure end_read_ahead(Control& control);

}  // namespace g31::fanuc
