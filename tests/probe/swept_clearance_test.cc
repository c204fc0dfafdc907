// What planes part from a swept section, beside a look at every triangle by itself: random, grazing
// and touching.

#include "probe/collision/swept_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "probe/collision/collision_mesh.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/effort.h"

namespace g31::probe::swept_clearance_test {
namespace {

using testing::any_direction;
using testing::between;
using testing::kUpright;
using testing::point_between;

/// Stems, discs, cones and tips, some of them rounded.
ProbeSection any_shape(std::mt19937_64& random) {
  ProbeSection section;
  section.z_bottom = between(random, -5.0, 5.0);
  section.z_top = section.z_bottom + between(random, 0.0, 40.0);
  section.radius_bottom = random() % 4 == 0 ? 0.0 : between(random, 0.0, 20.0);
  section.radius_top = random() % 3 == 0 ? between(random, 0.0, 20.0) : section.radius_bottom;
  section.rounding = random() % 3 == 0 ? between(random, 0.0, 3.0) : 0.0;
  return section;
}

Eigen::Quaterniond any_turn(std::mt19937_64& random, double most_rad) {
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(between(random, 0.0, most_rad), any_direction(random)));
}

/// Long ways past the origin and into it, short ones, none; a third tilted, some turning.
SweptSection any_sweep(const ProbeSection& section, std::mt19937_64& random) {
  SweptSection swept;
  swept.section = &section;
  swept.from.turn = random() % 3 == 0 ? any_turn(random, 6.0) : kUpright;
  swept.to.turn = random() % 5 == 0 ? Eigen::Quaterniond(swept.from.turn * any_turn(random, 0.2))
                                    : swept.from.turn;
  swept.from.p_M = point_between(random, -100.0, 100.0);
  const std::array<double, 4> lengths = {0.0, 0.01, 10.0, 200.0};
  const double length = lengths[random() % lengths.size()];
  const Point towards = point_between(random, -30.0, 30.0) - swept.from.p_M;
  swept.to.p_M = swept.from.p_M + length * towards.normalized();
  return swept;
}

bool meets_any(const SweptSection& swept, const std::vector<ContactTriangle>& triangles) {
  return std::ranges::any_of(
      triangles, [&](const ContactTriangle& triangle) { return meets(swept, triangle); });
}

std::vector<ContactTriangle> triangles_of(const parts::Mesh& mesh) {
  std::vector<ContactTriangle> triangles;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }
  return triangles;
}

/// By how much the sweep may grow before it meets one of the triangles, mm, to within kSweptBandMm
/// below.
double gap_of(SweptSection swept, const std::vector<ContactTriangle>& triangles) {
  double apart = 0.0;
  double meeting = 500.0;
  for (int i = 0; i < 50; ++i) {
    swept.margin = 0.5 * (apart + meeting);
    (meets_any(swept, triangles) ? meeting : apart) = swept.margin;
  }
  return apart;
}

/// The fraction at which the sweep meets the first triangle, each looked at by itself; 1 if none.
double first_by_looking_at_all(const SweptSection& swept,
                               const std::vector<ContactTriangle>& triangles) {
  double free = 0.0;
  double met = 1.0;
  const double length = swept.longest_way();
  while ((met - free) * length > 1e-9) {
    const double middle = 0.5 * (free + met);
    (meets_any(swept.piece(0.0, middle), triangles) ? met : free) = middle;
  }
  return meets_any(swept.piece(0.0, 0.0), triangles) ? 0.0 : free;
}

TEST(SweptClearance, SaysClearOnlyOfWhatIsNotMet) {
  std::mt19937_64 random(12);
  int clear = 0;
  int apart = 0;
  for (int i = 0; i < 400; ++i) {
    const ProbeSection section = any_shape(random);
    const SweptSection swept = any_sweep(section, random);
    SweptSection grown = swept;
    grown.margin += kSweptBandMm;
    SweptClearance clearance(swept);
    const parts::Mesh mesh =
        i % 4 == 0 ? testing::slivers(random(), 20) : testing::loose_triangles(random(), 20);
    for (const ContactTriangle& triangle : triangles_of(mesh)) {
      const bool is_clear = clearance.is_clear_of(triangle);
      const bool is_met = meets(grown, triangle);
      EXPECT_FALSE(is_clear && is_met) << i;
      clear += is_clear ? 1 : 0;
      apart += is_met ? 0 : 1;
    }
  }
  EXPECT_GT(apart, 4000);
  EXPECT_GT(clear, apart * 98 / 100) << "what is apart should be seen without libccd";
}

