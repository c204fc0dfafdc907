#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "machine/port/work_watch.h"

namespace g31::metrology {

/// The width of what holds a form, about different references; mm.
struct StraightnessZones {
  double end_points = 0.0;     ///< range about the line through the first and the last point
  double least_squares = 0.0;  ///< range about the line of least squares
  double minimum_zone = 0.0;   ///< the smallest range about any line
};

/// Straightness of deviations at places along a line, both mm, places rising; two points at least.
/// Deviations are taken across the line as they are: slopes are small.
/// @param watch  here and below: looked at for each point in each step of the work, which it may
/// end
StraightnessZones straightness_of(std::span<const double> places,
                                  std::span<const double> deviations,
                                  machine::WorkWatch* watch = nullptr);

struct FormZones {
  double least_squares = 0.0;
  double minimum_zone = 0.0;
};

/// What is flat, and where not.
struct FlatnessEvaluation {
  FormZones zones;
  /// Of each point from the middle of the minimum zone, along its normal: positive towards +z, of
  /// an upright face (within 0.01 rad) towards +x, or +y where it looks along y.
  Eigen::VectorXd deviations;
};

/// Flatness of points in rows, mm, however the face lies: range of the distances from the plane of
/// least squares, along its normal, and the smallest range about any plane.
///
/// Both by repeated linear fits, each along the normal of the one before.  Accuracy: that of
/// `minimax_fit`.  Where the zone is more than a hundredth of the width of the face it is the
/// smallest of those that 65 directions lead to.  nullopt: the points lie on a line.
std::optional<FlatnessEvaluation> flatness_of(const Eigen::MatrixX3d& points,
                                              machine::WorkWatch* watch = nullptr);

/// What is a cylinder, and where not.
struct CylindricityEvaluation {
  FormZones zones;
  Eigen::VectorXd deviations;  ///< of each point from the cylinder of least squares
};

/// Cylindricity of points in rows, mm, about an axis near z: range of the distances from the axis
/// of the cylinder of least squares, and the smallest range about any axis.
///
/// Both by repeated linear fits in the displacement and tilt of the axis, from the points' own
/// middle; distances are exact.  Accuracy: 1e-9 mm for an axis within 0.01 rad and a hundredth of
/// the radius.  Where the zone is more than a hundredth of the radius it is the smallest of those
/// that 17 axes lead to.  nullopt: the points do not determine an axis.
std::optional<CylindricityEvaluation> cylindricity_of(const Eigen::MatrixX3d& points,
                                                      machine::WorkWatch* watch = nullptr);

}  // namespace g31::metrology
