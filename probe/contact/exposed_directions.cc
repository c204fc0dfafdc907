#include "probe/contact/exposed_directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace g31::probe {
namespace {

/// A convex polygon in the plane x, y of one side of a cube around the origin.
struct Polygon {
  std::array<Eigen::Vector2d, ExposedPiece::kMostCorners> corners;
  std::size_t count = 0;

  void add(const Eigen::Vector2d& corner) { corners[count++] = corner; }
};

/// Leaves in `kept` what of the polygon has normal . corner <= limit.
void clip(const Polygon& polygon, const Eigen::Vector2d& normal, double limit, Polygon& kept) {
  kept.count = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& here = polygon.corners[i];
    const Eigen::Vector2d& next = polygon.corners[i + 1 < polygon.count ? i + 1 : 0];
    const double over_here = normal.dot(here) - limit;
    const double over_next = normal.dot(next) - limit;
    if (over_here <= 0.0) {
      kept.add(here);
    }
    if ((over_here < 0.0 && over_next > 0.0) || (over_here > 0.0 && over_next < 0.0)) {
      kept.add(here + over_here / (over_here - over_next) * (next - here));
    }
  }
}

/// One side of the cube |x|, |y|, |z| <= 1, and the half spaces that the directions away cut off.
class CubeSide {
 public:
  CubeSide(Eigen::Index axis, double sign)
      : axis_(axis), first_((axis + 1) % 3), second_((axis + 2) % 3), sign_(sign) {}

  /// Whether one direction alone leaves nothing: the usual case, and quickly seen.
  [[nodiscard]] bool is_hidden(std::span<const Point> away) const {
    return std::ranges::any_of(away, [&](const Point& direction) {
      return -spread(direction) > limit(direction) + kRounding;
    });
  }

  /// The part that is exposed.
  void find(std::span<const Point> away, ExposedPiece& piece) const {
    std::array<Polygon, 2> polygons;
    Polygon* polygon = polygons.data();
    Polygon* clipped = polygon + 1;
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1),
                                          Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)}) {
      polygon->add(corner);
    }
    for (const Point& direction : away) {
      // A cut adds one corner; where rounding has made the polygon less than convex, half as many
      // again at most.  With no more room the rest is left uncut, which only makes the piece
      // larger.
      if (polygon->count == 0 || polygon->count + polygon->count / 2 > ExposedPiece::kMostCorners) {
        break;
      }
      if (spread(direction) < limit(direction) - kRounding) {
        continue;  // cuts nothing off
      }
      clip(*polygon, {direction[first_], direction[second_]}, limit(direction), *clipped);
      std::swap(polygon, clipped);
    }
    piece.count = 0;
    for (std::size_t i = 0; i < polygon->count; ++i) {
      Point corner = sign_ * Point::Unit(axis_);
      corner[first_] = polygon->corners[i].x();
      corner[second_] = polygon->corners[i].y();
      piece.corners[piece.count++] = corner.normalized();
    }
  }

 private:
  /// More than corners of a clipped polygon are out of the square.
  static constexpr double kRounding = 1e-12;

  /// The greatest product of the direction with a point of the side, less `sign` along the axis.
  [[nodiscard]] double spread(const Point& direction) const {
    return std::abs(direction[first_]) + std::abs(direction[second_]);
  }
  [[nodiscard]] double limit(const Point& direction) const {
    return kExposureSlackRad - sign_ * direction[axis_];
  }

  Eigen::Index axis_;
  Eigen::Index first_;
  Eigen::Index second_;
  double sign_;
};

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

ExposedPieces exposed_around_edge(const Point& edge, std::span<const Point> away) {
  const Point first = edge.unitOrthogonal();
  const Point second = edge.cross(first);
  ExposedPieces pieces;
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
      ExposedPiece& piece = pieces.add();
      piece.corners[0] = (out + low * along).normalized();
      piece.corners[1] = (out + high * along).normalized();
      piece.count = 2;
    }
  }
  return pieces;
}

ExposedPieces exposed_around_vertex(std::span<const Point> away) {
  ExposedPieces pieces;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const CubeSide side(axis, sign);
      if (!side.is_hidden(away)) {
        ExposedPiece piece;
        side.find(away, piece);
        if (piece.count > 0) {
          pieces.add() = piece;
        }
      }
    }
  }
  return pieces;
}

}  // namespace g31::probe
