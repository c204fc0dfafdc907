// Every shape of shapes.def: closed, turned outwards, of the volume of its formula and where its
// row says it stands.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/artefacts/polygon.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::shapes_test {
namespace {

constexpr double kPi = std::numbers::pi;

Mesh made(const std::string& shape, const std::map<std::string, double>& sizes) {
  PartSetup setup;
  setup.name = "gauge";
  setup.shape = shape;
  setup.sizes = sizes;
  const auto mesh = make_artefact(setup);
  EXPECT_TRUE(mesh.ok()) << mesh.error();
  return mesh.value();
}

struct Case {
  const char* shape;
  std::map<std::string, double> sizes;
  double volume;   ///< mm^3 of the true shape
  double surface;  ///< mm^2 of its round faces: what the facets stand off times this is the error
  double sagitta;
  Point low;
  Point high;
};

/// The rounding of a pocket takes this area from each of its corners.
double corner_area(double radius) {
  return (1.0 - kPi / 4.0) * radius * radius;
}

std::vector<Case> round_cases() {
  return {
      {"ring",
       {},
       kPi / 4 * 20 * (79.996 * 79.996 - 39.996 * 39.996),
       120 * kPi * 20,
       5e-5,
       {-39.998, -39.998, -20},
       {39.998, 39.998, 0}},
      {"plug",
       {},
       kPi * (15.0 * 15 * 20 + 25.0 * 25 * 10),
       kPi * (30 * 20 + 50 * 10),
       5e-5,
       {-25, -25, -30},
       {25, 25, 0}},
      {"plug",
       {{"diameter", 9.0}, {"height", 5.0}, {"foot_diameter", 12.0}, {"sagitta", 0.01}},
       kPi * (4.5 * 4.5 * 5 + 36.0 * 10),
       kPi * (9 * 5 + 12 * 10),
       0.01,
       {-6, -6, -15},
       {6, 6, 0}},
      {"shaft", {}, kPi * 625 * 400, kPi * 50 * 400, 5e-5, {-25, -25, -400}, {25, 25, 0}},
      {"sphere",
       {},
       kPi / 6 * 25 * 25 * 25,
       kPi * 25 * 25,
       1e-3,
       {-12.5, -12.5, -12.5},
       {12.5, 12.5, 12.5}},
      {"sphere",
       {{"diameter", 40.0}, {"sagitta", 0.1}},
       kPi / 6 * 64000,
       kPi * 1600,
       0.1,
       {-20, -20, -20},
       {20, 20, 20}},
      {"sphere",
       {{"diameter", 2.0}, {"sagitta", 100.0}},
       kPi / 6 * 8,
       kPi * 4,
       100.0,
       {-1, -1, -1},
       {1, 1, 1}},
      {"cylinder", {}, kPi * 225 * 20, kPi * 30 * 20, 5e-5, {-15, -15, -20}, {15, 15, 0}},
  };
}

std::vector<Case> flat_cases() {
  const double hexagon = 6.0 * 15.0 * 15.0 * std::tan(kPi / 6.0);
  const double apex = 15.0 / std::cos(kPi / 6.0);
  const double pocket = 80.0 * 60.0 * 25.0 - 60.0 * 40.0 * 15.0;
  return {
      {"prism", {}, hexagon * 20, 0, 0, {-15, -apex, -20}, {15, apex, 0}},
      {"prism",
       {{"sides", 3.0}, {"across_flats", 10.0}, {"height", 2.0}},
       3 * 25 * std::tan(kPi / 3) * 2,
       0,
       0,
       {-10, -5 * std::tan(kPi / 3), -2},
       {5, 5 * std::tan(kPi / 3), 0}},
      {"prism",
       {{"sides", 4.0}, {"across_flats", 10.0}, {"height", 1.0}},
       100,
       0,
       0,
       {-5, -5, -1},
       {5, 5, 0}},
      {"block", {}, 60.0 * 40 * 20, 0, 0, {-30, -20, -20}, {30, 20, 0}},
      {"gauge_block", {}, 50.0 * 35 * 9, 0, 0, {0, -17.5, -9}, {50, 17.5, 0}},
      {"gauge_block", {{"length", 10.0}}, 10.0 * 30 * 9, 0, 0, {0, -15, -9}, {10, 15, 0}},
      {"pocket", {}, pocket, 0, 0, {-40, -30, -25}, {40, 30, 0}},
      {"pocket",
       {{"corner_radius", 8.0}},
       pocket + 4 * corner_area(8) * 15,
       2 * kPi * 8 * 15,
       5e-5,
       {-40, -30, -25},
       {40, 30, 0}},
      {"pocket",
       {{"corner_radius", 20.0}, {"sagitta", 0.5}},
       pocket + 4 * corner_area(20) * 15,
       2 * kPi * 20 * 15,
       0.5,
       {-40, -30, -25},
       {40, 30, 0}},
      {"groove", {}, 60.0 * (60 * 25 - 20 * 15), 0, 0, {-30, -30, -25}, {30, 30, 0}},
      {"rib", {}, 60.0 * (20 * 15 + 60 * 10), 0, 0, {-30, -30, -25}, {30, 30, 0}},
      {"step", {}, 40.0 * (60 * 10 + 30 * 15), 0, 0, {-30, -20, -25}, {30, 20, 0}},
      {"bed", {}, 1000.0 * 100 * 100, 0, 0, {0, -50, -100}, {1000, 50, 0}},
  };
}

std::vector<Case> cases() {
  std::vector<Case> all = round_cases();
  const std::vector<Case> flat = flat_cases();
  all.insert(all.end(), flat.begin(), flat.end());
  return all;
}

TEST(Shapes, AreClosedSolidsOfTheRightVolume) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.shape);
    const Mesh mesh = made(c.shape, c.sizes);
    EXPECT_TRUE(testing::is_closed_and_oriented(mesh));
    // Facets are tangent, so the material can only be too much outside and too little in a hole.
    EXPECT_NEAR(testing::enclosed_volume(mesh), c.volume, c.surface * c.sagitta + 1e-9 * c.volume);
  }
}

