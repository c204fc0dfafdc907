#include "probe/metrology/form_zones.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "machine/base/contract.h"
#include "machine/units/point.h"
#include "probe/metrology/minimax_fit.h"

namespace g31::metrology {
namespace {

double range_of(const Eigen::VectorXd& values) {
  return values.maxCoeff() - values.minCoeff();
}

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

/// A line near z, and the frame in which the next fit looks at it.
struct Axis {
  Point at;
  Point along;
};

/// The points seen along an axis.
struct SeenAlong {
  Eigen::MatrixXd columns;    // change of the distances by size, displacement and tilt
  Eigen::VectorXd distances;  // from the axis
  Point across_x;
  Point across_y;
  double length = 1.0;  // half of what the points span along the axis
};

SeenAlong seen_along(const Axis& axis, const Eigen::MatrixX3d& points, machine::WorkWatch* watch) {
  SeenAlong seen;
  seen.across_x = Point::UnitX() - axis.along * axis.along.x();
  seen.across_x.normalize();
  seen.across_y = axis.along.cross(seen.across_x);
  const Eigen::VectorXd along = (points.rowwise() - axis.at.transpose()) * axis.along;
  seen.length = std::max(along.cwiseAbs().maxCoeff(), 1e-300);
  seen.columns.resize(points.rows(), 5);
  seen.distances.resize(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (watch != nullptr) {
      watch->look();
    }
    const Point q = points.row(i).transpose() - axis.at;
    const Eigen::Vector2d off(q.dot(seen.across_x), q.dot(seen.across_y));
    const double r = off.norm();
    const Eigen::Vector2d n = r > 0.0 ? Eigen::Vector2d(off / r) : Eigen::Vector2d::UnitX();
    const double share = along[i] / seen.length;
    seen.distances[i] = r;
    seen.columns.row(i) << 1.0, n.x(), n.y(), share * n.x(), share * n.y();
  }
  return seen;
}

/// The axis that a solution of the fit means.
Axis moved(const Axis& axis, const SeenAlong& seen, const Eigen::VectorXd& by) {
  const Point at = axis.at + by[1] * seen.across_x + by[2] * seen.across_y;
  const Point along = axis.along + (by[3] * seen.across_x + by[4] * seen.across_y) / seen.length;
  return {at, along.normalized()};
}

/// How far the points are from the axis that repeated fits come to.
template <typename Fit>
std::optional<Eigen::VectorXd> fitted_distances(const Eigen::MatrixX3d& points,
                                                machine::WorkWatch* watch, Fit fit) {
  constexpr int kRounds = 8;
  Axis axis{points.colwise().mean(), Point::UnitZ()};
  for (int round = 0; round < kRounds; ++round) {
    const SeenAlong seen = seen_along(axis, points, watch);
    const std::optional<Eigen::VectorXd> by = fit(seen);
    if (!by || !by->allFinite()) {
      return std::nullopt;
    }
    axis = moved(axis, seen, *by);
  }
  return seen_along(axis, points, watch).distances;
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

std::optional<FlatnessEvaluation> flatness_of(const Eigen::MatrixX3d& points,
                                              machine::WorkWatch* watch) {
  if (points.rows() < 3) {
    return std::nullopt;
  }
  Eigen::MatrixXd columns(points.rows(), 3);
  columns << Eigen::VectorXd::Ones(points.rows()), normalised(points.col(0)),
      normalised(points.col(1));
  const Eigen::VectorXd z = points.col(2);
  const auto smallest = minimax_fit(columns, z, watch);
  if (!smallest) {
    return std::nullopt;
  }
  return FlatnessEvaluation{zones_about(columns, z, *smallest), z - columns * smallest->parameters};
}

std::optional<CylindricityEvaluation> cylindricity_of(const Eigen::MatrixX3d& points,
                                                      machine::WorkWatch* watch) {
  if (points.rows() < 5) {
    return std::nullopt;
  }
  const auto least_squares = [](const SeenAlong& seen) -> std::optional<Eigen::VectorXd> {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(seen.columns);
    solver.setThreshold(1e-9);
    return solver.rank() == 5 ? std::optional<Eigen::VectorXd>(solver.solve(seen.distances))
                              : std::nullopt;
  };
  const auto minimax = [watch](const SeenAlong& seen) -> std::optional<Eigen::VectorXd> {
    const auto fit = minimax_fit(seen.columns, seen.distances, watch);
    return fit ? std::optional(fit->parameters) : std::nullopt;
  };
  const auto least = fitted_distances(points, watch, least_squares);
  const auto smallest = least ? fitted_distances(points, watch, minimax) : std::nullopt;
  if (!smallest) {
    return std::nullopt;
  }
  const double zone = range_of(*least);
  return CylindricityEvaluation{{zone, std::min(range_of(*smallest), zone)},
                                least->array() - least->mean()};
}

}  // namespace g31::metrology
