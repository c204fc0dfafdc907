#include "parts/geometry/bvh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::parts::bvh_test {
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

TEST(Bvh, TellsWhichSlotsLieTogether) {
  const std::vector<Box> boxes = awkward_boxes(4, 3000);
  const Bvh tree(boxes);
  const auto box_of = [&](const Bvh::SlotRange& range) {
    Box box;
    for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot) {
      box.include(boxes[tree.order()[slot]]);
    }
    return box;
  };
  for (const std::uint32_t most : {1U, 8U, 100U, 3000U}) {
    const auto ranges = tree.ranges(
        [&](std::uint32_t count, double diagonal) { return count <= most && diagonal <= 9.0; });
    std::uint32_t next = 0;
    for (const Bvh::SlotRange& range : ranges) {
      EXPECT_EQ(range.first, next) << "every slot once, in order";
      next += range.count;
      const Box box = box_of(range);
      EXPECT_TRUE(range.count == 1 || (range.count <= most && (box.max - box.min).norm() <= 9.0));
    }
    EXPECT_EQ(next, boxes.size());
    EXPECT_LT(ranges.size(), most == 1 ? 3001U : 3000U);
  }
  EXPECT_EQ(tree.ranges([](std::uint32_t, double) { return true; }).size(), 1U);
  EXPECT_TRUE(Bvh().ranges([](std::uint32_t, double) { return true; }).empty());
}

/// The slots of all boxes that some points and paths come near, sorted, query by query.
std::vector<std::vector<std::uint32_t>> visited(const Bvh& tree, std::uint64_t seed) {
  std::vector<std::vector<std::uint32_t>> all;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 60; ++i) {
    const Path path{point_between(random, -15.0, 15.0), any_direction(random), 20.0};
    const auto note = [&](double interest) {
      return [&all, interest](std::uint32_t slot) {
        all.back().push_back(slot);
        return interest;
      };
    };
    all.emplace_back();
    tree.visit_near(path.from, 2.0, note(2.0));
    all.emplace_back();
    tree.visit_along(path, 0.5, note(path.length));
  }
  for (auto& one : all) {
    std::ranges::sort(one);
  }
  return all;
}

TEST(Bvh, IsTheSameWheneverItsNodesAreMade) {
  const auto in_order = [](const Bvh& tree, bool is_whole) {
    std::vector<std::uint32_t> all;
    std::mt19937_64 random(6);
    for (int i = 0; i < 60; ++i) {
      const Path path{point_between(random, -15.0, 15.0), any_direction(random), 20.0};
      const auto note = [&](double interest) {
        return [&all, &tree, is_whole, interest](std::uint32_t slot) {
          all.push_back(is_whole ? tree.order()[slot] : slot);
          return interest;
        };
      };
      tree.visit_near(path.from, 2.0, note(2.0));
      tree.visit_along(path, 0.5, note(path.length));
    }
    return all;
  };
  for (const std::size_t count : {1U, 5U, 1000U, 1025U, 20'000U}) {
    const std::vector<Box> boxes = awkward_boxes(9, count);
    std::vector<Bvh::Twig> twigs;
    for (const Box& box : boxes) {
      twigs.push_back({box, static_cast<std::uint32_t>(twigs.size())});
    }
    EXPECT_EQ(in_order(Bvh(twigs), false), in_order(Bvh(boxes), true));
  }
}

/// A tree whose branches are every so many boxes; box k of the list is slot 7 k.
struct GrownTree {
  std::vector<std::atomic<int>> asked;
  Bvh tree;

  GrownTree(const std::vector<Box>& boxes, std::size_t together)
      : asked((boxes.size() + together - 1) / together) {
    std::vector<Box> branches(asked.size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      branches[k / together].include(boxes[k]);
    }
    tree = Bvh(branches, [this, boxes, together](std::uint32_t branch) {
      ++asked[branch];
      std::vector<Bvh::Twig> twigs;
      // Every fifth branch turns out to be empty.
      const std::size_t end = branch % 5 == 4 ? 0 : boxes.size();
      for (std::size_t k = branch * together; k < std::min(end, (branch + 1) * together); ++k) {
        twigs.push_back({boxes[k], static_cast<std::uint32_t>(7 * k)});
      }
      return twigs;
    });
  }
};

TEST(Bvh, GrowsWhereQueriesComeWhoeverComesFirst) {
  for (const std::size_t count : {1U, 5U, 1000U, 20'000U}) {
    constexpr std::size_t kTogether = 37;
    const std::vector<Box> boxes = awkward_boxes(9, count);
    GrownTree grown(boxes, kTogether);
    const std::size_t at_first = grown.tree.memory_bytes();
    std::vector<std::vector<std::vector<std::uint32_t>>> found(4);
    std::vector<std::thread> threads;
    for (auto& one : found) {
      threads.emplace_back([&] { one = visited(grown.tree, 6); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    const Bvh whole(boxes);
    auto wanted = visited(whole, 6);
    for (auto& query : wanted) {
      for (std::uint32_t& slot : query) {
        slot = whole.order()[slot];
      }
      std::erase_if(query, [](std::uint32_t k) { return k / kTogether % 5 == 4; });
      std::ranges::sort(query);
      for (std::uint32_t& slot : query) {
        slot *= 7;
      }
    }
    for (const auto& one : found) {
      EXPECT_EQ(one, wanted);
    }
    for (const auto& times : grown.asked) {
      EXPECT_LE(times, 1);
    }
    EXPECT_TRUE(grown.tree.memory_bytes() > at_first || count < 100);
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
}  // namespace g31::parts::bvh_test
