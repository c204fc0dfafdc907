#pragma once

#include <optional>

#include <Eigen/Core>

#include "machine/port/work_watch.h"

namespace g31::metrology {

/// A linear function that leaves the smallest largest residual.
struct MinimaxFit {
  Eigen::VectorXd parameters;  ///< one for each column
  double half_width = 0.0;     ///< the largest residual in size
};

/// Minimises max |values - columns * parameters|: a minimum zone is twice `half_width`.
///
/// The simplex method on the dual problem, whose corners are sets of points that touch the zone:
/// the optimum itself, not an approach to it.  Ties, as points of a grid make them, are settled by
/// Bland's rule.  Accuracy: rounding, 1e-12 of the largest value for columns of size about 1.
/// nullopt: the points do not determine the function.
/// @param watch  looked at for each point in each step; may end the work, by an exception
std::optional<MinimaxFit> minimax_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values,
                                      machine::WorkWatch* watch = nullptr);

}  // namespace g31::metrology
