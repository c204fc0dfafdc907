// Sections of a probe against meshes: closed forms, FCL as a second witness, and thin walls on long
// ways that steps would jump over.  Compile without AVX, as the packaged FCL was.

#include "probe/collision/collision_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <gtest/gtest.h>

#include "tests/probe/fcl_witness.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::collision_mesh_test {
namespace {

using testing::between;
using testing::fcl_collides;
using testing::fcl_mesh;
using testing::kUpright;
using testing::point_between;

ProbeSection cylinder(double radius, double z_bottom, double z_top) {
  ProbeSection section;
  section.name = "stem";
  section.z_bottom = z_bottom;
  section.z_top = z_top;
  section.radius_bottom = radius;
  section.radius_top = radius;
  return section;
}

/// @param margin  mm
SweptSection swept(const ProbeSection& section, const Point& from, const Point& to,
                   double margin = 0.0) {
  return {&section, {from, kUpright}, {to, kUpright}, margin};
}

/// mm along the way, or none.
std::optional<double> way_to_touch(const CollisionMesh& mesh, const ProbeSection& section,
                                   const Point& from, const Point& to) {
  const auto touch = mesh.first_touch(swept(section, from, to));
  return touch ? std::optional(touch->fraction * (to - from).norm()) : std::nullopt;
}

TEST(CollisionMesh, StopsASectionWhereTheClosedFormSays) {
  // A box from the origin to (30, 20, 10); the section is 40 mm long with a radius of 2.
  const CollisionMesh box(testing::box_mesh({30.0, 20.0, 10.0}));
  const ProbeSection stem = cylinder(2.0, 5.0, 45.0);
  ProbeSection cone = stem;
  cone.radius_top = 10.0;  // 8 mm wider over 40 mm
  ProbeSection tip = stem;
  tip.radius_bottom = 0.0;
  ProbeSection capsule = cylinder(0.0, 5.0, 45.0);
  capsule.rounding = 2.0;
  struct Case {
    const char* name;
    const ProbeSection& section;
    Point from;
    Point to;
    std::optional<double> way;
  };
  const Case kCases[] = {
      {"side against a face", stem, {-20, 10, 0}, {60, 10, 0}, 18.0},
      {"face down onto the top", stem, {15, 10, 50}, {15, 10, -50}, 45.0},
      {"face down half over an edge", stem, {-1, 10, 50}, {-1, 10, -50}, 45.0},
      {"top of the section against the bottom of the box", stem, {15, 10, -80}, {15, 10, 20}, 35.0},
      {"beside the box", stem, {-2.001, -20, 0}, {-2.001, 60, 0}, std::nullopt},
      {"past an upright edge within reach",
       stem,
       {-1, -20, 0},
       {-1, 60, 0},
       20.0 - std::sqrt(4.0 - 1.0)},
      {"above the box", stem, {-20, 10, 5.001}, {60, 10, 5.001}, std::nullopt},
      // Flank and top edge: at z = 10 the radius is 2 + 8 * (10 + 5) / 40 for a bottom at -5.
      {"flank of a cone against the edge", cone, {-20, 10, -10}, {60, 10, -10}, 20.0 - 5.0},
      {"a tip onto the top", tip, {15, 10, 50}, {15, 10, -50}, 45.0},
      {"a capsule onto the top", capsule, {15, 10, 50}, {15, 10, -50}, 50.0 - 7.0},
      // Its lower ball, 2 mm about z = 5, beside an edge of the top at 1 mm distance sideways.
      {"a capsule onto an edge", capsule, {-1, 10, 50}, {-1, 10, -50}, 45.0 - std::sqrt(3.0)},
      {"no way, free", stem, {-2.5, 10, 0}, {-2.5, 10, 0}, std::nullopt},
      {"no way, in the wall", stem, {-1.5, 10, 0}, {-1.5, 10, 0}, 0.0},
      {"out of an overlap", stem, {-1.5, 10, 0}, {-60, 10, 0}, 0.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto way = way_to_touch(box, c.section, c.from, c.to);
    ASSERT_EQ(way.has_value(), c.way.has_value());
    if (way) {
      EXPECT_NEAR(*way, *c.way, 1e-6);
    }
  }
}

TEST(CollisionMesh, SaysWhereAndHowTheSurfaceStands) {
  const CollisionMesh box(testing::box_mesh({30.0, 20.0, 10.0}));
  const ProbeSection stem = cylinder(2.0, 5.0, 45.0);
  const auto side = box.first_touch(swept(stem, {-20, 10, 0}, {60, 10, 0}));
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->p_M_point.x(), 0.0, 1e-6);
  // A side along a face: nearest_pair() tells the place roughly.
  EXPECT_NEAR(side->p_M_point.y(), 10.0, 0.5);
  EXPECT_NEAR((side->n_M + Point::UnitX()).norm(), 0.0, 1e-6);
}

TEST(CollisionMesh, MeetsAThinWallOnAnyWay) {
  // A sheet without thickness, 2 mm wide, somewhere on ways of up to 2 m: every 1 mm step on them
  // would find it, and the touch must not lie behind the first step that does.
  std::mt19937_64 random(11);
  const ProbeSection stem = cylinder(1.0, 0.0, 30.0);
  for (int i = 0; i < 200; ++i) {
    const Point from = point_between(random, -1000.0, 1000.0);
    const Point to = point_between(random, -1000.0, 1000.0);
    const Point middle = from + between(random, 0.1, 0.9) * (to - from) + Point(0, 0, 15);
    const Point a = testing::any_direction(random);
    const Point b = a.cross(testing::any_direction(random)).normalized();
    parts::Mesh sheet;
    sheet.vertices = {middle - a - b, middle + a - b, middle + a + b, middle - a + b};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    const CollisionMesh wall(sheet);
    const auto way = way_to_touch(wall, stem, from, to);
    ASSERT_TRUE(way) << i;
    const Point direction = (to - from).normalized();
    // By brute force, 40 mm around it: free before, met at the step after.
    for (double s = *way - 40.0; s < *way - 1e-4; s += 0.25) {
      const Point at = from + std::max(0.0, s) * direction;
      ASSERT_FALSE(wall.first_touch(swept(stem, at, at))) << i << " at " << s - *way;
    }
    const Point in = from + (*way + 1e-4) * direction;
    EXPECT_TRUE(wall.first_touch(swept(stem, in, in)));
  }
}

/// How far behind the touch the witness agrees, mm.
template <typename Collides>
double first_behind(const SectionTouch& touch, const Point& way, Collides&& collides) {
  double behind = 2e-6;
  while (behind < 1.0 && !collides(Point((touch.fraction + behind / way.norm()) * way))) {
    behind *= 2.0;
  }
  return behind;
}

TEST(CollisionMesh, AgreesWithFcl) {
  constexpr double kFclErrorMm = 2e-6;
  constexpr double kLength = 30.0;
  struct Shape {
    ProbeSection section;
    std::shared_ptr<fcl::CollisionGeometryd> fcl;
  };
  ProbeSection cone = cylinder(6.0, 0.0, kLength);
  cone.radius_top = 0.0;
  ProbeSection capsule = cylinder(0.0, 3.0, kLength - 3.0);
  capsule.rounding = 3.0;
  const Shape kShapes[] = {
      {cylinder(1.8, 0.0, kLength), std::make_shared<fcl::Cylinderd>(1.8, kLength)},
      {cylinder(20.0, 0.0, kLength), std::make_shared<fcl::Cylinderd>(20.0, kLength)},
      {capsule, std::make_shared<fcl::Capsuled>(3.0, kLength - 6.0)},
      {cone, std::make_shared<fcl::Coned>(6.0, kLength)}};
  const parts::Mesh kMeshes[] = {testing::box_mesh({30.0, 20.0, 10.0}),
                                 testing::sphere_mesh(15.0, 16), testing::loose_triangles(9, 40)};
  std::mt19937_64 random(78);
  for (const parts::Mesh& mesh : kMeshes) {
    const CollisionMesh ours(mesh);
    const auto theirs = fcl_mesh(mesh);
    std::vector<double> behind;
    for (const Shape& shape : kShapes) {
      const Point to_middle(0.0, 0.0, 0.5 * kLength);
      for (int i = 0; i < 100; ++i) {
        const Point from = 120.0 * testing::any_direction(random);
        const Point to = point_between(random, -25.0, 25.0);
        const Point way = to - from;
        const auto touch = ours.first_touch(swept(shape.section, from, to));
        const double last = touch ? touch->fraction - kFclErrorMm / way.norm() : 1.0;
        for (const double share : {0.3, 0.6, 0.9, 0.99, 0.999, 1.0}) {
          const Point at = from + share * last * way + to_middle;
          EXPECT_FALSE(fcl_collides(theirs, shape.fcl, at)) << i << " at share " << share;
        }
        if (touch) {
          behind.push_back(first_behind(*touch, way, [&](const Point& moved) {
            return fcl_collides(theirs, shape.fcl, from + moved + to_middle);
          }));
        }
      }
    }
    EXPECT_GT(behind.size(), 100U);
    // Head-on FCL agrees at once; where the section goes in flat, it takes a little way.
    EXPECT_LE(*std::ranges::max_element(behind), 0.02);
    EXPECT_GE(std::ranges::count_if(behind, [](double mm) { return mm <= 1e-5; }),
              std::ssize(behind) * 9 / 10);
  }
}

TEST(CollisionMesh, AnEmptyMeshIsNeverTouched) {
  const ProbeSection stem = cylinder(1.0, 0.0, 40.0);
  EXPECT_FALSE(CollisionMesh(parts::Mesh()).first_touch(swept(stem, {0, 0, 0}, {9, 9, 9})));
}

}  // namespace
}  // namespace g31::probe::collision_mesh_test
