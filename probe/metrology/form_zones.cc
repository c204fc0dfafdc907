#include "probe/metrology/form_zones.h"

#include <algorithm>

#include <Eigen/QR>

#include "machine/base/contract.h"
#include "probe/metrology/form_fits.h"
#include "probe/metrology/minimax_fit.h"

namespace g31::metrology {
namespace {

/// To -1 .. 1.
Eigen::VectorXd normalised(const Eigen::VectorXd& values) {
  const double middle = 0.5 * (values.maxCoeff() + values.minCoeff());
  const double half = std::max(0.5 * range_of(values), 1e-300);
  return (values.array() - middle) / half;
}

FormZones zones_about(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values,
                      const MinimaxFit& smallest) {
  const Eigen::VectorXd line = columns.colPivHouseholderQr().solve(values);
  return {range_of(values - columns * line), 2.0 * smallest.half_width};
}

}  // namespace

StraightnessZones straightness_of(std::span<const double> places,
                                  std::span<const double> deviations, machine::WorkWatch* watch) {
  G31_EXPECTS(places.size() == deviations.size() && places.size() >= 2);
  const auto count = static_cast<Eigen::Index>(places.size());
  const Eigen::VectorXd x = normalised(Eigen::Map<const Eigen::VectorXd>(places.data(), count));
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(deviations.data(), count);
  const double slope = (y[count - 1] - y[0]) / (x[count - 1] - x[0]);
  Eigen::MatrixXd columns(count, 2);
  columns << Eigen::VectorXd::Ones(count), x;
  const auto smallest = minimax_fit(columns, y, watch);
  G31_EXPECTS(smallest.has_value());
  const FormZones zones = zones_about(columns, y, *smallest);
  return {range_of(y - slope * x), zones.least_squares, zones.minimum_zone};
}

}  // namespace g31::metrology
