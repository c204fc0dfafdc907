#include "machine/sim/arc_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace g31::machine::arc_path_test {
namespace {

constexpr double kPi = std::numbers::pi;

AxisPositions axes(double x, double y, double z, double a = 0) {
  return (AxisPositions() << x, y, z, a, 0, 0).finished();
}

ArcMove arc_to(const AxisPositions& q_M_end, Turn turn) {
  ArcMove arc;
  arc.q_M_end = q_M_end;
  arc.turn = turn;
  arc.feed_mm_min = 300.0;
  return arc;
}

TEST(ArcPath, Cases) {
  struct Case {
    const char* name;
    AxisPositions q_M_end;  // from (10, 0) about the origin
    Turn turn;
    double turned_rad;
    AxisPositions q_M_middle;
  };
  const double kDiagonal = 10 * std::sqrt(0.5);
  const Case kCases[] = {
      {"quarter, the short way", axes(0, 10, 0), Turn::Counterclockwise, kPi / 2,
       axes(kDiagonal, kDiagonal, 0)},
      {"quarter, the long way", axes(0, 10, 0), Turn::Clockwise, -1.5 * kPi,
       axes(-kDiagonal, -kDiagonal, 0)},
      {"half, clockwise", axes(-10, 0, 0), Turn::Clockwise, -kPi, axes(0, -10, 0)},
      {"half, counterclockwise", axes(-10, 0, 0), Turn::Counterclockwise, kPi, axes(0, 10, 0)},
      {"full circle", axes(10, 0, 0), Turn::Clockwise, -2 * kPi, axes(-10, 0, 0)},
      {"full circle with rounding one way", axes(10, 1e-13, 0), Turn::Counterclockwise, 2 * kPi,
       axes(-10, 0, 0)},
      {"full circle with rounding the other way", axes(10, -1e-13, 0), Turn::Counterclockwise,
       2 * kPi, axes(-10, 0, 0)},
      {"helix with a rotary axis", axes(10, 0, -8, 90), Turn::Clockwise, -2 * kPi,
       axes(-10, 0, -4, 45)},
      {"spiral", axes(-20, 0, 0), Turn::Counterclockwise, kPi, axes(0, 15, 0)},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const ArcPath path(axes(10, 0, 0), arc_to(c.q_M_end, c.turn));
    EXPECT_NEAR(path.turned_rad(), c.turned_rad, 1e-13);
    EXPECT_LT((path.at(0.5) - c.q_M_middle).norm(), 1e-12);
    EXPECT_EQ(path.at(0.0), axes(10, 0, 0));
    EXPECT_EQ(path.at(1.0), c.q_M_end);
  }
}

TEST(ArcPath, TurnsFromTheFirstAxisToTheSecond) {
  ArcMove arc = arc_to(axes(10, 0, 0), Turn::Counterclockwise);
  arc.first_axis = 2;  // G18: Z points right, X up
  arc.second_axis = 0;
  const ArcPath path(axes(0, 0, 10), arc);
  EXPECT_NEAR(path.turned_rad(), kPi / 2, 1e-15);
  EXPECT_NEAR(path.length(), 5 * kPi, 1e-13);
}

struct RandomArc {
  AxisPositions q_M_from;
  ArcMove arc;
};

RandomArc random_arc(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-100.0, 100.0);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  RandomArc r;
  r.arc.centre_first = coordinate(random);
  r.arc.centre_second = coordinate(random);
  const double radius = std::abs(coordinate(random)) + 1.0;
  const auto on_circle = [&](double rad) {
    return axes(r.arc.centre_first + radius * std::cos(rad),
                r.arc.centre_second + radius * std::sin(rad), coordinate(random));
  };
  r.q_M_from = on_circle(angle(random));
  r.arc.q_M_end = on_circle(angle(random));
  r.arc.turn = angle(random) > 0.0 ? Turn::Clockwise : Turn::Counterclockwise;
  return r;
}

TEST(ArcPath, BoundsAndLengthAgreeWithManyPoints) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const RandomArc r = random_arc(random);
    const ArcPath path(r.q_M_from, r.arc);
    AxisPositions q_M_min = r.q_M_from;
    AxisPositions q_M_max = r.q_M_from;
    AxisPositions q_M_before = r.q_M_from;
    double length = 0.0;
    constexpr int kPoints = 2000;
    for (int k = 1; k <= kPoints; ++k) {
      const AxisPositions q_M = path.at((k + 0.0) / kPoints);
      length += (q_M - q_M_before).head<2>().norm();
      q_M_min = q_M_min.cwiseMin(q_M);
      q_M_max = q_M_max.cwiseMax(q_M);
      q_M_before = q_M;
    }
    // A polyline of 2000 points lies within r (2 pi / 2000)^2 / 8 = 1.3e-4 mm of the arc.
    const AxisBox box = path.bounds();
    ASSERT_LT((box.q_M_min - q_M_min).cwiseAbs().maxCoeff(), 2e-4);
    ASSERT_LT((box.q_M_max - q_M_max).cwiseAbs().maxCoeff(), 2e-4);
    ASSERT_NEAR(path.length(), length, 1e-6 * length);
  }
}

TEST(ArcPath, BoundsAreExactWhereTheArcCrossesAnAxisDirection) {
  ArcMove centred = arc_to(axes(40, 50, 0), Turn::Counterclockwise);
  centred.centre_first = 50;
  centred.centre_second = 50;
  const AxisBox box = ArcPath(axes(60, 50, 0), centred).bounds();
  EXPECT_EQ(box.q_M_min, axes(40, 50, 0));
  EXPECT_EQ(box.q_M_max[0], 60);
  EXPECT_NEAR(box.q_M_max[1], 60, 1.1 * kFullCircleGapMm);
  EXPECT_LT(box.q_M_max[1], 60);
}

TEST(ArcPath, ChordsStayCloseToTheArc) {
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    const RandomArc r = random_arc(random);
    const ArcPath path(r.q_M_from, r.arc);
    const int chords = path.chord_count();
    double worst = 0.0;
    for (int k = 0; k < chords; ++k) {
      const AxisPositions q_M_chord =
          0.5 * (path.at((k + 0.0) / chords) + path.at((k + 1.0) / chords));
      worst = std::max(worst, (q_M_chord - path.at((k + 0.5) / chords)).norm());
    }
    ASSERT_LE(worst, kChordErrorMm);
    if (chords > 8) {  // short arcs have more than they need
      ASSERT_GT(worst, 0.7 * kChordErrorMm) << "far too many chords: " << chords;
    }
  }
}

}  // namespace
}  // namespace g31::machine::arc_path_test
