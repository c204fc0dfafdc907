#include "parts/geometry/bvh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::parts {
namespace {

using testing::any_direction;
using testing::between;
using testing::point_between;

bool contains(const Box& box, double reach, const Point& p) {
  double squared = 0.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double outside = std::max({box.min[i] - p[i], p[i] - box.max[i], 0.0});
    squared += outside * outside;
  }
  return std::sqrt(squared) <= reach;
}

/// Whether some of many points of the path lies within reach of the box: never true where it should
/// not be.
bool surely_met(const Box& box, double reach, const Path& path) {
  for (int i = 0; i <= 60; ++i) {
    if (contains(box, reach, path.from + path.direction * (path.length * i / 60.0))) {
      return true;
    }
  }
  return false;
}

std::vector<Box> awkward_boxes(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  std::vector<Box> boxes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point centre = i % 5 == 0 ? Point(1.0, 2.0, 3.0) : point_between(random, -10.0, 10.0);
    boxes[i].include(centre);
    if (i % 3 != 0) {
      boxes[i].include(centre + point_between(random, 0.0, 3.0));
    }
  }
  return boxes;
}

TEST(Bvh, HoldsEveryBoxOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 100U, 5000U}) {
    const Bvh tree(awkward_boxes(count, count));
    std::vector<std::uint32_t> order(tree.order().begin(), tree.order().end());
    std::ranges::sort(order);
    ASSERT_EQ(order.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(order[i], i);
    }
  }
}

TEST(Bvh, VisitsEveryBoxNearAPointOrOnAPath) {
  const std::vector<Box> boxes = awkward_boxes(1, 600);
  const Bvh tree(boxes);
  std::mt19937_64 random(2);
  std::size_t met = 0;
  std::size_t visits = 0;
  std::size_t passing = 0;
  for (int i = 0; i < 150; ++i) {
    const double reach = between(random, 0.0, 2.0);
    const Point direction = i % 3 == 0 ? Point(Point::Unit(i % 2)) : any_direction(random);
    const Path path{point_between(random, -15.0, 15.0), direction, between(random, 0.0, 30.0)};
    bool any_along = false;
    std::vector<bool> near(boxes.size());
    std::vector<bool> along(boxes.size());
    tree.visit_near(path.from, reach, [&](std::uint32_t slot) {
      near[tree.order()[slot]] = true;
      return reach;
    });
    tree.visit_along(path, reach + 1e-9, [&](std::uint32_t slot) {
      along[tree.order()[slot]] = true;
      ++visits;
      return path.length;
    });
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      EXPECT_TRUE(near[k] || !contains(boxes[k], reach, path.from));
      const bool wanted = surely_met(boxes[k], reach, path);
      EXPECT_TRUE(along[k] || !wanted);
      met += wanted ? 1 : 0;
      any_along = any_along || along[k];
    }
    EXPECT_TRUE(tree.may_meet(path, reach + 1e-9) || !any_along);
    passing += tree.may_meet(path, reach + 1e-9) ? 0U : 1U;
  }
  EXPECT_GT(met, 250U);
  EXPECT_GT(passing, 10U);
  EXPECT_LT(visits, 4 * met) << "the tree should spare the boxes that are out of reach";
}

/// The numbers of all boxes that some points and paths come near, as they are visited.
std::vector<std::uint32_t> visited(const Bvh& tree) {
  std::vector<std::uint32_t> all;
  std::mt19937_64 random(6);
  for (int i = 0; i < 60; ++i) {
    const Path path{point_between(random, -15.0, 15.0), any_direction(random), 20.0};
    const auto note = [&](double interest) {
      return [&all, &tree, interest](std::uint32_t slot) {
        all.push_back(tree.order().empty() ? slot : tree.order()[slot]);
        return interest;
      };
    };
    tree.visit_near(path.from, 2.0, note(2.0));
    tree.visit_along(path, 0.5, note(path.length));
  }
  return all;
}

