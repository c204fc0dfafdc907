// The split of a group of boxes against all the splits that there are.

#include "parts/geometry/split_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::parts::split_boxes_test {
namespace {

using testing::between;
using testing::point_between;

constexpr float kBins = 16.0F;

std::vector<BoxItem> any_items(std::mt19937_64& random, std::size_t count) {
  std::vector<BoxItem> items;
  for (std::uint32_t i = 0; i < count; ++i) {
    Box box;
    const Point corner = i % 6 == 0 ? Point(1.0, 2.0, 3.0) : point_between(random, -9.0, 9.0);
    box.include(corner);
    box.include(corner + (i % 4 == 0 ? Point(0, 0, 0) : point_between(random, 0.0, 2.0)));
    items.emplace_back(box, Point(0.5, 0.0, -0.5), i);
  }
  return items;
}

float cost_of(std::vector<BoxItem> items) {
  return group_of(items, 0).box.half_surface() * static_cast<float>(items.size());
}

/// Of the borders between sixteen slices, the least cost.
float least_cost(const std::vector<BoxItem>& items, std::size_t axis) {
  std::vector<BoxItem> copy = items;
  const SmallBox places = group_of(copy, 0).places;
  float least = std::numeric_limits<float>::infinity();
  for (float border = 1.0F; border < kBins; border += 1.0F) {
    std::vector<BoxItem> left;
    std::vector<BoxItem> right;
    for (const BoxItem& item : items) {
      const float share = (item.place(axis) - places.min[axis]) / places.extent(axis);
      (std::min(std::floor(share * kBins), kBins - 1.0F) < border ? left : right).push_back(item);
    }
    if (!left.empty() && !right.empty()) {
      least = std::min(least, cost_of(left) + cost_of(right));
    }
  }
  return least;
}

void expect_same(const SmallBox& a, const SmallBox& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(a.min[i], b.min[i]);
    EXPECT_EQ(a.max[i], b.max[i]);
  }
}

TEST(SplitBoxes, FindsTheCheapestBorderAndKnowsBothSides) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 300; ++round) {
    std::vector<BoxItem> items = any_items(random, 2 + random() % 60);
    const std::vector<BoxItem> before = items;
    const BoxGroup whole = group_of(items, 7);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      axis = whole.places.extent(i) > whole.places.extent(axis) ? i : axis;
    }
    const auto [left, right] = split_in_two(whole);
    ASSERT_FALSE(left.items.empty());
    ASSERT_FALSE(right.items.empty());
    ASSERT_EQ(left.items.size() + right.items.size(), before.size());
    std::vector<bool> seen(before.size());
    for (const BoxItem& item : items) {
      EXPECT_FALSE(seen[item.index()]);
      seen[item.index()] = true;
    }
    for (const BoxGroup& side : {left, right}) {
      const BoxGroup anew = group_of(side.items, 8);
      expect_same(side.box, anew.box);
      expect_same(side.places, anew.places);
      EXPECT_EQ(side.surface, anew.surface);
      EXPECT_EQ(side.depth, 8);
    }
    if (whole.places.extent(axis) > 0.0F) {
      const auto count = [](const BoxGroup& side) { return static_cast<float>(side.items.size()); };
      EXPECT_EQ(left.surface * count(left) + right.surface * count(right),
                least_cost(before, axis));
    }
  }
}

TEST(SplitBoxes, HalvesWhatCannotBeToldApartAndWhatIsTooDeep) {
  std::mt19937_64 random(4);
  std::vector<BoxItem> same(9, BoxItem(Box{{1, 2, 3}, {1, 2, 3}}, Point::Zero(), 0));
  EXPECT_EQ(split_in_two(group_of(same, 0))[0].items.size(), 4U);
  std::vector<BoxItem> items = any_items(random, 40);
  EXPECT_EQ(split_in_two(group_of(items, 48))[0].items.size(), 20U);
}

TEST(SplitBoxes, RoundsBoxesOutwards) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, between(random, -6.0, 3.0));
    const Point p = i == 0 ? Point::Zero() : point_between(random, -size, size);
    const BoxItem item(Box{p, p}, Point::Zero(), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto exact = static_cast<float>(p[static_cast<Eigen::Index>(k)]);
      constexpr float kFar = std::numeric_limits<float>::infinity();
      EXPECT_EQ(item.box().min[k], std::nextafter(exact, -kFar));
      EXPECT_EQ(item.box().max[k], std::nextafter(exact, kFar));
    }
  }
}

}  // namespace
}  // namespace g31::parts::split_boxes_test
