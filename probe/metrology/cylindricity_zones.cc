#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/QR>

#include "machine/units/point.h"
#include "probe/metrology/form_fits.h"
#include "probe/metrology/form_zones.h"
#include "probe/metrology/minimax_fit.h"

namespace g31::metrology {
namespace {

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
std::optional<Eigen::VectorXd> fitted_distances(const Eigen::MatrixX3d& points, Axis axis,
                                                machine::WorkWatch* watch, Fit fit) {
  constexpr int kRounds = 8;
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

/// An axis, and how far the points are from it.
struct AxisZone {
  Axis axis;
  SeenAlong seen;

  [[nodiscard]] double width() const { return range_of(seen.distances); }
};

AxisZone zone_about(const Axis& axis, const Eigen::MatrixX3d& points, machine::WorkWatch* watch) {
  return {axis, seen_along(axis, points, watch)};
}

/// The linear fit with the smallest zone whose steps are no longer than `reach`, mm at either end:
/// steps enter as points would that touch the zone at that length.
std::optional<MinimaxFit> step_within(const AxisZone& zone, double reach,
                                      machine::WorkWatch* watch) {
  if (!std::isfinite(reach)) {
    return minimax_fit(zone.seen.columns, zone.seen.distances, watch);
  }
  constexpr Eigen::Index kSteps = 4;
  const Eigen::Index count = zone.seen.distances.size();
  const double middle = 0.5 * (zone.seen.distances.maxCoeff() + zone.seen.distances.minCoeff());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count + kSteps, kSteps + 1);
  Eigen::VectorXd distances = Eigen::VectorXd::Zero(count + kSteps);
  columns.topRows(count) = zone.seen.columns;
  distances.head(count) = zone.seen.distances.array() - middle;
  columns.bottomRightCorner(kSteps, kSteps).diagonal().setConstant(0.5 * zone.width() / reach);
  return minimax_fit(columns, distances, watch);
}

/// A zone that moving the axis a little does not make smaller.  A step that makes it larger,
/// because distances are not linear, is taken back, and the next ones are shorter.
std::optional<AxisZone> local_zone(AxisZone zone, const Eigen::MatrixX3d& points,
                                   machine::WorkWatch* watch) {
  constexpr int kRounds = 100;
  constexpr double kShortest = 1e-7;
  const double rounding = 1e-13 * zone.seen.distances.maxCoeff();
  double reach = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    const auto step = step_within(zone, reach, watch);
    if (!step || !step->parameters.allFinite()) {
      return std::nullopt;
    }
    const bool is_long = reach > kShortest * zone.width();
    if (!is_long || !(2.0 * step->half_width < zone.width() - rounding)) {
      break;
    }
    AxisZone next = zone_about(moved(zone.axis, zone.seen, step->parameters), points, watch);
    const double length = step->parameters.tail<4>().cwiseAbs().maxCoeff();
    if (next.width() < zone.width()) {
      zone = std::move(next);
      reach *= 2.0;
    } else {
      reach = 0.25 * std::min(length, reach);
    }
  }
  return zone;
}

/// A zone that is thin beside the radius is the only one.  Coarser forms may have several, which
/// are found from axes aside and aslant by half a zone.
std::optional<AxisZone> smallest_zone(const Eigen::MatrixX3d& points, const Axis& start,
                                      machine::WorkWatch* watch) {
  constexpr double kThin = 0.01;
  constexpr unsigned kCorners = 16;
  auto smallest = local_zone(zone_about(start, points, watch), points, watch);
  if (!smallest || smallest->width() <= kThin * smallest->seen.distances.mean()) {
    return smallest;
  }
  const AxisZone first = *smallest;
  for (unsigned corner = 0; corner < kCorners; ++corner) {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(5);
    for (unsigned i = 0; i < 4; ++i) {
      by[i + 1] = ((corner >> i) & 1U) == 0 ? -0.5 * first.width() : 0.5 * first.width();
    }
    const auto other =
        local_zone(zone_about(moved(first.axis, first.seen, by), points, watch), points, watch);
    if (other && other->width() < smallest->width()) {
      smallest = other;
    }
  }
  return smallest;
}

}  // namespace

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
  const Axis start{points.colwise().mean(), Point::UnitZ()};
  const auto least = fitted_distances(points, start, watch, least_squares);
  const auto smallest = least ? smallest_zone(points, start, watch) : std::nullopt;
  if (!smallest) {
    return std::nullopt;
  }
  return CylindricityEvaluation{zones_of(*least, smallest->seen.distances),
                                least->array() - least->mean()};
}

}  // namespace g31::metrology
