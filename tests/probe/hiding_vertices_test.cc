#include "probe/contact/hiding_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "probe/contact/contact_mesh.h"
#include "probe/contact/offset_regions.h"
#include "probe/contact/sweep_mesh.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::hiding_vertices_test {
namespace {

using testing::any_direction;
using testing::between;
using testing::point_between;

constexpr double kRadius = 3.0;

/// Vertices beside the origin, some of them high enough to hide something of it from above.
std::vector<Point> vertices_beside(std::mt19937_64& random, int count) {
  std::vector<Point> vertices;
  for (int i = 0; i < count; ++i) {
    vertices.emplace_back(between(random, -0.5, 0.5), between(random, -0.5, 0.5),
                          between(random, -0.02, 0.02));
  }
  return vertices;
}

/// A direction in the cone that the corners span, none of them left out.
Point direction_in(const ExposedPiece& piece, std::mt19937_64& random) {
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < piece.count; ++i) {
    sum += between(random, 0.0, 1.0) * piece.corners[i];
  }
  return sum.normalized();
}

/// Whether the direction lies in the cone of the corners, which go around it one way.
bool is_in(const ExposedPiece& piece, const Point& direction) {
  constexpr double kRounding = 1e-9;
  double least = 1.0;
  double most = -1.0;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const Point& next = piece.corners[i + 1 < piece.count ? i + 1 : 0];
    const double side = piece.corners[i].cross(next).dot(direction);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  return piece.count > 0 && (least >= -kRounding || most <= kRounding);
}

/// How deep a ball about the point overlaps one of the vertices at most, mm.
double deepest(const std::vector<Point>& vertices, const Point& centre) {
  double deepest = -kRadius;
  for (const Point& vertex : vertices) {
    deepest = std::max(deepest, kRadius - (vertex - centre).norm());
  }
  return deepest;
}

ExposedPiece piece_about_z(std::mt19937_64& random) {
  ExposedPiece piece;
  const double lean = between(random, 0.01, 0.6);
  for (int i = 0; i < 4; ++i) {
    const double angle = 1.5707963267948966 * i + between(random, -0.3, 0.3);
    piece.corners[piece.count++] =
        Point(lean * std::cos(angle), lean * std::sin(angle), 1.0).normalized();
  }
  return piece;
}

TEST(HidingVertices, LeaveOutOnlyDirectionsInWhichABallOverlapsAVertex) {
  std::mt19937_64 random(1);
  int left_out = 0;
  int kept = 0;
  int gone = 0;
  int deep_but_left = 0;
  constexpr double kDeepMm = 0.01;
  for (int i = 0; i < 500; ++i) {
    const std::vector<Point> vertices = vertices_beside(random, 12);
    const ExposedPiece piece = piece_about_z(random);
    HidingVertices hiding(vertices, kRadius);
    const ExposedPiece left = hiding.left_of(piece, {Point::Zero(), Point::Zero()});
    gone += left.count == 0 ? 1 : 0;
    for (int k = 0; k < 50; ++k) {
      const Point n = direction_in(piece, random);
      const bool is_left = is_in(left, n);
      const double depth = deepest(vertices, kRadius * n);
      EXPECT_TRUE(is_left || depth > 0.5 * HidingVertices::kHiddenMm);
      deep_but_left += is_left && depth > kDeepMm ? 1 : 0;
      (is_left ? kept : left_out) += 1;
    }
  }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(left_out, 5000);
  EXPECT_GT(gone, 20);
  EXPECT_LT(gone, 480);
  EXPECT_LT(deep_but_left, left_out / 20) << "it should leave out nearly all that is hidden";
}

