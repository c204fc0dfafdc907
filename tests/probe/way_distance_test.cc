// How near a straight way comes to a mesh: closed form of a box.

#include "probe/contact/way_distance.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::probe::way_distance_test {
namespace {

TEST(WayDistance, OfABoxIsThatOfItsFacesEdgesAndCorners) {
  const parts::Mesh box = testing::box_mesh({10.0, 20.0, 30.0});
  EXPECT_NEAR(distance_of_way(box, {13.0, 5.0, 5.0}, {18.0, 6.0, 5.0}), 3.0, kWayDistanceErrorMm);
  EXPECT_NEAR(distance_of_way(box, {13.0, 5.0, 34.0}, {13.0, 15.0, 34.0}), 5.0, kWayDistanceErrorMm)
      << "3 and 4 mm from an edge";
  EXPECT_NEAR(distance_of_way(box, {12.0, 23.0, 36.0}, {22.0, 33.0, 46.0}), 7.0,
              kWayDistanceErrorMm)
      << "2, 3 and 6 mm from a corner";
  EXPECT_NEAR(distance_of_way(box, {-50.0, 5.0, 5.0}, {50.0, 6.0, 7.0}), 0.0, kWayDistanceErrorMm)
      << "through it";
  EXPECT_NEAR(distance_of_way(box, {13.0, 5.0, 5.0}, {13.0, 5.0, 5.0}), 3.0, kWayDistanceErrorMm);
  EXPECT_EQ(distance_of_way({}, {0, 0, 0}, {1, 0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace g31::probe::way_distance_test