TEST(SweptClearance, DoesNotSayClearWithinTheBand) {
  std::mt19937_64 random(13);
  int grazing = 0;
  for (int i = 0; i < 300; ++i) {
    const ProbeSection section = any_shape(random);
    SweptSection swept = any_sweep(section, random);
    const auto triangles = triangles_of(testing::loose_triangles(random(), 1));
    if (meets_any(swept, triangles)) {
      continue;
    }
    ++grazing;
    const double gap = gap_of(swept, triangles);
    for (const double less : {0.0, 1e-9, 1e-7, 1e-5}) {
      swept.margin = std::max(0.0, gap - less);
      EXPECT_FALSE(SweptClearance(swept).is_clear_of(triangles.front())) << i << " less " << less;
    }
  }
  EXPECT_GT(grazing, 100);
}

TEST(SweptClearance, PlanesKeepTheSectionOnOneSideOnAllOfItsWay) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 200; ++i) {
    const ProbeSection section = any_shape(random);
    SweptSection swept = any_sweep(section, random);
    SweptClearance clearance(swept);
    for (const ContactTriangle& triangle : triangles_of(testing::loose_triangles(random(), 20))) {
      static_cast<void>(clearance.is_clear_of(triangle));
    }
    if (i % 2 == 0) {
      swept = swept.piece(0.0, between(random, 0.0, 1.0));
      clearance.shorten_to(swept);
    }
    for (int k = 0; k < 20; ++k) {
      // Of what turns only the ends: the bulge between is the margin's.
      const double share = swept.turns() ? static_cast<double>(k % 2) : between(random, 0.0, 1.0);
      const SectionPlace place = swept.at(share);
      const Point far = furthest_of(section, any_direction(random));
      const Point p = place.p_M + place.turn * far + swept.growth() * any_direction(random);
      for (const parts::Plane& plane : clearance.planes()) {
        EXPECT_LE(plane.normal.dot(p), plane.limit - kClearMm + 1e-10) << i;
      }
    }
  }
}

TEST(CollisionMesh, FindsWhatALookAtEveryTriangleFinds) {
  const int ways = testing::of_many(60);
  constexpr double kFlatMm = 1e-3;  // kSweptBandMm where a section comes in at one degree
  const parts::Mesh kMeshes[] = {testing::sphere_mesh(20.0, 8),
                                 testing::shaken(testing::sphere_mesh(20.0, 10), 0.5, 3),
                                 testing::moved_by(testing::box_mesh({30, 20, 10}), {-15, -10, -5}),
                                 testing::loose_triangles(9, 60),
                                 testing::slivers(4, 60),
                                 testing::book(20.0, 7)};
  std::mt19937_64 random(15);
  int touches = 0;
  int grazing = 0;
  for (const parts::Mesh& mesh : kMeshes) {
    const CollisionMesh ours(mesh);
    const auto triangles = triangles_of(mesh);
    for (int i = 0; i < ways; ++i) {
      const ProbeSection section = any_shape(random);
      SweptSection swept = any_sweep(section, random);
      const auto touch = ours.first_touch(swept);
      ASSERT_EQ(touch.has_value(), meets_any(swept, triangles)) << i;
      if (touch) {
        ++touches;
        const double wanted = first_by_looking_at_all(swept, triangles);
        EXPECT_NEAR(touch->fraction * swept.longest_way(), wanted * swept.longest_way(), kFlatMm)
            << i;
        continue;
      }
      ++grazing;
      const double gap = gap_of(swept, triangles);
      for (const double more : {-1e-3, -1e-5, -1e-7, 0.0, 1e-9, 1e-7, 1e-5, 1e-3}) {
        swept.margin = std::max(0.0, gap + more);
        EXPECT_EQ(ours.first_touch(swept).has_value(), meets_any(swept, triangles))
            << i << " with " << more << " mm more than the gap";
      }
    }
  }
  EXPECT_GT(touches, ways);
  EXPECT_GT(grazing, ways);
}

}  // namespace
}  // namespace g31::probe::swept_clearance_test