TEST(Bvh, IsTheSameWheneverItsNodesAreMade) {
  for (const std::size_t count : {1U, 5U, 1000U, 1025U, 20'000U}) {
    const std::vector<Box> boxes = awkward_boxes(9, count);
    const std::vector<std::uint32_t> wanted = visited(Bvh(boxes));
    const Bvh growing(boxes, Bvh::Growth::WhereAsked);
    const std::size_t at_first = growing.memory_bytes();
    std::vector<std::vector<std::uint32_t>> found(4);
    std::vector<std::thread> threads;
    for (auto& one : found) {
      threads.emplace_back([&] { one = visited(growing); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    for (const auto& one : found) {
      EXPECT_EQ(one, wanted);
    }
    EXPECT_EQ(growing.memory_bytes() > at_first, count > 100);
  }
}

TEST(Bvh, LeavesOutWhatLiesBeyondAPlane) {
  constexpr std::size_t kBoxes = 3000;
  const std::vector<Box> boxes = awkward_boxes(9, kBoxes);
  const Bvh tree(boxes);
  std::mt19937_64 random(8);
  std::size_t left_out = 0;
  for (int i = 0; i < 100; ++i) {
    const Path path{point_between(random, -15.0, 15.0), any_direction(random), 20.0};
    const Point reach(0.5, 1.0, 2.0);
    std::vector<Plane> planes;
    for (int k = 0; k < i % 4; ++k) {
      const Point normal = any_direction(random);
      planes.push_back({normal, normal.dot(path.from) + between(random, 0.0, 5.0)});
    }
    std::vector<std::uint32_t> all;
    tree.visit_along(path, reach, [&](std::uint32_t slot) {
      all.push_back(slot);
      return path.length;
    });
    std::vector<std::uint32_t> near;
    tree.visit_along(
        path, reach, [&] { return std::span<const Plane>(planes); },
        [&](std::uint32_t slot) {
          near.push_back(slot);
          return path.length;
        });
    // How far the box reaches over to this side of a plane that has it on the other, mm.
    const auto beyond = [&](std::uint32_t slot) {
      const Box& box = boxes[tree.order()[slot]];
      double most = 0.0;
      for (const Plane& plane : planes) {
        const Point corner = (plane.normal.array() < 0.0).select(box.max, box.min);
        most = std::max(most, corner.dot(plane.normal) - plane.limit);
      }
      return most;
    };
    std::vector<std::uint32_t> wanted;
    constexpr double kLoss = 1e-4;
    for (const std::uint32_t slot : all) {
      const bool is_near = std::ranges::find(near, slot) != near.end();
      EXPECT_TRUE(is_near || beyond(slot) > 0.0);
      EXPECT_FALSE(is_near && beyond(slot) > kLoss);
      if (is_near) {
        wanted.push_back(slot);
      }
    }
    EXPECT_EQ(near, wanted) << "in the same order";
    left_out += all.size() - near.size();
  }
  EXPECT_GT(left_out, 100U);
}

TEST(Bvh, DoesNotWalkBehindTheLimit) {
  std::vector<Box> boxes(1000);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].include(Point(static_cast<double>(i), 0.0, 0.0));
  }
  const Bvh tree(boxes);
  int visits = 0;
  tree.visit_along({Point(-5.0, 0.0, 0.0), Point::UnitX(), 2000.0}, 0.1, [&](std::uint32_t slot) {
    ++visits;
    return 5.0 + tree.order()[slot];
  });
  EXPECT_LE(visits, 4);
}

TEST(Bvh, TriangleBoxesEncloseTheirVertices) {
  const Mesh mesh = testing::box_mesh({3.0, 2.0, 1.0});
  const std::vector<Box> boxes = triangle_boxes(mesh);
  ASSERT_EQ(boxes.size(), 12U);
  EXPECT_EQ(boxes[0].min, Point(0, 0, 0));
  EXPECT_EQ(boxes[0].max, Point(3, 2, 0));
}

}  // namespace
}  // namespace g31::parts
