#pragma once

#include <functional>

#include "machine/units/point.h"
#include "probe/contact/sweep_mesh.h"

namespace g31::probe {

/// A way of the ball centre as the mesh sees it: arcs, helices, and any motion of several axes,
/// rotary ones too if the mesh turns with them.
struct Curve {
  std::function<Point(double)> at;  ///< mm, for t from 0 to 1; twice differentiable
  /// mm: the second derivative of `at` by t is nowhere longer.  By this the curve is never farther
  /// from its chord from t to t + h than bend h^2 / 8.
  double bend = 0.0;
};

/// Where a ball on a curved way meets a mesh.
struct CurveHit {
  double t = 0.0;  ///< the primary result
  SweepHit hit;    ///< its s counts along the last chord that was swept
};

/// How far a curved way is followed at worst beside itself, mm.
inline constexpr double kCurveErrorMm = 1e-8;

/// The first contact on the curve, as MeshSweeper::sweep has it for a straight way.
///
/// Certified: chords are passed over only if a ball as much larger as the curve bulges from the
/// chord is free on it; else they are halved, until the bulge is at most kCurveErrorMm and the
/// chord is swept instead.  So a ball that goes in by more than kCurveErrorMm is never let through,
/// and the contact is as deep as that at most; t is as good as that over speed and cos_incidence.
CurveHit sweep_curve(const MeshSweeper& sweeper, const Curve& curve);

/// The same for a move that may begin in contact, as MeshSweeper::first_contact_leaving.
CurveHit first_contact_leaving_on_curve(const MeshSweeper& sweeper, const Curve& curve);

}  // namespace g31::probe