TEST(Shapes, StandWhereTheirRowSays) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.shape);
    const Mesh mesh = made(c.shape, c.sizes);
    Point low = mesh.vertices[0];
    Point high = low;
    for (const Point& p : mesh.vertices) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    EXPECT_LT((low - c.low).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((high - c.high).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Shapes, AllRowsAreTried) {
  const std::vector<Case> tried = cases();
  for (const Shape& shape : shapes()) {
    EXPECT_TRUE(std::ranges::any_of(tried, [&](const Case& c) { return shape.name == c.shape; }))
        << shape.name;
  }
}

TEST(Shapes, CornersOfASphereStandOffByTheSagittaAtMost) {
  for (const double sagitta : {1e-3, 0.02, 1.0}) {
    SCOPED_TRACE(sagitta);
    double farthest = 0.0;
    for (const Point& p : made("sphere", {{"diameter", 30.0}, {"sagitta", sagitta}}).vertices) {
      EXPECT_GE(p.norm(), 15.0);
      farthest = std::max(farthest, p.norm() - 15.0);
    }
    EXPECT_LE(farthest, sagitta * (1.0 + 1e-9));
    EXPECT_GE(farthest, 0.5 * sagitta) << "no more facets than it takes";
  }
}

TEST(Shapes, FacetsOfASphereAreTangentToIt) {
  const Mesh mesh = made("sphere", {{"diameter", 30.0}, {"sagitta", 0.02}});
  for (const auto& t : mesh.triangles) {
    const Point& a = mesh.vertices[t[0]];
    const Point normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
    ASSERT_NEAR(normal.dot(a), 15.0, 1e-10);
  }
}

TEST(TangentPolygon, TouchesItsCircleWithEverySide) {
  for (const std::size_t sides : {3U, 4U, 5U, 6U, 7U, 8U, 12U, 100U, 1001U}) {
    SCOPED_TRACE(sides);
    const auto corners = tangent_polygon(10.0, sides);
    ASSERT_EQ(corners.size(), sides);
    for (std::size_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * kPi * static_cast<double>(i + 1) / static_cast<double>(sides);
      const Point2 middle = 0.5 * (corners[i] + corners[(i + 1) % sides]);
      EXPECT_NEAR(middle.x(), 10.0 * std::cos(angle), 1e-12);
      EXPECT_NEAR(middle.y(), 10.0 * std::sin(angle), 1e-12);
    }
    EXPECT_EQ(corners.front().x(), 10.0) << "the side on +X is exactly at the radius";
    EXPECT_EQ(corners.front().y(), -corners.back().y());
  }
}

struct WrongCase {
  const char* name;
  const char* shape;
  std::map<std::string, double> sizes;
  const char* error;
};
const WrongCase kWrongCases[] = {
    {"a foot as thin as the pin",
     "plug",
     {{"foot_diameter", 30.0}},
     "part 'gauge': the foot_diameter of a plug must be larger than its diameter"},
    {"half a side",
     "prism",
     {{"sides", 5.5}},
     "part 'gauge': the sides of a prism must be a whole number from 3 to 1000"},
    {"two sides",
     "prism",
     {{"sides", 2.0}},
     "part 'gauge': the sides of a prism must be a whole number from 3 to 1000"},
    {"too many sides",
     "prism",
     {{"sides", 1001.0}},
     "part 'gauge': the sides of a prism must be a whole number from 3 to 1000"},
    {"corners rounder than the pocket",
     "pocket",
     {{"corner_radius", 20.001}},
     "part 'gauge': the corner_radius of a pocket must be at most half of its length and its "
     "width"},
    {"a sphere too fine",
     "sphere",
     {{"sagitta", 1e-5}},
     "part 'gauge': the sagitta of the sphere is too small: it would take more than 500000 "
     "facets"},
    {"a cylinder too fine",
     "cylinder",
     {{"sagitta", 1e-12}},
     "part 'gauge': the sagitta of the cylinder is too small: it would take more than 100000 "
     "facets"},
    {"a plug too fine",
     "plug",
     {{"sagitta", 1e-30}},
     "part 'gauge': the sagitta of the plug is too small: it would take more than 100000 "
     "facets"},
    {"a pocket too fine",
     "pocket",
     {{"corner_radius", 5.0}, {"sagitta", 1e-12}},
     "part 'gauge': the sagitta of the pocket is too small: it would take more than 100000 "
     "facets"},
};

TEST(Shapes, SayWhichSizesDoNotFit) {
  for (const WrongCase& c : kWrongCases) {
    SCOPED_TRACE(c.name);
    PartSetup setup;
    setup.name = "gauge";
    setup.shape = c.shape;
    setup.sizes = c.sizes;
    const auto refused = make_artefact(setup);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error(), c.error);
  }
}

