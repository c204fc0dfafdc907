// How near bodies may come before libccd's "apart" gets lost: the band that meets() states.

#include "probe/collision/swept_section.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::probe::swept_section_test {
namespace {

using testing::any_direction;
using testing::between;
using testing::kUpright;
using testing::point_between;

ContactTriangle any_triangle(std::mt19937_64& random, double size) {
  const Point middle = point_between(random, -20.0, 20.0);
  const auto vertex = [&] { return Point(middle + point_between(random, -size, size)); };
  const Point a = vertex();
  const Point b = vertex();
  return {a, b, vertex()};
}

/// A triangle that is a hair high and one that is none.
ContactTriangle any_sliver(std::mt19937_64& random) {
  const Point a = point_between(random, -20.0, 20.0);
  const Point along = 10.0 * any_direction(random);
  const double height = std::pow(10.0, between(random, -14.0, -3.0));
  return {a, a + along, a + between(random, -0.2, 1.2) * along + height * any_direction(random)};
}

ProbeSection any_section(std::mt19937_64& random) {
  ProbeSection section;
  section.z_bottom = between(random, -5.0, 5.0);
  section.z_top = section.z_bottom + 30.0;
  section.radius_bottom = between(random, 0.0, 10.0);
  section.radius_top = random() % 3 == 0 ? between(random, 0.0, 10.0) : section.radius_bottom;
  return section;
}

struct Case {
  const char* name;
  double triangle_mm;  ///< 0: slivers
  double way_mm;
  double band_mm;
};

/// The greatest gap, of those looked at, at which meets() still says yes: the margin at which the
/// grown sweep begins to touch is found by halving, and less margin must say no.
double widest_wrong_yes(SweptSection swept, const ContactTriangle& triangle) {
  double apart = 0.0;
  double meeting = 1000.0;
  for (int i = 0; i < 60; ++i) {
    swept.margin = 0.5 * (apart + meeting);
    (meets(swept, triangle) ? meeting : apart) = swept.margin;
  }
  const double gap = apart;
  double widest = 0.0;
  for (const double less : {1e-7, 1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 1e-4, 1e-3, 0.1, 1.0}) {
    swept.margin = std::max(0.0, gap - less);
    widest = gap > less && meets(swept, triangle) ? std::max(widest, less) : widest;
  }
  // And what reaches farther must say yes; the gap was found too small by the band at most.
  for (const double more : {kSweptBandMm, 1e-3, 1.0}) {
    swept.margin = gap + more;
    EXPECT_TRUE(meets(swept, triangle)) << "at " << more << " mm more than the gap " << gap;
  }
  return widest;
}

TEST(SweptSection, SaysYesWithinTheBandOnlyAndAlwaysWhereBodiesMeet) {
  const Case kCases[] = {{"triangles of 10 mm", 5.0, 30.0, 1e-6},
                         {"slivers", 0.0, 30.0, 1e-6},
                         {"short ways", 5.0, 0.003, 1e-6},
                         {"triangles of 500 mm", 250.0, 30.0, kSweptBandMm},
                         {"ways of 1 m", 5.0, 1000.0, kSweptBandMm}};
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    std::mt19937_64 random(5);
    int apart = 0;
    double widest = 0.0;
    for (int i = 0; i < 500; ++i) {
      const ProbeSection section = any_section(random);
      const Point from = point_between(random, -20.0, 20.0);
      const SweptSection swept{
          &section, {from, kUpright}, {from + c.way_mm * any_direction(random), kUpright}, 0.0};
      const ContactTriangle triangle =
          c.triangle_mm > 0.0 ? any_triangle(random, c.triangle_mm) : any_sliver(random);
      if (!meets(swept, triangle)) {
        ++apart;
        widest = std::max(widest, widest_wrong_yes(swept, triangle));
      }
    }
    EXPECT_GT(apart, 200);
    EXPECT_LE(widest, c.band_mm);
  }
}

TEST(SweptSection, FindsTheNearestPointsOfACapsuleAndATriangle) {
  ProbeSection capsule;
  capsule.z_bottom = 2.0;
  capsule.z_top = 40.0;
  capsule.rounding = 2.0;
  const ContactTriangle floor({-50, -50, -3}, {50, -50, -3}, {0, 80, -3});
  const SectionPlace place{{1, 2, 0}, kUpright};
  const SweptSection at_rest{&capsule, place, place, 0.0};
  const NearestPair pair = nearest_pair(at_rest, floor);
  EXPECT_NEAR((pair.p_M_section - Point(1, 2, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((pair.p_M_triangle - Point(1, 2, -3)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace g31::probe::swept_section_test
