// A ball that begins its move in contact leaves a curved surface as it would leave the true one,
// not as its triangles happen to lie.

#include "probe/contact/leave_contact.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "probe/contact/sweep_mesh.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::leave_contact_test {
namespace {

using testing::between;

constexpr double kRad = std::numbers::pi / 180.0;
constexpr double kBall = 3.0;

/// The wall of a cylinder of `facets`, in `rings` rows, vertices on the circle.
parts::Mesh tube(double radius, std::uint32_t facets, std::uint32_t rings) {
  parts::Mesh mesh;
  for (std::uint32_t k = 0; k <= rings; ++k) {
    for (std::uint32_t i = 0; i < facets; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / facets;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                 60.0 * k / rings - 30.0);
    }
  }
  for (std::uint32_t k = 0; k < rings; ++k) {
    for (std::uint32_t i = 0; i < facets; ++i) {
      const std::uint32_t a = k * facets + i;
      const std::uint32_t b = k * facets + (i + 1) % facets;
      mesh.triangles.push_back({a, b, a + facets});
      mesh.triangles.push_back({b, b + facets, a + facets});
    }
  }
  return mesh;
}

double sagitta(double radius, std::uint32_t facets) {
  return radius * (1.0 - std::cos(std::numbers::pi / facets));
}

struct Tessellation {
  std::uint32_t facets;
  std::uint32_t rings;
};

constexpr Tessellation kTessellations[] = {{24, 1}, {90, 7}, {360, 40}, {1440, 3}, {5000, 1}};
constexpr double kDepths[] = {0.0, 0.001, 0.05, 0.3};
constexpr double kExitsDeg[] = {0.25, 1.0, 3.0, 8.0, 16.0, 45.0, 90.0};

/// Facets that meet at less than the angle of the exit, or lie within the allowance.
bool is_smooth_enough(double radius, const Tessellation& t, double exit_deg) {
  return exit_deg >= 360.0 / t.facets ||
         2.0 * sagitta(radius, t.facets) < kLeaveFreely.allowance_mm;
}

TEST(LeaveContact, LeavesABossAtEveryAngleWhateverItsTriangles) {
  constexpr double kRadius = 20.0;
  std::mt19937_64 random(1);
  int exits = 0;
  for (const Tessellation& t : kTessellations) {
    const MeshSweeper sweeper(tube(kRadius, t.facets, t.rings), kBall);
    for (const double depth : kDepths) {
      for (const double exit_deg : kExitsDeg) {
        if (!is_smooth_enough(kRadius, t, exit_deg)) {
          continue;
        }
        for (int i = 0; i < 10; ++i, ++exits) {
          const double azimuth = between(random, 0.0, 2.0 * std::numbers::pi);
          const Point out(std::cos(azimuth), std::sin(azimuth), 0.0);
          const Point aside =
              std::cos(i) * Point(-out.y(), out.x(), 0.0) + std::sin(i) * Point::UnitZ();
          const Point from = (kRadius + kBall - depth) * out + Point(0, 0, between(random, -5, 5));
          const Point way = std::cos(exit_deg * kRad) * aside + std::sin(exit_deg * kRad) * out;
          EXPECT_EQ(sweeper.first_contact_leaving(from, from + 15.0 * way).status,
                    SweepStatus::Miss)
              << t.facets << " facets, " << depth << " mm deep, " << exit_deg << " degrees";
        }
      }
    }
  }
  EXPECT_GT(exits, 500);
}

/// How a ball leaves the wall of a true bore: along a chord.
struct TrueBore {
  double stop = 0.0;    ///< mm along the chord
  double slope = 0.0;   ///< of the chord against the wall there
  double spared = 0.0;  ///< mm by which the ball comes free of the wall, or does not
};

/// If it comes free, it is stopped by the wall again, otherwise where it gets deeper than it was.
TrueBore stop_in_true_bore(double free_radius, double depth, double exit_rad) {
  const double start = free_radius + depth;
  const double nearest = start * std::cos(exit_rad);
  const double end = nearest < free_radius ? free_radius : start + kLeaveFreely.allowance_mm;
  const double half = std::sqrt(end * end - nearest * nearest);
  return {start * std::sin(exit_rad) + half, half / end, std::fabs(nearest - free_radius)};
}

TEST(LeaveContact, LeavesABoreAlongAChordWhateverItsTriangles) {
  constexpr double kRadius = 20.0;
  std::mt19937_64 random(2);
  int exits = 0;
  for (const Tessellation& t : kTessellations) {
    const MeshSweeper sweeper(tube(kRadius, t.facets, t.rings), kBall);
    const double roughness = 2.0 * sagitta(kRadius, t.facets) + 1e-9;
    for (const double depth : kDepths) {
      for (const double exit_deg : kExitsDeg) {
        const TrueBore expected = stop_in_true_bore(kRadius - kBall, depth, exit_deg * kRad);
        // Grazing, or coarser than the exit is steep: which of the two stops it is open.
        if (!is_smooth_enough(kRadius, t, exit_deg) || expected.spared < roughness + 1e-3) {
          continue;
        }
        for (int i = 0; i < 10; ++i, ++exits) {
          const double azimuth = between(random, 0.0, 2.0 * std::numbers::pi);
          const Point out(std::cos(azimuth), std::sin(azimuth), 0.0);
          const Point aside = Point(-out.y(), out.x(), 0.0) * (i % 2 == 0 ? 1.0 : -1.0);
          const Point from = (kRadius - kBall + depth) * out;
          const Point way = std::cos(exit_deg * kRad) * aside - std::sin(exit_deg * kRad) * out;
          const SweepHit hit = sweeper.first_contact_leaving(from, from + 60.0 * way);
          ASSERT_EQ(hit.status, SweepStatus::Contact);
          EXPECT_NEAR(hit.s, expected.stop, roughness / expected.slope)
              << t.facets << " facets, " << depth << " mm deep, " << exit_deg << " degrees";
        }
      }
    }
  }
  EXPECT_GT(exits, 250);
}