TEST(HidingVertices, LeaveOutOfAnEdgeOnlyWhatIsHiddenAllAlong) {
  std::mt19937_64 random(2);
  int left_out = 0;
  int kept = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Point> vertices = vertices_beside(random, 12);
    const std::array<Point, 2> ends = {Point(-0.1, 0.0, 0.0), Point(0.1, 0.0, 0.0)};
    ExposedPiece piece;
    for (const double lean : {between(random, -0.4, 0.0), between(random, 0.0, 0.4)}) {
      piece.corners[piece.count++] = Point(0.0, std::sin(lean), std::cos(lean));
    }
    HidingVertices hiding(vertices, kRadius);
    const ExposedPiece left = hiding.left_of(piece, ends);
    for (int k = 0; k < 20; ++k) {
      const Point n = direction_in(piece, random);
      constexpr double kRounding = 1e-9;
      const bool is_left =
          left.count == 2 &&
          n.y() >= std::min(left.corners[0].y(), left.corners[1].y()) - kRounding &&
          n.y() <= std::max(left.corners[0].y(), left.corners[1].y()) + kRounding;
      for (const double along : {0.0, 0.3, 1.0}) {
        const Point p = ends[0] + along * (ends[1] - ends[0]);
        EXPECT_TRUE(is_left ||
                    deepest(vertices, p + kRadius * n) > 0.5 * HidingVertices::kHiddenMm);
      }
      (is_left ? kept : left_out) += 1;
    }
  }
  EXPECT_GT(kept, 2000);
  EXPECT_GT(left_out, 2000);
}

TEST(HidingVertices, HideAFaceOnlyWhereverABallTouchesIt) {
  std::mt19937_64 random(3);
  int hidden = 0;
  int open = 0;
  for (int i = 0; i < 2000; ++i) {
    const ContactTriangle triangle({-0.1, -0.1, 0.0}, {0.1, -0.1, 0.0}, {0.0, 0.1, 0.0});
    const std::vector<Point> vertices = vertices_beside(random, 3);
    const Point up = i % 2 == 0 ? triangle.normal : Point(-triangle.normal);
    HidingVertices hiding(vertices, kRadius);
    if (!hiding.hide_face(triangle, up)) {
      ++open;
      continue;
    }
    ++hidden;
    for (int k = 0; k < 20; ++k) {
      const double a = between(random, 0.0, 1.0);
      const double b = between(random, 0.0, 1.0 - a);
      const auto& corners = triangle.vertices;
      const Point p = a * corners[0] + b * corners[1] + (1.0 - a - b) * corners[2];
      EXPECT_GT(deepest(vertices, p + kRadius * up), 0.5 * HidingVertices::kHiddenMm);
    }
  }
  EXPECT_GT(hidden, 100);
  EXPECT_GT(open, 100);
}

/// The unpruned way: every triangle near the way of the ball, all of it.
TEST(HidingVertices, ChangeNoContactOnRoughMeshes) {
  struct Case {
    const char* name;
    parts::Mesh mesh;
    double radius;
  };
  const Case kCases[] = {
      {"finely rough", testing::shaken(testing::sphere_mesh(20.0, 100), 0.2, 3), 3.0},
      {"steep", testing::shaken(testing::sphere_mesh(20.0, 60), 0.4, 4), 5.0},
      {"turned over at random, with holes",
       testing::without_every(
           testing::turned_at_random(testing::shaken(testing::sphere_mesh(20, 80), 0.3, 5), 6), 30),
       3.0},
  };
  std::mt19937_64 random(7);
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto mesh = std::make_shared<const ContactMesh>(c.mesh);
    const MeshSweeper sweeper(mesh, c.radius);
    EXPECT_TRUE(is_rough_and_fine(OffsetSurface(*mesh, c.radius)));
    int contacts = 0;
    for (int i = 0; i < 4000; ++i) {
      const Point from = (i % 4 == 1 ? 8.0 : 32.0) * any_direction(random);
      const Point aim = i % 4 == 2 ? Point((20.0 + c.radius) * any_direction(random))
                                   : point_between(random, -14.0, 14.0);
      const parts::Path path{from, (aim - from).normalized(), 30.0};
      const SweepHit hit = sweeper.sweep(from, from + path.length * path.direction);
      ASSERT_NE(hit.status, SweepStatus::StartInContact);
      const auto wanted = mesh->first_meeting(path, c.radius);
      ASSERT_EQ(hit.status == SweepStatus::Contact, wanted.has_value());
      if (wanted) {
        ++contacts;
        ASSERT_NEAR(hit.s, wanted->s, 1e-11 / std::max(hit.cos_incidence, 1e-5));
      }
    }
    EXPECT_GT(contacts, 3000);
  }
}

}  // namespace
}  // namespace g31::probe::hiding_vertices_test
