#pragma once

#include "machine/units/point.h"
#include "probe/contact/contact_mesh.h"
#include "probe/contact/sweep_mesh.h"

namespace g31::probe {

/// Facets that meet at less than this stand for one smooth surface, degrees.
inline constexpr double kCreaseDeg = 20.0;
inline constexpr double kCreaseCosine = 0.93969262078590843;  // of kCreaseDeg

/// The unit normal, towards the ball, of the smooth surface that the facets at a contact stand for.
///
/// At a corner it is the mean of the facets that meet there smoothly, weighted by their angles;
/// over a facet it goes on evenly from corner to corner.  It is taken where it leads to the ball
/// centre. At an edge that no facets round, and where the corners say nothing, it is the contact's
/// own one.
///
/// Accuracy: kSmoothNormalError for walls of evenly divided cylinders, bores and bosses, wherever
/// on a facet the ball touches; elsewhere of the second order in the angle between facets.
Point smooth_normal(const ContactMesh& mesh, const SweepHit& hit);

/// Radians; tests/probe/smooth_normal_test.cc holds it.
inline constexpr double kSmoothNormalError = 1e-9;

}  // namespace g31::probe
