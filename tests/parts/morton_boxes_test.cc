#include "parts/geometry/morton_boxes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::parts::morton_boxes_test {
namespace {

using testing::point_between;

std::vector<Box> drawn_boxes(std::size_t count, double largest, std::mt19937_64& random) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    Box box;
    box.include(point_between(random, -100.0, 100.0));
    box.include(Point(box.min + point_between(random, 0.0, largest)));
    boxes.push_back(box);
  }
  return boxes;
}

bool meet(const Box& a, const Box& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// All pairs of boxes that meet, by the numbers that they were given with.
std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_in(const MortonBoxes& tree) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> near;
  for (std::size_t group = 0; group < tree.groups(); ++group) {
    static_cast<void>(tree.groups_near(tree.group(group).around(), group, near));
    EXPECT_TRUE(std::ranges::is_sorted(near));
    for (std::size_t lane = 0; lane < 8 && 8 * group + lane < tree.order().size(); ++lane) {
      for (const std::uint32_t other : near) {
        const unsigned int meeting = tree.group(other).meet(tree.group(group).at(lane));
        for (std::size_t bit = 0; bit < 8; ++bit) {
          const std::size_t slot = 8 * other + bit;
          if ((meeting >> bit & 1U) != 0 && slot > 8 * group + lane) {
            const auto [low, high] =
                std::minmax(tree.order()[8 * group + lane], tree.order()[slot]);
            pairs.emplace(low, high);
          }
        }
      }
    }
  }
  return pairs;
}

// Brute force: every box against every other one.
TEST(MortonBoxes, FindEveryPairOfBoxesThatMeet) {
  std::mt19937_64 random(4);
  for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 64U, 65U, 600U}) {
    for (const double largest : {0.0, 1.0, 30.0, 300.0}) {
      const std::vector<Box> boxes = drawn_boxes(count, largest, random);
      const MortonBoxes tree(boxes);
      const auto found = pairs_in(tree);
      std::size_t expected = 0;
      for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a + 1; b < count; ++b) {
          if (meet(boxes[a], boxes[b])) {
            ++expected;
            EXPECT_TRUE(found.contains({a, b})) << count << ' ' << largest;
          }
        }
      }
      // Grown by what float32 loses, hardly any more meet.
      EXPECT_LE(found.size(), expected + expected / 1000 + 1);
    }
  }
}

TEST(MortonBoxes, HoldEachBoxOnce) {
  std::mt19937_64 random(5);
  const MortonBoxes tree(drawn_boxes(1000, 3.0, random));
  std::vector<std::uint32_t> order(tree.order().begin(), tree.order().end());
  std::ranges::sort(order);
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    ASSERT_EQ(order[i], i);
  }
}

// Neighbours in a row of boxes are neighbours on the curve, or groups would be of boxes far apart.
TEST(MortonBoxes, PutNeighboursTogether) {
  std::mt19937_64 random(6);
  const MortonBoxes tree(drawn_boxes(8000, 0.0, random));
  double sizes = 0.0;
  for (std::size_t group = 0; group < tree.groups(); ++group) {
    const RoundedBox box = tree.group(group).around();
    sizes += double{box.max[0]} - double{box.min[0]};
  }
  // Eight of 8000 in a cube of 200 mm: by chance they would be 160 mm wide.
  EXPECT_LT(sizes / static_cast<double>(tree.groups()), 40.0);
}

}  // namespace
}  // namespace g31::parts::morton_boxes_test