PartSetup profiled(const char* shape, const ShapeProfile& profile) {
  PartSetup setup;
  setup.name = "gauge";
  setup.shape = shape;
  setup.profile = profile;
  return setup;
}

/// Up to 200 as at 200, straight to 600, from there on as there.
const ShapeProfile kBend = {{200.0, 0.5}, {600.0, -0.3}};

TEST(Shapes, ABedIsAsHighAsItsProfile) {
  const auto mesh = make_artefact(profiled("bed", kBend));
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_TRUE(testing::is_closed_and_oriented(mesh.value()));
  const double added = 200 * 0.5 + 400 * 0.1 + 400 * -0.3;  // mm^2 along X
  EXPECT_NEAR(testing::enclosed_volume(mesh.value()), 100.0 * (1000.0 * 100.0 + added), 1e-6);
  for (const Point& p : mesh.value().vertices) {
    const double top = p.x() <= 200.0 ? 0.5 : -0.3;  // vertices stand at 0, 200, 600 and 1000
    EXPECT_TRUE(p.z() == -100.0 || p.z() == top) << p.transpose();
  }
}

TEST(Shapes, AShaftIsAsThickAsItsProfile) {
  PartSetup setup = profiled("shaft", {{100.0, 2.0}, {300.0, -1.0}});
  setup.sizes = {{"sagitta", 1e-4}};
  const auto mesh = make_artefact(setup);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_TRUE(testing::is_closed_and_oriented(mesh.value()));
  const double cone = 200.0 / 3.0 * (27.0 * 27 + 27.0 * 24 + 24.0 * 24);  // of pi
  const double volume = kPi * (100.0 * 27 * 27 + cone + 100.0 * 24 * 24);
  EXPECT_NEAR(testing::enclosed_volume(mesh.value()), volume, 2.0 * kPi * 27 * 400 * 1e-4);
  for (const Point& p : mesh.value().vertices) {
    const double radius = p.head<2>().norm();
    const double nominal = p.z() >= -100.0 ? 27.0 : 24.0;
    EXPECT_TRUE(radius == 0.0 || (radius >= nominal && radius <= nominal + 1e-4)) << p.transpose();
  }
}

TEST(Shapes, EndAtAKilometre) {
  PartSetup setup = profiled("block", {});
  setup.sizes = {{"height", 1e300}};
  EXPECT_EQ(make_artefact(setup).error(), "part 'gauge': size 'height' must be at most 1000000 mm");
  setup.sizes = {{"height", kLargestSizeMm}};
  EXPECT_TRUE(make_artefact(setup).ok());
}

TEST(Shapes, SayWhichProfileDoesNotFit) {
  const auto refused = [](const PartSetup& setup) { return make_artefact(setup).error(); };
  EXPECT_EQ(refused(profiled("bed", {{0.0, 0.0}, {1000.5, 0.0}})),
            "part 'gauge': the places of a profile must lie between 0 and the end of the shape");
  EXPECT_EQ(refused(profiled("bed", {{-0.5, 0.0}, {10.0, 0.0}})),
            "part 'gauge': the places of a profile must lie between 0 and the end of the shape");
  EXPECT_EQ(
      refused(profiled("shaft", {{0.0, -25.0}})),
      "part 'gauge': the deviations of a profile must be smaller than the thickness of the shape");
  EXPECT_EQ(refused(profiled("ring", {{0.0, 0.1}})),
            "part 'gauge': shape 'ring' takes no profile; bed and shaft do");
}

}  // namespace
}  // namespace g31::parts::shapes_test
