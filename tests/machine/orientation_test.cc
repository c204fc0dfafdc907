// Which positions of the rotary axes bring the tool to a direction: the worked examples of the
// five-axis specification, random machines against long double, limits, poles and choices.

#include "machine/kinematics/orientation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/kinematics/plane_rotation.h"
#include "tests/support/worked_machines.h"

namespace g31::machine::orientation_test {
namespace {

using namespace worked;  // NOLINT(google-build-using-namespace)

constexpr int kX = 0;
constexpr int kY = 1;
constexpr int kZ = 2;

Eigen::Matrix3d xyz(double a, double b, double c) {
  return about_turned_axes({AxisTurn{kX, a}, AxisTurn{kY, b}, AxisTurn{kZ, c}});
}
Eigen::Matrix3d zyx(double a, double b, double c) {
  return about_turned_axes({AxisTurn{kZ, a}, AxisTurn{kY, b}, AxisTurn{kX, c}});
}

/// Axes 1 and 2 of one solution.
using Angles = std::array<double, 2>;

/// A row of table 5.1: the axes of one solution, and where the machine stands at two points of the
/// plane.
struct Solution {
  Angles deg;
  Point at_origin;
  Point at_second;
};

struct Plane {
  const char* name;
  AxisChainSetup machine;
  Point work_offset;
  Point before;
  Eigen::Matrix3d tilt;
  Point after;
  std::vector<Solution> solutions;
};

const Point kG54K1(40, -25, -380);
const Point kG54K2(230, -120, -420);
const Point kG54K3(30, 40, -350);
const Point kG54Head(300, 100, -500);
const Point kG54K6(20, -30, -380);
const Point kNone = Point::Zero();

std::vector<Plane> planes_on_k1() {
  return {
      {"1",
       k1(),
       kG54K1,
       {10, 20, 5},
       xyz(30, 0, 0),
       kNone,
       {{{-30, 180}, {-40, -35.686533, -275.548095}, {-55, -25.686533, -273.548095}},
        {{30, 0}, {50, 35.849365, -252.548095}, {65, 25.849365, -250.548095}}}},
      {"2",
       k1(),
       kG54K1,
       {60, -40, -3},
       zyx(35, 0, -25),
       kNone,
       {{{-25, 35}, {47.257705, -124.574038, -323.489661}, {62.257705, -134.574038, -321.489661}},
        {{25, -145},
         {-37.257705, 122.883880, -304.049221},
         {-52.257705, 132.883880, -302.049221}}}},
      {"3",
       k1(),
       kG54K1,
       {10, 20, 5},
       xyz(20, -15, 40),
       {3, 4, -1},
       {{{-24.814217, 141.923749},
         {-28.541239, -60.023455, -283.563200},
         {-41.995893, -72.022301, -281.563200}},
        {{24.814217, -38.076251},
         {38.541239, 58.270480, -264.258044},
         {51.995893, 70.269326, -262.258044}}}},
      {"4",
       k1(),
       kG54K1,
       kNone,
       zyx(50, 35, 0),
       kNone,
       {{{-35, -40}, {45.952883, -34.367071, -282.614012}, {55.952883, -19.367071, -280.614012}},
        {{35, 140}, {-35.952883, 36.686077, -256.229496}, {-45.952883, 21.686077, -254.229496}}}},
      {"5",
       k1(),
       kG54K1,
       kNone,
       *by_projection_angles({20, -15, 10}, kZ),
       kNone,
       {{{-24.321237, 143.640081},
         {-36.228630, -32.552382, -276.934264},
         {-53.622069, -37.292455, -274.934264}},
        {{24.321237, -36.359919},
         {46.228630, 30.634851, -257.989065},
         {63.622069, 35.374924, -255.989065}}}},
  };
}

std::vector<Plane> planes_on_others() {
  const Eigen::Matrix3d tilt = zyx(35, 0, -25);
  const Point before(12, -7, 4);
  return {
      {"7",
       k2(),
       kG54K2,
       kNone,
       xyz(10, 0, 0),
       kNone,
       {{{-10, 90}, {177.753624, -180, -302.821192}, {167.558250, -195, -302.588059}},
        {{10, -90}, {221.942531, -120, -306.294156}, {232.137905, -105, -306.061022}}}},
      {"8",
       k2(),
       kG54K2,
       before,
       tilt,
       kNone,
       {{{-25, -55}, {77.527313, -102.403356, -319.881481}, {85.745154, -87.403356, -313.842683}},
        {{25, 125},
         {320.598843, -197.596644, -328.333847},
         {312.381002, -212.596644, -322.295048}}}},
      {"9",
       k3(),
       kG54K3,
       before,
       tilt,
       kNone,
       {{{-35.647727, -42.191412},
         {-96.131074, 76.548989, -249.891514},
         {-84.792305, 89.353880, -243.852716}},
        {{35.647727, 112.191412},
         {119.778095, -27.461595, -249.891514},
         {115.090165, -43.910188, -243.852716}}}},
  };
}

std::vector<Plane> planes_under_heads() {
  const Eigen::Matrix3d tilt = zyx(35, 0, -25);
  const Point before(12, -7, 4);
  return {
      {"10",
       k4(),
       kG54Head,
       before,
       tilt,
       kNone,
       {{{-145, 25}, {232.880481, 200.994383, -411.236299}, {249.881322, 202.866368, -405.197500}},
        {{35, -25}, {226.284883, 210.413874, -404.474406}, {243.285723, 212.285859, -398.435608}}}},
      {"11",
       k5(),
       kG54Head,
       before,
       tilt,
       kNone,
       {{{-42.191412, -35.647727},
         {252.333040, 181.713566, -400.359975},
         {269.333881, 183.585551, -394.321177}},
        {{112.191412, 35.647727},
         {244.345356, 176.120529, -400.359975},
         {261.346197, 177.992514, -394.321177}}}},
      {"12",
       k6(),
       kG54K6,
       before,
       tilt,
       kNone,
       {{{-35.647727, -42.191412},
         {37.766262, 18.493878, -263.097257},
         {44.192003, 35.337567, -261.097257}},
        {{35.647727, 112.191412},
         {-64.689870, 34.799734, -304.307445},
         {-77.766452, 22.389939, -302.307445}}}},
  };
}

AxisPositions at(const OrientationAxes& axes, const Angles& deg) {
  AxisPositions q = AxisPositions::Zero();
  for (std::size_t i = 0; i < axes.count(); ++i) {
    q[axes.axes().at(i)] = deg.at(i);
  }
  return q;
}

/// Pairs by the value of axis 1, the lower first.
std::vector<RotaryPair> in_order(const RotaryPairs& pairs) {
  std::vector<RotaryPair> sorted(pairs.begin(), pairs.end());
  std::ranges::sort(sorted, {}, [](const RotaryPair& pair) { return pair.deg[0]; });
  return sorted;
}

void expect_plane(const Plane& plane) {
  SCOPED_TRACE(plane.name);
  const auto axes = OrientationAxes::of(plane.machine);
  ASSERT_TRUE(axes);
  const std::vector<RotaryPair> pairs = in_order(axes->pairs_for(plane.tilt.col(2)));
  ASSERT_EQ(pairs.size(), 2U);
  const AxisChain machine(plane.machine, kTool);
  const Point second(15, -10, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Solution& solution = plane.solutions[i];
    EXPECT_NEAR(pairs[i].deg[0], solution.deg[0], 6e-7);
    EXPECT_NEAR(pairs[i].deg[1], solution.deg[1], 6e-7);
    const AxisPositions turned = at(*axes, pairs[i].deg);
    const auto place = [&](const Point& v) -> Point {
      const Point p = plane.work_offset + plane.before + plane.tilt * (plane.after + v);
      return linear_axes(machine.axes_for(p, turned).value());
    };
    EXPECT_LT((place(kNone) - solution.at_origin).cwiseAbs().maxCoeff(), 6e-7);
    EXPECT_LT((place(second) - solution.at_second).cwiseAbs().maxCoeff(), 6e-7);
    EXPECT_LT((axes->turn(pairs[i].deg) - machine.for_part(turned).tilt.toRotationMatrix()).norm(),
              1e-14);
  }
}

TEST(Orientation, BothSolutionsAndTheirPlacesAreThoseOfTheSpecification) {
  for (const Plane& plane : planes_on_k1()) {
    expect_plane(plane);
  }
  for (const Plane& plane : planes_on_others()) {
    expect_plane(plane);
  }
  for (const Plane& plane : planes_under_heads()) {
    expect_plane(plane);
  }
}

TEST(Orientation, DirectPositionsCarryThePlaneAlong) {
  const auto table = *OrientationAxes::of(k1());
  const Eigen::Matrix3d tilt = table.turn({-40, 25});
  const Eigen::Matrix3d expected = (Eigen::Matrix3d() << 0.906308, -0.323744, -0.271654, 0.422618,
                                    0.694272, 0.582563, 0, -0.642788, 0.766044)
                                       .finished();
  EXPECT_LT((tilt - expected).cwiseAbs().maxCoeff(), 6e-7);
  const AxisChain machine(k1(), kTool);
  const auto place = [&](const Point& v) -> Point {
    return linear_axes(machine.axes_for(kG54K1 + tilt * v, axes(0, 0, 0, -40, 0, 25)).value());
  };
  EXPECT_LT((place(kNone) - Point(27.423171, -69.219193, -313.485282)).cwiseAbs().maxCoeff(), 6e-7);
  EXPECT_LT((place({15, -10, 2}) - Point(42.423171, -79.219193, -311.485282)).cwiseAbs().maxCoeff(),
            6e-7);
  const auto mixed = *OrientationAxes::of(k2());
  const Eigen::Matrix3d both = mixed.turn({30, 25});
  EXPECT_LT((both.col(0) - Point(0.784886, 0.365998, -0.5)).cwiseAbs().maxCoeff(), 6e-7);
  EXPECT_LT((both.col(2) - Point(0.453154, 0.211309, 0.866025)).cwiseAbs().maxCoeff(), 6e-7);
  const AxisChain swung(k2(), kTool);
  const AxisPositions turned = axes(0, 0, 0, 0, 30, 25);
  EXPECT_LT((linear_axes(swung.axes_for(kG54K2, turned).value()) -
             Point(388.528036, -135.489314, -345.192379))
                .cwiseAbs()
                .maxCoeff(),
            6e-7);
  EXPECT_LT((linear_axes(swung.axes_for(kG54K2 + both * Point(15, -10, 2), turned).value()) -
             Point(402.518417, -145.489314, -350.960328))
                .cwiseAbs()
                .maxCoeff(),
            6e-7);
}

/// Axis 1 and 2 of the lower and of the higher solution for a plane on K1.
struct OnTable {
  Point z;
  Angles lower;
  Angles higher;
};

TEST(Orientation, NormalsOfEveryWayToSayAPlaneHaveTheirTwoSolutions) {
  const std::vector<OnTable> rows = {
      {{-0.258819, -0.330366, 0.907673}, {-24.814217, 141.923749}, {24.814217, -38.076251}},
      {{0.620885, -0.418335, 0.662946}, {-48.475067, -123.970999}, {48.475067, 56.029001}},
      {{0.330366, 0.258819, 0.907673}, {-24.814217, -51.923749}, {24.814217, 128.076251}},
      {{0.105670, -0.620885, 0.776747}, {-39.036334, -170.341232}, {39.036334, 9.658768}},
      {{0.536212, 0.406156, 0.739942}, {-42.273515, -52.857699}, {42.273515, 127.142301}},
      {{0.033536, -0.671834, 0.739942}, {-42.273515, -177.142301}, {42.273515, 2.857699}},
      {{0.368688, 0.439385, 0.819152}, {-35, -40}, {35, 140}},
      {{-0.244169, -0.331668, 0.911251}, {-24.321237, 143.640081}, {24.321237, -36.359919}},
      {{-0.242404, 0.346189, 0.906308}, {-25, 35}, {25, -145}},
      {{0.033536, -0.418335, 0.907673}, {-24.814217, -175.416613}, {24.814217, 4.583387}},
      {{0.379635, -0.310610, 0.871435}, {-29.374205, -129.289407}, {29.374205, 50.710593}},
      {{0.144005, -0.240008, 0.960031}, {-16.253917, -149.036243}, {16.253917, 30.963757}},
      {{-0.099601, 0.142244, 0.984808}, {-10, 35}, {10, -145}},
  };
  const auto axes = *OrientationAxes::of(k1());
  for (const OnTable& row : rows) {
    const std::vector<RotaryPair> pairs = in_order(axes.pairs_for(row.z));
    ASSERT_EQ(pairs.size(), 2U);
    // The normals are printed to six places; 10 degrees from the pole that is 2e-4 degrees of C.
    const double printed = 2.5e-4;
    EXPECT_NEAR(pairs[0].deg[0], row.lower[0], printed);
    EXPECT_NEAR(pairs[0].deg[1], row.lower[1], printed);
    EXPECT_NEAR(pairs[1].deg[0], row.higher[0], printed);
    EXPECT_NEAR(pairs[1].deg[1], row.higher[1], printed);
  }
}

TEST(Orientation, PolesFreeTheOuterAxis) {
  const auto axes = *OrientationAxes::of(k1());
  const RotaryPairs pairs = axes.pairs_for(xyz(0, 0, 30).col(2));
  ASSERT_EQ(pairs.count, 1U);
  EXPECT_EQ(pairs.all[0].deg, (Angles{0, 0}));
  EXPECT_EQ(pairs.all[0].is_free, (std::array{false, true}));
  const AxisChain machine(k1(), kTool);
  const auto place = [&](const Point& v) -> Point {
    return linear_axes(machine.axes_for(kG54K1 + xyz(0, 0, 30) * v, AxisPositions::Zero()).value());
  };
  EXPECT_LT((place(kNone) - Point(40, -25, -260)).norm(), 1e-9);
  EXPECT_LT((place({15, -10, 2}) - Point(57.990381, -26.160254, -258)).cwiseAbs().maxCoeff(), 6e-7);

  const auto nutating = *OrientationAxes::of(k5());
  const RotaryPairs upright = nutating.pairs_for({0, 0, 1});
  ASSERT_EQ(upright.count, 1U);
  EXPECT_EQ(upright.all[0].is_free, (std::array{true, false}));
  const RotaryPairs level = nutating.pairs_for({0.6, 0.8, 0});
  ASSERT_EQ(level.count, 1U) << "as far as the inclined axis leads";
  EXPECT_NEAR(std::abs(level.all[0].deg[1]), 180.0, 1e-6);
  EXPECT_FALSE(level.all[0].is_free[0]);
}

TEST(Orientation, WhatIsOutOfTravelOrReachHasNoSolution) {
  const auto table = *OrientationAxes::of(k1());
  const std::array<RotaryTravel, 2> tilting = {RotaryTravel{-120, 120}, RotaryTravel{}};
  const RotaryPairs steep = table.pairs_for(xyz(170, 0, 0).col(2));
  ASSERT_EQ(steep.count, 2U);
  EXPECT_NEAR(in_order(steep)[0].deg[0], -170, 1e-9);
  EXPECT_NEAR(in_order(steep)[1].deg[0], 170, 1e-9);
  EXPECT_FALSE(least_motion(steep, {0, 0}, tilting, 0));
  const auto head = *OrientationAxes::of(k2());
  EXPECT_FALSE(least_motion(head.pairs_for(xyz(120, 0, 0).col(2)), {0, 0},
                            {RotaryTravel{-95, 110}, RotaryTravel{}}, 0));
  const auto half = *OrientationAxes::of(k3());
  EXPECT_EQ(half.pairs_for(xyz(100, 0, 0).col(2)).count, 0U);
  EXPECT_EQ(half.pairs_for(xyz(90, 0, 0).col(2)).count, 1U);
  const auto inclined = *OrientationAxes::of(k6());
  const auto within = least_motion(inclined.pairs_for(zyx(35, 0, -25).col(2)), {0, 0},
                                   {RotaryTravel{0, 180}, RotaryTravel{}}, 0);
  ASSERT_TRUE(within);
  EXPECT_NEAR(within->deg[0], 35.647727, 6e-7);
  EXPECT_NEAR(within->deg[1], 112.191412, 6e-7);
}

/// Rows of table 5.3: from where the axes stand to the chosen solution.
void expect_choice(const AxisChainSetup& machine, std::size_t first,
                   const std::array<RotaryTravel, 2>& travel, const Angles& from,
                   const Angles& to) {
  const auto axes = *OrientationAxes::of(machine);
  const auto chosen = least_motion(axes.pairs_for(zyx(35, 0, -25).col(2)), from, travel, first);
  ASSERT_TRUE(chosen);
  EXPECT_NEAR(within_half_turn(chosen->deg[0]), to[0], 1e-9) << from[0] << ' ' << from[1];
  EXPECT_NEAR(within_half_turn(chosen->deg[1]), to[1], 1e-9) << from[0] << ' ' << from[1];
}

TEST(Orientation, TheLeastMotionIsChosenAsTheSpecificationDoes) {
  const std::array<RotaryTravel, 2> table = {RotaryTravel{-120, 120}, RotaryTravel{}};
  expect_choice(k1(), 0, table, {0, 0}, {-25, 35});
  expect_choice(k1(), 0, table, {10, -100}, {25, -145});
  expect_choice(k1(), 0, table, {0, -80}, {25, -145});
  expect_choice(k1(), 0, table, {0, -55}, {-25, 35});
  expect_choice(k1(), 0, table, {-30, 200}, {-25, 35});
  const std::array<RotaryTravel, 2> mixed = {RotaryTravel{-95, 110}, RotaryTravel{}};
  expect_choice(k2(), 1, mixed, {0, 0}, {-25, -55});
  expect_choice(k2(), 1, mixed, {40, 0}, {-25, -55});
  expect_choice(k2(), 1, mixed, {100, 30}, {-25, -55});
}

TEST(Orientation, TurnsByWholeTurnsWithinTheTravel) {
  EXPECT_EQ(turn_within(35, 200, {}), 35.0) << "165 against 195";
  EXPECT_EQ(turn_within(35, 220, {}), 395.0);
  EXPECT_EQ(turn_within(35, 220, RotaryTravel{-180, 360}), 35.0);
  EXPECT_EQ(turn_within(-35, 0, RotaryTravel{0, 330}), 325.0);
  EXPECT_EQ(turn_within(-35, 0, RotaryTravel{0, 180}), std::nullopt);
  EXPECT_EQ(turn_within(180, 0, RotaryTravel{-180, 170}), -180.0);
  EXPECT_EQ(turn_within(-175, 179, {}), 185.0);
  EXPECT_EQ(turn_within(-120.0000000001, 0, RotaryTravel{-120, 120}), -120.0) << "rounding alone";
  EXPECT_EQ(on_tooth(23.0, 1.0, 5.0), 21.0);
  EXPECT_EQ(on_tooth(23.75, 1.0, 5.0), 26.0);
  EXPECT_EQ(on_tooth(-8.0, 0.0, 2.5), -7.5);
  EXPECT_EQ(on_tooth(23.25, 1.0, 0.0), 23.25);
}

TEST(Orientation, OneAxisReachesItsCircleAlone) {
  const auto head = *OrientationAxes::of(chain("", "XYZB"));
  EXPECT_EQ(head.type(), KinematicType::Tool);
  EXPECT_EQ(head.count(), 1U);
  EXPECT_NEAR(head.pairs_for({1, 0, 1}).all[0].deg[0], 45.0, 1e-12);
  EXPECT_EQ(head.pairs_for({1, 0.01, 1}).count, 0U);
  const auto table = *OrientationAxes::of(chain("C", "XYZ"));
  EXPECT_TRUE(table.pairs_for({0, 0, 2}).all[0].is_free[0]);
  EXPECT_EQ(table.pairs_for({0, 0.01, 2}).count, 0U);
  // A table C under a table A turns the part about the tool: no direction asks for it.
  const auto lying = *OrientationAxes::of(chain("AC", "XYZ"));
  const RotaryPairs pairs = lying.pairs_for({0, -1, 1});
  ASSERT_EQ(pairs.count, 1U);
  EXPECT_EQ(lying.axes(), (std::array{axis_index('C'), axis_index('A')}));
  EXPECT_EQ(pairs.all[0].is_free, (std::array{true, false}));
  EXPECT_NEAR(pairs.all[0].deg[1], 45.0, 1e-12);

  EXPECT_FALSE(OrientationAxes::of(chain("", "XYZ")));
  EXPECT_FALSE(OrientationAxes::of(chain("CAB", "XYZ")));
  AxisChainSetup parallel = chain("C", "XYZB");
  parallel.rotary[1].axis_M = {0, 0, -3};
  EXPECT_FALSE(OrientationAxes::of(parallel));
}

using Exact3 = Eigen::Matrix<long double, 3, 1>;

/// Rodrigues' formula in long double.
Exact3 exact_turn(const Point& axis, double deg, const Exact3& p) {
  const Exact3 u = axis.cast<long double>().normalized();
  const long double r = static_cast<long double>(deg) * std::numbers::pi_v<long double> / 180.0L;
  return p * std::cos(r) + u.cross(p) * std::sin(r) + u * (u.dot(p) * (1.0L - std::cos(r)));
}

TEST(Orientation, EverySolutionOfRandomMachinesLeadsToTheDirection) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 1}, n++) - 1.0); };
  const std::vector<std::pair<const char*, const char*>> sides = {
      {"CA", "XYZ"}, {"BA", "XYZ"}, {"C", "XYZB"}, {"A", "XYZC"}, {"", "XYZCA"}, {"", "XYZBC"}};
  long double worst = 0.0L;
  int found = 0;
  for (int i = 0; i < 12000; ++i) {
    const auto& [table, tool] = sides[static_cast<std::size_t>(i) % sides.size()];
    AxisChainSetup setup = chain(table, tool);
    for (RotaryLine& line : setup.rotary) {
      line.axis_M += Point(random(0.8), random(0.8), random(0.8));
    }
    const auto orienting = OrientationAxes::of(setup);
    if (!orienting) {
      continue;
    }
    const Point s = i % 3 == 0 ? Point(random(1), random(1), random(1)) : Point(0, 0, 1);
    const Angles asked = {random(180), random(180)};
    const Point d = orienting->turn(asked) * s;
    const RotaryPairs pairs = orienting->pairs_for(d, s);
    ASSERT_GE(pairs.count, 1U) << i;
    double nearest = 1e9;
    for (const RotaryPair& pair : pairs) {
      ++found;
      Exact3 t = s.cast<long double>();
      const std::string letters = std::string(table) + tool;
      for (auto letter = letters.rbegin(); letter != letters.rend(); ++letter) {
        const int axis = axis_index(*letter);
        if (is_rotary_axis(axis)) {
          const bool is_first = axis == orienting->axes()[0];
          t = exact_turn(setup.rotary.at(static_cast<std::size_t>(axis - kLinearAxisCount)).axis_M,
                         pair.deg.at(is_first ? 0 : 1), t);
        }
      }
      worst = std::max(worst, (t.normalized() - d.cast<long double>().normalized()).norm());
      nearest = std::min(nearest, std::abs(within_half_turn(pair.deg[0] - asked[0])) +
                                      std::abs(within_half_turn(pair.deg[1] - asked[1])));
    }
    EXPECT_LT(nearest, 1e-3) << "one of the solutions is where the direction came from, " << i;
  }
  EXPECT_GT(found, 20000);
  EXPECT_LT(worst, 1e-13L);
  std::printf("worst direction %.3Lg\n", worst);
}

}  // namespace
}  // namespace g31::machine::orientation_test
