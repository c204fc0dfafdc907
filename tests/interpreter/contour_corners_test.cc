// Roundings and chamfers as geometry: a rounding touches both of its ways.

#include "interpreter/path/contour_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace g31::path::contour_corners_test {
namespace {

using machine::Turn;

AxisPositions at(const PlanePoint& p) {
  AxisPositions q = AxisPositions::Zero();
  q.head<2>() = p;
  return q;
}

PathBlock block_to(const PlaneWay& way) {
  PathBlock block;
  block.q_M_end = at(way.to);
  block.arc = way.arc;
  block.feed_mm_min = 100.0;
  return block;
}

PlanePoint polar(double degrees, double radius) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A way that ends (or begins) at the origin, along `degrees` there; half of them are arcs.
PlaneWay way_at_origin(std::mt19937_64& random, double degrees, bool ends) {
  std::uniform_real_distribution<double> size(40.0, 80.0);
  const double sign = ends ? -1.0 : 1.0;
  if (random() % 2 == 0) {
    const PlanePoint far = polar(degrees, sign * size(random));
    return ends ? PlaneWay{far, PlanePoint::Zero(), std::nullopt}
                : PlaneWay{PlanePoint::Zero(), far, std::nullopt};
  }
  const double side = random() % 2 == 0 ? 1.0 : -1.0;
  const double radius = size(random);
  const PlanePoint centre = polar(degrees + 90.0 * side, radius);
  const PlanePoint far = centre + polar(degrees - 90.0 * side + sign * side * 60.0, radius);
  const ArcShape arc{centre, side > 0.0 ? Turn::Counterclockwise : Turn::Clockwise};
  return ends ? PlaneWay{far, PlanePoint::Zero(), arc} : PlaneWay{PlanePoint::Zero(), far, arc};
}

/// What a wish makes of the corner of two ways.
std::vector<PlaneWay> cut(const PlaneWay& before, const PlaneWay& behind, const CornerWish& wish) {
  ContourCorners corners;
  PathItems items;
  for (const auto& [way, asks] : {std::pair{before, wish}, std::pair{behind, CornerWish{}}}) {
    const auto given = corners.take(block_to(way), at(way.from), OffsetPlane{}, asks);
    EXPECT_TRUE(given);
    items.insert(items.end(), given.value().before.begin(), given.value().before.end());
    items.insert(items.end(), given.value().now.begin(), given.value().now.end());
  }
  std::vector<PlaneWay> ways;
  PlanePoint from = before.from;
  for (const PathItem& item : items) {
    const PathBlock& block = std::get<PathBlock>(item);
    ways.push_back({from, block.q_M_end.head<2>(), block.arc});
    from = ways.back().to;
  }
  return ways;
}

/// What a rounding of this radius makes of two ways.
std::vector<PlaneWay> rounded(const PlaneWay& before, const PlaneWay& behind, double radius) {
  CornerWish wish;
  wish.kind = CornerWish::Kind::Rounding;
  wish.size_mm = radius;
  return cut(before, behind, wish);
}

/// The corner is at the origin: the arc's nearest point is what the tolerance is about, axis by
/// axis.
TEST(ContourCorners, PassingByKeepsDistanceToleranceAndDirection) {
  std::mt19937_64 random(20250103);
  std::uniform_real_distribution<double> turn(5.0, 170.0);
  std::uniform_real_distribution<double> length(1.0, 30.0);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const double heading = 360.0 * static_cast<double>(i) / 400.0;
    const double degrees = random() % 2 == 0 ? turn(random) : -turn(random);
    const PlaneWay before{polar(heading, -length(random)), PlanePoint::Zero(), std::nullopt};
    const PlaneWay behind{PlanePoint::Zero(), polar(heading + degrees, length(random)),
                          std::nullopt};
    CornerWish wish;
    wish.kind = CornerWish::Kind::PassBy;
    wish.size_mm = 4.0;
    wish.tolerance_mm = i % 2 == 0 ? wish.tolerance_mm : PlanePoint(0.05, 0.2);
    const auto ways = cut(before, behind, wish);
    ASSERT_EQ(ways.size(), 3U);
    ASSERT_TRUE(ways[1].arc.has_value());
    EXPECT_LT((direction_at_end(ways[0]) - direction_at_start(ways[1])).norm(), 1e-7);
    EXPECT_LT((direction_at_end(ways[1]) - direction_at_start(ways[2])).norm(), 1e-7);
    const double leg = ways[1].from.norm();
    EXPECT_NEAR(ways[1].to.norm(), leg, 1e-9);
    const PlanePoint centre = ways[1].arc->centre;
    const double radius = (ways[1].from - centre).norm();
    const PlanePoint nearest = centre * (1.0 - radius / centre.norm());
    const double longest = std::min({4.0, before.from.norm() / 2, behind.to.norm() / 2});
    const double share = std::max({leg / longest, std::abs(nearest.x()) / wish.tolerance_mm.x(),
                                   std::abs(nearest.y()) / wish.tolerance_mm.y()});
    EXPECT_NEAR(share, 1.0, 1e-7) << "as large as all three allow, and no larger";
  }
}

