#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "probe/metrology/form_zones.h"

namespace g31::metrology {

inline double range_of(const Eigen::VectorXd& values) {
  return values.maxCoeff() - values.minCoeff();
}

/// Of the distances that a fit of least squares leaves, and of those that a minimax fit does.
inline FormZones zones_of(const Eigen::VectorXd& least, const Eigen::VectorXd& smallest) {
  return {range_of(least), std::min(range_of(smallest), range_of(least))};
}

}  // namespace g31::metrology
