#include "probe/contact/exposed_directions.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace g31::probe {
namespace {

/// A convex polygon in the plane x, y of one side of a cube around the origin.
struct Polygon {
  std::array<Eigen::Vector2d, ExposedPiece::kMostCorners> corners;
  std::size_t count = 0;

  void add(const Eigen::Vector2d& corner) { corners[count++] = corner; }
};

/// What of the polygon has normal . corner <= limit.
Polygon clipped(const Polygon& polygon, const Eigen::Vector2d& normal, double limit) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& here = polygon.corners[i];
    const Eigen::Vector2d& next = polygon.corners[(i + 1) % polygon.count];
    const double over_here = normal.dot(here) - limit;
    const double over_next = normal.dot(next) - limit;
    if (over_here <= 0.0) {
      kept.add(here);
    }
    if ((over_here < 0.0 && over_next > 0.0) || (over_here > 0.0 && over_next < 0.0)) {
      kept.add(here + over_here / (over_here - over_next) * (next - here));
    }
  }
  return kept;
}

/// The part of one side of the cube |x|, |y|, |z| <= 1 that is exposed.
ExposedPiece exposed_on_side(const Point& out, Eigen::Index axis, std::span<const Point> away) {
  const Eigen::Index first = (axis + 1) % 3;
  const Eigen::Index second = (axis + 2) % 3;
  Polygon polygon;
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1),
                                        Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)}) {
    polygon.add(corner);
  }
  for (const Point& direction : away) {
    // A cut adds one corner; where rounding has made the polygon less than convex, half as many
    // again at most.  With no more room the rest is left uncut, which only makes the piece larger.
    if (polygon.count == 0 || polygon.count + polygon.count / 2 > ExposedPiece::kMostCorners) {
      break;
    }
    polygon = clipped(polygon, {direction[first], direction[second]},
                      kExposureSlackRad - direction.dot(out));
  }
  ExposedPiece piece;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    Point corner = out;
    corner[first] = polygon.corners[i].x();
    corner[second] = polygon.corners[i].y();
    piece.corners[piece.count++] = corner.normalized();
  }
  return piece;
}

}  // namespace

Point ExposedPiece::middle() const {
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    sum += corners[i];
  }
  return sum.normalized();
}

parts::Box ExposedPiece::box() const {
  // A unit vector in the cone is a sum of corners with weights >= 0.  The weights add up to 1 at
  // least, and to 1 / cos at most, where cos is that of the corner farthest from the middle.
  const Point centre = middle();
  double least_cosine = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    least_cosine = std::min(least_cosine, centre.dot(corners[i]));
  }
  parts::Box box;
  for (std::size_t i = 0; i < count; ++i) {
    box.include(corners[i]);
    box.include(Point(corners[i] / least_cosine));
  }
  return box;
}

std::vector<ExposedPiece> exposed_around_edge(const Point& edge, std::span<const Point> away) {
  const Point first = edge.unitOrthogonal();
  const Point second = edge.cross(first);
  std::vector<ExposedPiece> pieces;
  // The sides of a square around the edge; on each the exposed points make an interval.
  for (const auto& [out, along] :
       {std::array{first, second}, std::array{second, Point(-first)},
        std::array{Point(-first), Point(-second)}, std::array{Point(-second), first}}) {
    double low = -1.0;
    double high = 1.0;
    for (const Point& direction : away) {
      const double slope = direction.dot(along);
      const double over = direction.dot(out) - kExposureSlackRad;
      // over + slope y <= 0
      if (slope > 0.0) {
        high = std::min(high, -over / slope);
      } else if (slope < 0.0) {
        low = std::max(low, -over / slope);
      } else if (over > 0.0) {
        high = -2.0;
      }
    }
    if (low <= high) {
      ExposedPiece piece;
      piece.corners[0] = (out + low * along).normalized();
      piece.corners[1] = (out + high * along).normalized();
      piece.count = 2;
      pieces.push_back(piece);
    }
  }
  return pieces;
}

std::vector<ExposedPiece> exposed_around_vertex(std::span<const Point> away) {
  std::vector<ExposedPiece> pieces;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const ExposedPiece piece = exposed_on_side(sign * Point::Unit(axis), axis, away);
      if (piece.count > 0) {
        pieces.push_back(piece);
      }
    }
  }
  return pieces;
}

}  // namespace g31::probe
