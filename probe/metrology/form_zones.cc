#include "probe/metrology/form_zones.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Of the distances that a fit of least squares leaves, and of those that a minimax fit does.
FormZones zones_of(const Eigen::VectorXd& least, const Eigen::VectorXd& smallest) {
  return {range_of(least), std::min(range_of(smallest), range_of(least))};
}

std::optional<Eigen::VectorXd> minimax_parameters(const Eigen::MatrixXd& columns,
                                                  const Eigen::VectorXd& values,
                                                  machine::WorkWatch* watch) {
  auto fit = minimax_fit(columns, values, watch);
  return fit ? std::optional(std::move(fit->parameters)) : std::nullopt;
}

/// A plane, by a point and its normal.
struct Plane {
  Point at;
  Point normal;
};

/// The points seen along the normal of a plane.
struct SeenAcross {
  Eigen::MatrixXd columns;  // change of the heights by displacement and tilt
  Eigen::VectorXd heights;  // above the plane
  Point across_x;
  Point across_y;
  double length = 1.0;  // the farthest from the point of the plane
};

/// A plane through the middle of points and the two that span it most; nullopt: they lie on a line.
std::optional<Plane> plane_among(const Eigen::MatrixX3d& points) {
  constexpr double kNarrowest = 1e-7;  // of their length
  const Point middle = points.colwise().mean();
  const auto farthest = [&](auto distance) {
    Eigen::Index found = 0;
    double most = -1.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double here = distance(Point(points.row(i).transpose() - middle));
      found = here > most ? i : found;
      most = std::max(most, here);
    }
    return Point(points.row(found).transpose() - middle);
  };
  const Point first = farthest([](const Point& off) { return off.norm(); });
  const Point along = first.normalized();
  const Point second = farthest([&](const Point& off) { return off.cross(along).norm(); });
  const Point normal = along.cross(second);
  if (!(normal.norm() > kNarrowest * first.norm())) {
    return std::nullopt;
  }
  return Plane{middle, normal.normalized()};
}

SeenAcross seen_across(const Plane& plane, const Eigen::MatrixX3d& points,
                       machine::WorkWatch* watch) {
  SeenAcross seen;
  seen.across_x = plane.normal.unitOrthogonal();
  seen.across_y = plane.normal.cross(seen.across_x);
  seen.columns.resize(points.rows(), 3);
  seen.heights.resize(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (watch != nullptr) {
      watch->look();
    }
    const Point off = points.row(i).transpose() - plane.at;
    seen.columns.row(i) << 1.0, off.dot(seen.across_x), off.dot(seen.across_y);
    seen.heights[i] = off.dot(plane.normal);
  }
  seen.length = seen.columns.rightCols<2>().cwiseAbs().maxCoeff();
  seen.columns.rightCols<2>() /= seen.length;
  return seen;
}

/// How high the points are above the plane that repeated fits come to: at rest, heights along its
/// normal are those along which the fit has looked.
template <typename Fit>
std::optional<Eigen::VectorXd> fitted_heights(const Eigen::MatrixX3d& points, Plane plane,
                                              machine::WorkWatch* watch, Fit fit) {
  constexpr int kRounds = 8;
  constexpr double kAtRest = 1e-15;  // rad
  for (int round = 0; round < kRounds; ++round) {
    const SeenAcross seen = seen_across(plane, points, watch);
    const std::optional<Eigen::VectorXd> by = fit(seen);
    if (!by || !by->allFinite()) {
      return std::nullopt;
    }
    const Eigen::Vector2d tilt = by->tail<2>() / seen.length;
    plane.at += (*by)[0] * plane.normal;
    plane.normal -= tilt[0] * seen.across_x + tilt[1] * seen.across_y;
    plane.normal.normalize();
    if (tilt.norm() < kAtRest) {
      break;
    }
  }
  return seen_across(plane, points, watch).heights;
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
  const std::optional<Plane> start = plane_among(points);
  if (!start) {
    return std::nullopt;
  }
  const auto least_squares = [](const SeenAcross& seen) {
    return std::optional<Eigen::VectorXd>(seen.columns.colPivHouseholderQr().solve(seen.heights));
  };
  const auto minimax = [watch](const SeenAcross& seen) {
    return minimax_parameters(seen.columns, seen.heights, watch);
  };
  const auto least = fitted_heights(points, *start, watch, least_squares);
  const auto smallest = least ? fitted_heights(points, *start, watch, minimax) : std::nullopt;
  if (!smallest) {
    return std::nullopt;
  }
  const double middle = 0.5 * (smallest->maxCoeff() + smallest->minCoeff());
  return FlatnessEvaluation{zones_of(*least, *smallest), smallest->array() - middle};
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
  const auto minimax = [watch](const SeenAlong& seen) {
    return minimax_parameters(seen.columns, seen.distances, watch);
  };
  const auto least = fitted_distances(points, watch, least_squares);
  const auto smallest = least ? fitted_distances(points, watch, minimax) : std::nullopt;
  if (!smallest) {
    return std::nullopt;
  }
  return CylindricityEvaluation{zones_of(*least, *smallest), least->array() - least->mean()};
}

}  // namespace g31::metrology
