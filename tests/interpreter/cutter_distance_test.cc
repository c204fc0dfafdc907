#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "interpreter/path/corner.h"
#include "tests/interpreter/compensated_path.h"

namespace g31::path::testing::cutter_distance_test {
namespace {

/// Doubles and the tangent corners that are taken as smooth.
constexpr double kToleranceMm = 2.0 * kCornerErrorMm;

/// Distance of a point from a way, by the shape and not by its tangents.
double distance(const PlanePoint& p, const PlaneWay& way) {
  const double to_ends = std::min((p - way.from).norm(), (p - way.to).norm());
  if (!way.arc) {
    const PlanePoint along = way.to - way.from;
    const double t = (p - way.from).dot(along) / along.squaredNorm();
    return t <= 0.0 || t >= 1.0 ? to_ends : (p - way.from - t * along).norm();
  }
  const PlanePoint& centre = way.arc->centre;
  const double radius = (way.from - centre).norm();
  const PlanePoint foot = centre + radius * (p - centre).normalized();
  const bool on_arc = sweep_rad({way.from, foot, way.arc}) <= sweep_rad(way);
  return on_arc ? (p - foot).norm() : to_ends;
}

/// Points of a straight or circular item that begins at `from`.
std::vector<PlanePoint> samples(const PlanePoint& from, const PathBlock& block) {
  const PlaneWay way{from, block.q_M_end.head<2>(), block.arc};
  std::vector<PlanePoint> points;
  const double turn = block.arc && block.arc->turn == Turn::Clockwise ? -1.0 : 1.0;
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    if (!block.arc) {
      points.push_back(from + t * (way.to - from));
      continue;
    }
    const double angle = turn * t * sweep_rad(way);
    const PlanePoint r = from - block.arc->centre;
    points.push_back(block.arc->centre +
                     PlanePoint(r.x() * std::cos(angle) - r.y() * std::sin(angle),
                                r.x() * std::sin(angle) + r.y() * std::cos(angle)));
  }
  return points;
}

/// How far left of the way a point lies, the way being endless.
double left_of_endless(const PlanePoint& p, const PlaneWay& way) {
  if (!way.arc) {
    const PlanePoint along = (way.to - way.from).normalized();
    return along.x() * (p - way.from).y() - along.y() * (p - way.from).x();
  }
  const double outwards = (p - way.arc->centre).norm() - (way.from - way.arc->centre).norm();
  return way.arc->turn == Turn::Counterclockwise ? -outwards : outwards;
}

/// A closed contour of lines and shallow arcs about the origin, corners in and out.
std::vector<PlaneWay> random_contour(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int count = 3 + static_cast<int>(random() % 8);
  std::vector<PlanePoint> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.4 * unit(random)) / count;
    const double size = 60.0 + 40.0 * unit(random);
    corners.emplace_back(size * std::cos(angle), size * std::sin(angle));
  }
  std::vector<PlaneWay> ways;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlanePoint& from = corners[i];
    const PlanePoint& to = corners[(i + 1) % corners.size()];
    PlaneWay way{from, to, std::nullopt};
    if (random() % 2 == 0) {
      const double chord = (to - from).norm();
      const double radius = chord * (1.5 + 3.0 * unit(random));
      const double height = std::sqrt(radius * radius - chord * chord / 4.0);
      const bool left = random() % 2 == 0;
      const PlanePoint normal(-(to - from).y() / chord, (to - from).x() / chord);
      way.arc = ArcShape{(from + to) / 2.0 + (left ? height : -height) * normal,
                         left ? Turn::Counterclockwise : Turn::Clockwise};
    }
    ways.push_back(way);
  }
  return ways;
}

/// Once around the contour from the middle of its first way, which is made a line.
std::vector<PlaneWay> as_programmed(std::vector<PlaneWay> contour) {
  contour[0].arc.reset();
  const PlanePoint middle = (contour[0].from + contour[0].to) / 2.0;
  contour.push_back({contour[0].from, middle, std::nullopt});
  contour[0].from = middle;
  return contour;
}

PathDriver drive(const std::vector<PlaneWay>& ways, double offset, const CompensationRules& rules) {
  const PlanePoint away = ways[0].from - 30.0 * direction_at_start(ways[0]);
  PathDriver driver(away, rules);
  driver.offset(offset).line(ways[0].from.x(), ways[0].from.y());
  for (const PlaneWay& way : ways) {
    if (!way.arc) {
      driver.line(way.to.x(), way.to.y());
    } else if (way.arc->turn == Turn::Counterclockwise) {
      driver.left_arc(way.to.x(), way.to.y(), way.arc->centre.x(), way.arc->centre.y());
    } else {
      driver.right_arc(way.to.x(), way.to.y(), way.arc->centre.x(), way.arc->centre.y());
    }
  }
  driver.flush();
  return driver;
}

