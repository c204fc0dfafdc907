#pragma once

#include <optional>

#include "machine/units/point.h"
#include "probe/sensor/probe_setup.h"

namespace g31::probe {

/// How far the stylus must give way, along the surface normal, until the signal comes; nullopt: a
/// touch from there never gives one.
///
/// The ball slides on the surface without friction, so the force is along the normal.  With theta
/// the angle of the normal to the stylus, F0 the sideways force in the weakest direction and Fz the
/// force along the stylus, the stylus carrier tips (Even: cos(delta) = 1) at
///
///     F = 1 / (sin(theta) cos(delta) / F0 + cos(theta) / Fz)
///
/// A carrier on three seats tips over the edge between two of them, so delta is the angle between
/// the sideways force and the nearest of three weak directions, 120 degrees apart: at most 60
/// degrees, where twice the force is needed.  A pull out of the seats (a touch from below) holds
/// it down; it may never tip.  The stem bends sideways only, by F sin(theta) / stiffness, of which
/// sin(theta) lies along the normal:
///
///     deflection = pre_travel + F sin(theta)^2 / stiffness
///
/// A mono probe gives a signal within 45 degrees of its direction sideways, or from above.
///
/// @param n_S  unit surface normal, pointing to the ball, in the frame of the stylus: that of the
///             machine turned back by the spindle angle
std::optional<double> deflection_to_trigger(const SwitchSetup& setup, const Point& n_S);

}  // namespace g31::probe
