#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "machine/units/point.h"
#include "probe/metrology/form_fits.h"
#include "probe/metrology/form_zones.h"
#include "probe/metrology/minimax_fit.h"

namespace g31::metrology {
namespace {

/// A plane, by a point and its normal.
struct Plane {
  Point at;
  Point normal;
};

/// The plane that points are about in, and how wide they lie in it across their length.
struct Spread {
  Plane plane;
  double width = 0.0;
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
/// One row of touches along a face is a line: what it is out of straight spans no face.
std::optional<Spread> spread_of(const Eigen::MatrixX3d& points) {
  constexpr double kNarrowest = 1e-3;  // of their length
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
  return Spread{{middle, normal.normalized()}, second.cross(along).norm()};
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

/// Which side of a plane is above it, whatever the order of its points: that towards +z, whence a
/// probe and a sensor look; of an upright face that towards +x, then +y.
Point upwards(const Point& normal) {
  constexpr double kUpright = 0.01;  // rad, more than what such a face is out of upright
  for (const Eigen::Index axis : {2, 0}) {
    if (std::abs(normal[axis]) > kUpright) {
      return normal[axis] > 0.0 ? normal : Point(-normal);
    }
  }
  return normal.y() > 0.0 ? normal : Point(-normal);
}

/// How high the points are above the plane that repeated fits come to: at rest, heights along its
/// normal are those along which the fit has looked.
template <typename Fit>
std::optional<Eigen::VectorXd> fitted_heights(const Eigen::MatrixX3d& points, Plane plane,
                                              machine::WorkWatch* watch, Fit fit) {
  constexpr int kRounds = 1000;
  constexpr double kAtRest = 1e-15;  // rad, here and below
  constexpr double kRounding = 1e-11;
  double before = std::numeric_limits<double>::infinity();
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
    const bool is_rounding = tilt.norm() < kRounding && tilt.norm() >= before;
    if (tilt.norm() < kAtRest || is_rounding) {
      break;
    }
    before = tilt.norm();
  }
  plane.normal = upwards(plane.normal);
  return seen_across(plane, points, watch).heights;
}

/// Heights above the middle of a zone that turning its planes a little does not make smaller.
std::optional<Eigen::VectorXd> local_zone(const Eigen::MatrixX3d& points, const Plane& start,
                                          machine::WorkWatch* watch) {
  return fitted_heights(points, start, watch, [watch](const SeenAcross& seen) {
    const auto fit = minimax_fit(seen.columns, seen.heights, watch);
    return fit ? std::optional(fit->parameters) : std::nullopt;
  });
}

/// A zone that is thin beside the face is the only one.  Points that are no face may have several,
/// which are found from directions all around.
std::optional<Eigen::VectorXd> smallest_zone(const Eigen::MatrixX3d& points, const Spread& spread,
                                             machine::WorkWatch* watch) {
  constexpr double kThin = 0.01;
  constexpr int kDirections = 64;
  auto smallest = local_zone(points, spread.plane, watch);
  if (!smallest || range_of(*smallest) <= kThin * spread.width) {
    return smallest;
  }
  for (int i = 0; i < kDirections; ++i) {
    const double height = (i + 0.5) / kDirections;
    const double across = std::sqrt(1.0 - height * height);
    const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));  // the golden angle
    const Point normal(across * std::cos(angle), across * std::sin(angle), height);
    const auto other = local_zone(points, {spread.plane.at, normal}, watch);
    if (other && range_of(*other) < range_of(*smallest)) {
      smallest = other;
    }
  }
  return smallest;
}

}  // namespace

std::optional<FlatnessEvaluation> flatness_of(const Eigen::MatrixX3d& points,
                                              machine::WorkWatch* watch) {
  if (points.rows() < 3) {
    return std::nullopt;
  }
  const std::optional<Spread> spread = spread_of(points);
  if (!spread) {
    return std::nullopt;
  }
  const auto least_squares = [](const SeenAcross& seen) {
    return std::optional<Eigen::VectorXd>(seen.columns.colPivHouseholderQr().solve(seen.heights));
  };
  const auto least = fitted_heights(points, spread->plane, watch, least_squares);
  const auto smallest = least ? smallest_zone(points, *spread, watch) : std::nullopt;
  if (!smallest) {
    return std::nullopt;
  }
  const double middle = 0.5 * (smallest->maxCoeff() + smallest->minCoeff());
  return FlatnessEvaluation{zones_of(*least, *smallest), smallest->array() - middle};
}

}  // namespace g31::metrology