/// How far off the contour the way round an outside corner may lead, as a multiple of the offset.
double most_at_corner(OutsideCorner outside) {
  switch (outside) {
    case OutsideCorner::Lines:
      return std::numbers::sqrt2;
    case OutsideCorner::Arc:
      return 1.0;
    case OutsideCorner::Intersection:
      return 1.0 / std::cos(kSharpestDeg / 2.0 * std::numbers::pi / 180.0);
  }
  return 0.0;
}

/// Every item is either the offset of its own block, exactly, or goes around an outside corner.
void expect_at_distance(const std::vector<PlaneWay>& ways, double offset,
                        OutsideCorner outside = OutsideCorner::Lines) {
  CompensationRules rules;
  rules.outside = outside;
  const PathDriver driver = drive(ways, offset, rules);
  ASSERT_FALSE(driver.fault().has_value());
  const double radius = std::abs(offset);
  const PathItems& items = driver.items();
  PlanePoint at = std::get<PathBlock>(items[0]).q_M_end.head<2>();
  for (std::size_t i = 1; i < items.size(); ++i) {
    const PathBlock& block = std::get<PathBlock>(items[i]);
    const std::size_t number = block.where.begin;
    const bool is_path =
        i + 1 == items.size() || std::get<PathBlock>(items[i + 1]).where.begin != number;
    for (const PlanePoint& p : samples(at, block)) {
      double nearest = 1e9;
      for (const PlaneWay& way : ways) {
        nearest = std::min(nearest, distance(p, way));
      }
      ASSERT_GE(nearest, radius - kToleranceMm) << "item " << i;
      ASSERT_LE(nearest, radius * most_at_corner(outside) + kToleranceMm) << "item " << i;
      if (is_path) {
        ASSERT_NEAR(left_of_endless(p, ways[number - 1]), offset, kToleranceMm) << "item " << i;
      }
    }
    at = block.q_M_end.head<2>();
  }
}

TEST(CutterDistance, RandomContoursOfLinesAndArcsOnBothSides) {
  std::mt19937_64 random(20240511);
  std::uniform_real_distribution<double> radius(0.2, 4.0);
  for (int i = 0; i < 80; ++i) {
    SCOPED_TRACE(i);
    const auto ways = as_programmed(random_contour(random));
    const double r = radius(random);
    ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, r));
    ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, -r));
  }
}

TEST(CutterDistance, ArcsAtOutsideCornersKeepTheDistanceEverywhere) {
  std::mt19937_64 random(20240512);
  std::uniform_real_distribution<double> radius(0.2, 4.0);
  for (int i = 0; i < 80; ++i) {
    SCOPED_TRACE(i);
    const auto ways = as_programmed(random_contour(random));
    const double r = radius(random);
    ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, r, OutsideCorner::Arc));
    ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, -r, OutsideCorner::Arc));
  }
}

TEST(CutterDistance, IntersectionsAtOutsideCornersUpToTheSharpestOne) {
  std::mt19937_64 random(20240513);
  std::uniform_real_distribution<double> radius(0.2, 4.0);
  for (int i = 0; i < 80; ++i) {
    SCOPED_TRACE(i);
    const auto ways = as_programmed(random_contour(random));
    const double r = radius(random);
    ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, r, OutsideCorner::Intersection));
    ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, -r, OutsideCorner::Intersection));
  }
}

TEST(CutterDistance, CornersThatAreAlmostTangent) {
  for (const double kink : {0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    for (const double sign : {1.0, -1.0}) {
      SCOPED_TRACE(sign * kink);
      // A line along X into a quarter about (0, 20), turned by the kink about the corner.
      const double angle = sign * kink;
      const auto turned = [&](double x, double y) {
        return PlanePoint(x * std::cos(angle) - y * std::sin(angle),
                          x * std::sin(angle) + y * std::cos(angle));
      };
      const std::vector<PlaneWay> ways = {
          {{-50.0, 0.0}, {0.0, 0.0}, std::nullopt},
          {{0.0, 0.0}, turned(20.0, 20.0), ArcShape{turned(0.0, 20.0), Turn::Counterclockwise}},
          {turned(20.0, 20.0), turned(20.0, 60.0), std::nullopt}};
      ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, 5.0));
      ASSERT_NO_FATAL_FAILURE(expect_at_distance(ways, -5.0));
    }
  }
}

}  // namespace
}  // namespace g31::path::testing::cutter_distance_test
