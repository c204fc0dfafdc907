#pragma once

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/feed.h"

// S: turns of the spindle, and constant surface speed.  Sources: FANUC Series 16/18 operator's
// manual for lathes B-62764EN and its like for machining centres, constant surface speed control
// (G96, G97); parameters 3770 to 3772; M700V programming manual, constant surface speed control and
// spindle clamp speed setting, which has Q beside S of G92.

namespace g31::fanuc {

/// rev/min of the spindle, the axes standing where they are; under G97 as S says, under G96 by the
/// place of its axis, within the limits.  0: S has not been given; infinity: at the centre of G96
/// without a limit.
double spindle_speed(const Control& control);

/// Minutes of a turn of the spindle under G96, the mean over a way; 0: S has not been given.
/// Straight ways in closed form, arcs in chords of a quarter of a degree.
double mean_turn(const Control& control, const FeedWay& way);

/// S of a block: a speed, a surface speed under G96, or the limit of G92.
void take_speed(Control& control, int number, const Codes& codes);

/// What stands beside S of G92 on some controls: the lowest speed of G96.
MaybeFailure take_lowest_speed(Control& control, const BlockWords& words);

/// P and the parameters in a block of G96, or alarm 190.
MaybeFailure take_surface_axis(Control& control, const BlockWords& words);

}  // namespace g31::fanuc
