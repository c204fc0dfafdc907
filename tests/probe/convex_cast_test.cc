// First contacts of convex shapes against closed forms, and against a bisection that shares nothing
// with the search.

#include "probe/tooling/convex_cast.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "tests/support/effort.h"

namespace g31::probe::convex_cast_test {
namespace {

class Draw {
 public:
  explicit Draw(std::uint32_t stream) : stream_(stream) {}
  double between(double low, double high) {
    return low + (high - low) * uniform({7, stream_}, event_++);
  }
  Point point(double reach) {
    const double x = between(-reach, reach);
    const double y = between(-reach, reach);
    return {x, y, between(-reach, reach)};
  }
  Eigen::Matrix3d turn() {
    const Eigen::Quaterniond any(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1));
    return any.normalized().toRotationMatrix();
  }

 private:
  std::uint32_t stream_;
  std::uint64_t event_ = 0;
};

ProbeSection cylinder(double radius, double bottom, double top, double rounding = 0.0) {
  ProbeSection section;
  section.radius_bottom = section.radius_top = radius;
  section.z_bottom = bottom;
  section.z_top = top;
  section.rounding = rounding;
  return section;
}

PlacedShape at(const ConvexShape& shape, const Point& p) {
  return {&shape, Eigen::Matrix3d::Identity(), p};
}

/// Where |start + t way| first equals a radius, t in 0..1.
std::optional<double> enters_circle(const Eigen::VectorXd& start, const Eigen::VectorXd& way,
                                    double radius) {
  const double a = way.squaredNorm();
  const double b = start.dot(way);
  const double c = start.squaredNorm() - radius * radius;
  const double d = b * b - a * c;
  if (d < 0.0) {
    return std::nullopt;
  }
  const double t = (-b - std::sqrt(d)) / a;
  return t >= 0.0 && t <= 1.0 ? std::optional(t) : std::nullopt;
}

const ConvexShape kBox = Box{{12.5, 12.5, 12.5}};

TEST(ConvexCast, AMillFromAboveStopsOnTheFace) {
  Draw draw(1);
  for (int i = 0; i < testing::of_many(4000); ++i) {
    const ConvexShape mill = cylinder(draw.between(2, 12), -100, 0);
    const Point start(draw.between(-10, 10), draw.between(-10, 10), draw.between(113, 125));
    const Point way(draw.between(-3, 3), draw.between(-3, 3), -20);
    const CastHit hit = convex_cast(at(kBox, Point::Zero()), at(mill, start), way);
    ASSERT_EQ(hit.status, CastStatus::Contact);
    EXPECT_NEAR(hit.fraction * 20, start.z() - 112.5, 1e-12);
    EXPECT_NEAR((hit.n - Point::UnitZ()).norm(), 0.0, 1e-9);
  }
}

TEST(ConvexCast, AMillFromTheSideStopsOnTheFace) {
  Draw draw(2);
  for (int i = 0; i < testing::of_many(4000); ++i) {
    const double radius = draw.between(0.5, 30);
    const ConvexShape mill = cylinder(radius, -100, 0);
    const Point start(draw.between(44, 60), draw.between(-8, 8), draw.between(80, 105));
    const Point way(-60, draw.between(-3, 3), draw.between(-1, 1));
    const CastHit hit = convex_cast(at(kBox, Point::Zero()), at(mill, start), way);
    ASSERT_EQ(hit.status, CastStatus::Contact);
    EXPECT_NEAR(hit.fraction * 60, start.x() - radius - 12.5, 1e-12);
  }
}

TEST(ConvexCast, AMillMeetsADiscAsTwoCirclesMeet) {
  Draw draw(3);
  const ConvexShape disc = cylinder(10, -5, 0);
  int met = 0;
  for (int i = 0; i < testing::of_many(4000); ++i) {
    const double radius = draw.between(1, 20);
    const ConvexShape mill = cylinder(radius, -100, 0);
    const Point start(draw.between(40, 60), draw.between(-25, 25), 97);
    const Point way(-60, draw.between(-5, 5), 0);
    const CastHit hit = convex_cast(at(disc, Point::Zero()), at(mill, start), way);
    const auto fraction = enters_circle(start.head<2>(), way.head<2>(), 10 + radius);
    ASSERT_EQ(hit.status == CastStatus::Contact, fraction.has_value());
    if (fraction) {
      ++met;
      EXPECT_NEAR(hit.fraction * way.norm(), *fraction * way.norm(), kCastErrorMm);
    }
  }
  EXPECT_GT(met, testing::of_many(2000));
}

TEST(ConvexCast, BallsMeetAsBallsDo) {
  Draw draw(4);
  for (int i = 0; i < testing::of_many(4000); ++i) {
    const double radius = draw.between(0.5, 9);
    const ConvexShape ball = cylinder(0, 0, 0, radius);
    const ConvexShape other = cylinder(0, 0, 0, 7);
    const Point start = Point(40, 0, 0) + draw.point(8);
    const Point way = Point(-60, 0, 0) + draw.point(8);
    const CastHit hit = convex_cast(at(other, Point::Zero()), at(ball, start), way);
    const auto fraction = enters_circle(start, way, 7 + radius);
    ASSERT_EQ(hit.status == CastStatus::Contact, fraction.has_value());
    if (fraction) {
      EXPECT_NEAR(hit.fraction * way.norm(), *fraction * way.norm(), kCastErrorMm);
      const Point n = (start + *fraction * way).normalized();
      EXPECT_NEAR((hit.n - n).norm(), 0.0, 1e-5);
      EXPECT_NEAR((hit.p_point - 7 * n).norm(), 0.0, 1e-3);
    }
  }
}

/// A ball against a box that stands anyhow: its distance is known, so bisection finds the place.
TEST(ConvexCast, ABallMeetsFacesEdgesAndCornersOfATurnedBox) {
  Draw draw(5);
  int met = 0;
  for (int i = 0; i < testing::of_many(1500); ++i) {
    const Point half(draw.between(2, 20), draw.between(2, 20), draw.between(2, 20));
    const double radius = draw.between(0.1, 8);
    const ConvexShape box = Box{half};
    const ConvexShape ball = cylinder(0, 0, 0, radius);
    const PlacedShape target{&box, draw.turn(), draw.point(5)};
    const Point start = draw.point(30).normalized() * 70;
    const Point way = draw.point(8) - 1.2 * start;
    const auto distance = [&](double t) {
      const Point p = target.turn.transpose() * (start + t * way - target.p);
      return (p - p.cwiseMin(half).cwiseMax(-half)).norm() - radius;
    };
    double nearest = 0.0;
    for (double t = 0.0; t <= 1.0; t += 1e-3) {
      nearest = distance(t) < distance(nearest) ? t : nearest;
    }
    const CastHit hit = convex_cast(target, at(ball, start), way);
    if (distance(nearest) > 0.0) {
      // It passes by; within a hundredth the samples cannot tell.
      EXPECT_TRUE(distance(nearest) < 1e-2 || hit.status == CastStatus::Miss) << i;
      continue;
    }
    ++met;
    double apart = 0.0;
    double together = nearest;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (apart + together);
      (distance(middle) > 0.0 ? apart : together) = middle;
    }
    ASSERT_EQ(hit.status, CastStatus::Contact) << i;
    EXPECT_NEAR(hit.fraction * way.norm(), together * way.norm(), kCastErrorMm) << i;
  }
  EXPECT_GT(met, testing::of_many(1000));
}