TEST(LeaveContact, LeavesASphereAtEveryAngleWhateverItsTriangles) {
  constexpr double kRadius = 15.0;
  std::mt19937_64 random(3);
  for (const std::uint32_t bands : {12U, 40U, 120U}) {
    const MeshSweeper sweeper(testing::sphere_mesh(kRadius, bands), kBall);
    for (const double depth : kDepths) {
      for (const double exit_deg : {16.0, 45.0, 90.0}) {
        for (int i = 0; i < 10; ++i) {
          const Point out = testing::any_direction(random);
          const Point aside = out.cross(testing::any_direction(random)).normalized();
          const Point from = (kRadius + kBall - depth) * out;
          const Point way = std::cos(exit_deg * kRad) * aside + std::sin(exit_deg * kRad) * out;
          EXPECT_EQ(sweeper.first_contact_leaving(from, from + 15.0 * way).status,
                    SweepStatus::Miss);
        }
      }
    }
  }
}

/// A floor at z = 0 of n x n squares with a wall at x = 10, also of squares.
parts::Mesh floor_and_wall(std::uint32_t n) {
  parts::Mesh mesh;
  const auto add = [&](const Point& origin, const Point& u, const Point& v) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (std::uint32_t j = 0; j <= n; ++j) {
        mesh.vertices.push_back(origin + (u * i + v * j) / n);
      }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t a = first + i * (n + 1) + j;
        mesh.triangles.push_back({a, a + n + 1, a + 1});
        mesh.triangles.push_back({a + 1, a + n + 1, a + n + 2});
      }
    }
  };
  add({-20, -20, 0}, {30, 0, 0}, {0, 40, 0});
  add({10, -20, 0}, {0, 0, 20}, {0, 40, 0});
  return mesh;
}

TEST(LeaveContact, RubsAlongAFloorIntoAWall) {
  struct Case {
    const char* name;
    Point from;
    Point to;
    std::optional<double> s;
  };
  const Case kCases[] = {
      {"along the floor, short of the wall", {-10, 1, 2.8}, {6, 5, 2.8}, std::nullopt},
      {"along the floor into the wall", {-10, 1, 2.8}, {12, 1, 2.8}, 17.0},
      {"up a little and into the wall", {-10, 1, 2.8}, {12, 1, 2.9}, 17.0},
      {"in the corner, out of it", {7.2, 0, 2.8}, {0, 0, 10}, std::nullopt},
      {"in the corner, up along the wall", {7.2, 0, 2.8}, {7.2, 3, 10}, std::nullopt},
      {"in the corner, along both", {7.2, 0, 2.8}, {7.2, 9, 2.8}, std::nullopt},
      {"in the corner, off the floor but against the wall", {7.2, 0, 2.8}, {9, 0, 5}, 0.0},
      {"off the floor, then into the wall", {-10, 1, 2.8}, {12, 1, 24.8}, 17.0 * std::sqrt(2.0)},
      {"into the floor", {-10, 1, 2.8}, {-9, 1, 2.0}, 0.0},
  };
  for (const std::uint32_t n : {1U, 7U, 64U, 120U}) {
    const MeshSweeper sweeper(floor_and_wall(n), kBall);
    for (const Case& c : kCases) {
      SCOPED_TRACE(std::string(c.name) + ", " + std::to_string(n) + " squares a side");
      const SweepHit hit = sweeper.first_contact_leaving(c.from, c.to);
      ASSERT_EQ(hit.status, c.s ? SweepStatus::Contact : SweepStatus::Miss);
      EXPECT_NEAR(hit.s, c.s.value_or(0.0), c.s == 0.0 || !c.s ? 3e-9 : 2e-4);
    }
  }
}

TEST(LeaveContact, AProbingMoveThatTouchesAtItsStartSlidesButDoesNotEnter) {
  for (const std::uint32_t n : {1U, 7U, 64U}) {
    const MeshSweeper sweeper(floor_and_wall(n), kBall);
    for (const double z : {3.0 - 5e-10, 3.0, 3.0 + 5e-10}) {
      const Point from(-10, 1, z);
      EXPECT_EQ(sweeper.sweep(from, {5, 3, z}).status, SweepStatus::Miss) << n;
      EXPECT_EQ(sweeper.sweep(from, {5, 3, z + 1e-3}).status, SweepStatus::Miss) << n;
      EXPECT_EQ(sweeper.sweep(from, {5, 3, z + 1.0}).status, SweepStatus::Miss) << n;
      EXPECT_NEAR(sweeper.sweep(from, {10, 1, z}).s, 17.0, 1e-12) << n;
      EXPECT_EQ(sweeper.sweep(from, {5, 3, z - 1e-6}).s, 0.0) << n;
      EXPECT_EQ(sweeper.sweep(from, {5, 3, z - 1e-6}).status, SweepStatus::Contact) << n;
    }
  }
}

}  // namespace
}  // namespace g31::probe::leave_contact_test