TEST(ContourCorners, RoundingsGoOnInTheSameDirectionAtBothEnds) {
  std::mt19937_64 random(20250101);
  std::uniform_real_distribution<double> turn(10.0, 130.0);
  std::uniform_real_distribution<double> radius(0.5, 5.0);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const double degrees = random() % 2 == 0 ? turn(random) : -turn(random);
    const PlaneWay before = way_at_origin(random, 0.0, true);
    const PlaneWay behind = way_at_origin(random, degrees, false);
    const double r = radius(random);
    const auto ways = rounded(before, behind, r);
    ASSERT_EQ(ways.size(), 3U);
    ASSERT_TRUE(ways[1].arc.has_value());
    EXPECT_NEAR((ways[1].from - ways[1].arc->centre).norm(), r, 1e-9);
    EXPECT_NEAR((ways[1].to - ways[1].arc->centre).norm(), r, 1e-9);
    EXPECT_LT((direction_at_end(ways[0]) - direction_at_start(ways[1])).norm(), 1e-7);
    EXPECT_LT((direction_at_end(ways[1]) - direction_at_start(ways[2])).norm(), 1e-7);
    EXPECT_LT(sweep_rad(ways[0]), sweep_rad(before) + 1e-9);
    EXPECT_LT(sweep_rad(ways[2]), sweep_rad(behind) + 1e-9);
    EXPECT_LT((ways[2].to - behind.to).norm(), 1e-12);
  }
}

TEST(ContourCorners, RoundingsTooLargeEndAtTheEndOfAWay) {
  std::mt19937_64 random(20250102);
  std::uniform_real_distribution<double> turn(20.0, 120.0);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const double degrees = random() % 2 == 0 ? turn(random) : -turn(random);
    const PlaneWay before{polar(180.0, 30.0), PlanePoint::Zero(), std::nullopt};
    const PlaneWay behind{PlanePoint::Zero(), polar(degrees, 20.0), std::nullopt};
    const auto ways = rounded(before, behind, 1000.0);
    // 20 mm is what the tangent of half the turn makes of the radius.
    const double r = 20.0 / std::tan(std::abs(degrees) * std::numbers::pi / 360.0);
    ASSERT_EQ(ways.size(), 2U);
    EXPECT_NEAR((ways[0].to - polar(180.0, 20.0)).norm(), 0.0, 2e-6);
    EXPECT_NEAR((ways[1].to - behind.to).norm(), 0.0, 2e-6);
    EXPECT_NEAR((ways[1].from - ways[1].arc->centre).norm(), r, 1e-5 * r);
  }
}

}  // namespace
}  // namespace g31::path::contour_corners_test