/// The planes that a cast says are proofs: nothing of the shapes may be on the wrong side of the
/// last.
TEST(ConvexCast, NothingOverlapsWhereTurnedCylindersMeet) {
  Draw draw(6);
  int met = 0;
  for (int i = 0; i < testing::of_many(1500); ++i) {
    const ConvexShape first = cylinder(draw.between(1, 12), -20, 20);
    const ConvexShape second = cylinder(draw.between(1, 12), -60, 0, draw.between(0, 2));
    const PlacedShape target{&first, draw.turn(), Point::Zero()};
    const Point start = draw.point(30).normalized() * 130;
    const PlacedShape moving{&second, draw.turn(), start};
    const Point way = draw.point(10) - start;
    const CastHit hit = convex_cast(target, moving, way);
    if (hit.status != CastStatus::Contact) {
      continue;
    }
    ++met;
    const Point there = hit.fraction * way;
    const double gap = hit.n.dot(moving.furthest(-hit.n) + there - target.furthest(hit.n));
    EXPECT_NEAR(gap, 0.0, 1e-9) << i;  // apart until there
    // A little further they are not: no direction tells them apart.
    const PlacedShape deeper{&second, moving.turn, start + there + 1e-5 / way.norm() * way};
    EXPECT_EQ(convex_cast(target, deeper, way).status, CastStatus::StartsInside) << i;
  }
  EXPECT_GT(met, testing::of_many(700));
}

