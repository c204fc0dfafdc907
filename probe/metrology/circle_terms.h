#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "probe/metrology/circle_residual.h"

namespace g31::metrology {

/// The parameters of the model of a circle.
enum class CircleTerm {
  CentreX,
  CentreY,
  Size,   ///< of the radius; with a given radius, of the scale of the first axis
  Shape,  ///< half the difference of the scales; with a given radius, the second axis' scale
  Squareness,
  BacklashX,
  BacklashY,
  Mismatch,  ///< only where both directions were recorded
  SineX,     ///< of the cyclic error
  CosineX,
  SineY,
  CosineY,
  FirstLobe,  ///< from here on cosine and sine of each order
};

inline constexpr int kMostCircleTerms = 12 + 2 * (kLastLobe - kFirstLobe + 1);
using CircleRow = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostCircleTerms, 1>;

/// Which terms are fitted.
struct CircleTermChoice {
  bool has_radius = false;  ///< the commanded one is given
  bool has_mismatch = false;
  CyclicPitches pitches = {};
  bool has_lobes = false;
};

/// The terms of one fit as columns of its equations.  Lengths are in radii, a mismatch in ms, so
/// that all columns are alike.
class CircleColumns {
 public:
  explicit CircleColumns(const CircleTermChoice& choice);

  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(terms_.size()); }

  /// What a unit of each term moves the path outwards at a place.
  /// @param axes  where they stand  @param n  direction of the place on the circle
  void fill(CircleRow& row, const Eigen::Vector2d& axes, const Eigen::Vector2d& n,
            const CircleTurn& turn) const;

  /// The errors that a row of a solution stands for.
  [[nodiscard]] CircleErrors as_errors(const CircleRow& row, double radius) const;

  /// Where a term stands; count() where it is not fitted.
  [[nodiscard]] Eigen::Index column_of(CircleTerm term) const;

  /// A mismatch counts in ms beside lengths in radii.
  static constexpr double kSecondsPerUnit = 1e-3;

 private:
  CircleTermChoice choice_;
  std::vector<CircleTerm> terms_;
};

}  // namespace g31::metrology