TEST(ConvexCast, ABladeTouchesWithItsCorner) {
  Blade blade;
  blade.direction = {std::cos(0.3), std::sin(0.3)};
  blade.corners = {Blade::Radial(0, -99.7), Blade::Radial(0, 0), Blade::Radial(8, 0),
                   Blade::Radial(8, -100)};
  blade.rounded_centre = blade.corners[3];
  const ConvexShape shape = blade;
  const CastHit above =
      convex_cast(at(kBox, Point::Zero()), at(shape, {0, 0, 120}), Point(0, 0, -20));
  EXPECT_NEAR(above.fraction * 20, 7.5, 1e-12);
  const CastHit side =
      convex_cast(at(kBox, Point::Zero()), at(shape, {-40, 0, 100}), Point(40, 0, 0));
  EXPECT_NEAR(side.fraction * 40, 40 - 12.5 - 8 * std::cos(0.3), 1e-12);
}

/// By how much later than the cast says a plane is entered, mm: the normal climbs, at random, as
/// long as any near it is entered later.
double later_entry(const PlacedShape& target, const PlacedShape& moving, const Point& way,
                   const CastHit& hit, Draw& draw) {
  double latest = hit.fraction;
  Point n_latest = hit.n;
  for (double reach = 0.03; reach > 1e-11; reach *= 0.7) {
    for (int i = 0; i < 20; ++i) {
      const Point n = (n_latest + draw.point(reach)).normalized();
      const double towards = n.dot(way);
      const double fraction =
          towards < 0.0 ? n.dot(target.furthest(n) - moving.furthest(-n)) / towards : latest;
      if (fraction > latest) {
        latest = fraction;
        n_latest = n;
      }
    }
  }
  return (latest - hit.fraction) * way.norm();
}

/// An insert with its tip's middle in the origin, turned at random.
InsertPlate drawn_plate(Draw& draw) {
  InsertPlate plate;
  plate.tip_radius = draw.between(0.05, 1.6);
  const double middle = draw.between(0.0, 6.28);
  const double half = draw.between(0.15, 0.75);
  for (const double side : {-1.0, 1.0}) {
    const double angle = middle + side * half;
    plate.edge_ends.at(side > 0.0 ? 1 : 0) =
        plate.tip_radius * side * Point(std::cos(angle), 0.0, -std::sin(angle)) +
        draw.between(3.0, 15.0) * Point(std::sin(angle), 0.0, std::cos(angle));
  }
  return plate;
}

/// Edges along cones and rims, where the search alone is 2e-5 mm off.
TEST(ConvexCast, NoPlaneIsEnteredLaterThanTheContact) {
  Draw draw(9);
  const ConvexShape targets[] = {kBox, cylinder(15.0, -5.0, 5.0)};
  int contacts = 0;
  for (int i = 0; i < testing::of_many(4000); ++i) {
    const ConvexShape moving = i % 3 == 0 ? ConvexShape(cylinder(draw.between(2, 12), -40, 0))
                                          : ConvexShape(drawn_plate(draw));
    const PlacedShape target = at(targets[i % 2], Point::Zero());
    const Point along = draw.point(1.0).normalized();
    const PlacedShape tool{&moving, draw.turn(), -80.0 * along + draw.point(8.0)};
    const Point way = 120.0 * along;
    const CastHit hit = convex_cast(target, tool, way);
    if (hit.status == CastStatus::Contact) {
      ++contacts;
      EXPECT_LE(later_entry(target, tool, way, hit, draw), kCastErrorMm) << i;
    }
  }
  EXPECT_GT(contacts, testing::of_many(4000) / 2);
}

TEST(ConvexCast, WhatOverlapsBeforeItMovesSaysSo) {
  const ConvexShape mill = cylinder(5, -100, 0);
  const PlacedShape box = at(kBox, Point::Zero());
  EXPECT_EQ(convex_cast(box, at(mill, {0, 0, 105}), Point(0, 0, 50)).status,
            CastStatus::StartsInside);
  EXPECT_EQ(convex_cast(box, at(mill, {0, 0, 120}), Point(0, 0, -7)).status, CastStatus::Miss);
  EXPECT_EQ(convex_cast(box, at(mill, {0, 0, 120}), Point(0, 0, 9)).status, CastStatus::Miss);
}

}  // namespace
}  // namespace g31::probe::convex_cast_test
