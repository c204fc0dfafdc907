// G110, G111, G120, G130 and G131 against Eigen: other formulas for the same geometry, on random
// points and near the places where there is no answer.

#include "tests/tools/point_macros.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace g31::point_macros_test {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::Buffer;
using testing::point_of;
using testing::PointProgram;
using testing::RunOutput;
using testing::value_of;

constexpr int kRounds = 40;
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// The two axes of plane H: X-Y, Y-Z, Z-X.
Vector2d seen(const Vector3d& p, int plane) {
  return {p[plane], p[(plane + 1) % 3]};
}

Vector3d lifted(const Vector2d& p, int plane) {
  Vector3d point = Vector3d::Zero();
  point[plane] = p.x();
  point[(plane + 1) % 3] = p.y();
  return point;
}

/// All three buffers full of random points, some coordinates whole numbers.
class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : random_(seed) {
    for (const Buffer buffer : {Buffer::A, Buffer::B, Buffer::C}) {
      for (int row = 1; row <= rows(buffer); ++row) {
        Vector3d point;
        for (int axis = 0; axis < 3; ++axis) {
          const double at = std::uniform_real_distribution<>(-200.0, 200.0)(random_);
          point[axis] = below(4) == 0 ? std::round(at) : at;
        }
        points_[{buffer, row}] = point;
        program.put(buffer, row, point);
      }
    }
  }

  static int rows(Buffer buffer) { return buffer == Buffer::A ? 9 : 5; }
  int below(int limit) { return std::uniform_int_distribution<>(0, limit - 1)(random_); }
  int row(Buffer buffer) { return 1 + below(rows(buffer)); }

  /// `count` different rows of a buffer.
  std::vector<int> different_rows(Buffer buffer, std::size_t count) {
    std::vector<int> all(static_cast<std::size_t>(rows(buffer)));
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = static_cast<int>(i) + 1;
    }
    std::shuffle(all.begin(), all.end(), random_);
    all.resize(count);
    return all;
  }

  [[nodiscard]] const Vector3d& at(Buffer buffer, int row) const {
    return points_.at({buffer, row});
  }

  PointProgram program;

 private:
  std::mt19937 random_;
  std::map<std::pair<Buffer, int>, Vector3d> points_;
};

TEST(PointMacros, CrossPointAndAngleOfTwoLines) {
  for (unsigned round = 0; round < kRounds; ++round) {
    RandomPoints points(round);
    const auto rows = points.different_rows(Buffer::A, 4);
    const int plane = points.below(3);
    const int row = points.row(Buffer::B);
    const std::string call =
        fmt::format("G110 A{}{}.{}{} H{} B{}. W1.", rows[0], rows[1], rows[2], rows[3], plane, row);
    SCOPED_TRACE(call);
    std::array<Vector2d, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = seen(points.at(Buffer::A, rows[i]), plane);
    }
    Matrix2d directions;
    directions << p[1] - p[0], p[2] - p[3];
    const Vector2d along = directions.fullPivLu().solve(p[2] - p[0]);
    const Vector2d cross = p[0] + along.x() * (p[1] - p[0]);
    const Vector2d d1 = p[1] - p[0];
    const Vector2d d2 = p[3] - p[2];
    const double turn = std::remainder(std::atan2(d2.y(), d2.x()) - std::atan2(d1.y(), d1.x()),
                                       2.0 * std::numbers::pi);

    const RunOutput output = points.program.run(call);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const double scale = std::max(1.0, cross.norm());
    EXPECT_LT((point_of(output, 99, row) - lifted(cross, plane)).norm(), 1e-9 * scale);
    EXPECT_NEAR(value_of(output, 144 + row).value(), turn * kDegrees, 1e-9);
    EXPECT_EQ(output.document.at("output"), "") << "W1. prints nothing";
  }
}

TEST(PointMacros, CrossPointAndAngleOfThreePlanes) {
  for (unsigned round = 0; round < kRounds; ++round) {
    RandomPoints points(round);
    std::vector<int> rows = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    std::string named;
    if (round % 2 == 1) {
      rows = points.different_rows(Buffer::A, 9);
      std::sort(rows.begin() + 6, rows.end());
      named = fmt::format("A{}{}{}.{}{}{} ", rows[0], rows[1], rows[2], rows[3], rows[4], rows[5]);
    }
    const int pair = points.below(3);
    const int row = points.row(Buffer::B);
    const std::string call = fmt::format("G111 {}H{}. B{}. W1.", named, pair, row);
    SCOPED_TRACE(call);
    Matrix3d normals;
    Vector3d offsets;
    for (int k = 0; k < 3; ++k) {
      // The plane n.p = 1 through three points; from the origin no random plane passes.
      Matrix3d corners;
      for (int i = 0; i < 3; ++i) {
        corners.row(i) =
            points.at(Buffer::A, rows[static_cast<std::size_t>(3 * k + i)]).transpose();
      }
      const Vector3d n = corners.fullPivLu().solve(Vector3d::Ones());
      // n.p = 1 points away from the origin; the rows run counterclockwise about it or not.
      const double side = corners.determinant() > 0.0 ? 1.0 : -1.0;
      normals.row(k) = side * n.normalized().transpose();
      offsets[k] = side / n.norm();
    }
    const double volume = std::abs(normals.determinant());
    if (volume < 1e-3) {
      continue;
    }
    const Vector3d cross = normals.fullPivLu().solve(offsets);
    const double angle = std::acos(normals.row(pair).dot(normals.row((pair + 1) % 3)));

    const RunOutput output = points.program.run(call);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const double scale = std::max(1.0, cross.norm()) / volume;
    EXPECT_LT((point_of(output, 99, row) - cross).norm(), 1e-9 * scale);
    EXPECT_NEAR(value_of(output, 144 + row).value(), angle * kDegrees, 1e-6);
  }
}

/// Height by longest side of a triangle.
double flatness(const Eigen::Matrix<double, 2, 3>& corners) {
  const Vector2d first = corners.col(1) - corners.col(0);
  const Vector2d second = corners.col(2) - corners.col(0);
  const double longest = std::max({first.norm(), second.norm(), (second - first).norm()});
  return std::abs(first.x() * second.y() - first.y() * second.x()) / (longest * longest);
}

TEST(PointMacros, CircleThroughThreePoints) {
  for (unsigned round = 0; round < kRounds; ++round) {
    RandomPoints points(round);
    const auto rows = points.different_rows(Buffer::A, 3);
    const int plane = points.below(3);
    const int row = points.row(Buffer::C);
    const std::string call =
        fmt::format("G120 A{}{}{}. H{} C{}. W1.", rows[0], rows[1], rows[2], plane, row);
    SCOPED_TRACE(call);
    // x^2 + y^2 = 2 a x + 2 b y + c is linear in the centre (a, b) and c.
    Matrix3d m;
    Vector3d squares;
    Eigen::Matrix<double, 2, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Vector2d p = seen(points.at(Buffer::A, rows[static_cast<std::size_t>(i)]), plane);
      corners.col(i) = p;
      m.row(i) << 2.0 * p.x(), 2.0 * p.y(), 1.0;
      squares[i] = p.squaredNorm();
    }
    if (flatness(corners) < 2e-4) {
      continue;  // point_macro_limits_test.cc has these
    }
    const Vector3d solved = m.fullPivLu().solve(squares);
    const Vector2d centre = solved.head<2>();
    const double radius = std::sqrt(solved[2] + centre.squaredNorm());

    const RunOutput output = points.program.run(call);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const double tolerance = 1e-12 * radius * radius + 1e-9;
    EXPECT_LT((point_of(output, 104, row) - lifted(centre, plane)).norm(), tolerance);
    EXPECT_NEAR(value_of(output, 149 + row).value(), 2.0 * radius, tolerance);
  }
}

constexpr std::array kBuffers = {Buffer::A, Buffer::B, Buffer::C};

char letter(Buffer buffer) {
  return "ABC"[static_cast<int>(buffer)];
}

TEST(PointMacros, DistanceOfTwoPoints) {
  for (unsigned round = 0; round < 2 * kRounds; ++round) {
    RandomPoints points(round);
    const auto first = kBuffers[round % 3];
    const auto second = kBuffers[(round / 3) % 3];
    std::string words;
    std::vector<int> rows;
    if (first == second) {
      rows = points.different_rows(first, 2);
      words = fmt::format("{}{}{}.", letter(first), rows[0], rows[1]);
    } else if (first < second) {
      rows = {points.row(first), points.row(second)};
      words = fmt::format("{}{}. {}{}.", letter(first), rows[0], letter(second), rows[1]);
    } else {
      continue;  // the order of the words in the block is not seen by a macro
    }
    const int in_plane = points.below(4);
    const int to_plane = points.below(4);
    const int row = 1 + points.below(5);
    const std::string call =
        fmt::format("G130 {} S{}. T{} D{}. I7. W1.", words, in_plane, to_plane, row);
    SCOPED_TRACE(call);
    const Vector3d way = points.at(second, rows[1]) - points.at(first, rows[0]);

    const RunOutput output = points.program.run(call);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_LT((point_of(output, 109, row) - way).norm(), 1e-12);
    const double distance = in_plane == 0 ? way.norm() : seen(way, in_plane - 1).norm();
    EXPECT_NEAR(value_of(output, 154 + row).value(), distance, 1e-9);
    if (to_plane == 0) {
      EXPECT_EQ(value_of(output, 169 + row), std::nullopt);
    } else {
      const double across = std::abs(way[(to_plane + 1) % 3]) / way.norm();
      EXPECT_NEAR(value_of(output, 169 + row).value(), std::asin(across) * kDegrees, 1e-6);
    }
  }
}

struct LineAndPoint {
  std::string words;
  Vector3d from, to, point;
};

/// Every way of the paper to name a line and a point, by turns.
LineAndPoint named(RandomPoints& points, unsigned round) {
  const Buffer line = kBuffers[round % 3];
  const Buffer other = kBuffers[(round + 1 + (round / 3) % 2) % 3];
  const auto rows = points.different_rows(line, 3);
  if (round % 4 == 0) {
    return {fmt::format("{}{}{}.{}", letter(line), rows[0], rows[1], rows[2]),
            points.at(line, rows[0]), points.at(line, rows[1]), points.at(line, rows[2])};
  }
  if (round % 4 == 1) {
    const char* const mark = round % 8 == 1 ? ".1" : ".";
    const std::array row = {points.row(Buffer::A), points.row(Buffer::B), points.row(Buffer::C)};
    return {fmt::format("A{}{} B{}{} C{}{}", row[0], mark, row[1], mark, row[2], mark),
            points.at(Buffer::A, row[0]), points.at(Buffer::B, row[1]),
            points.at(Buffer::C, row[2])};
  }
  const int row = points.row(other);
  return {fmt::format("{}{}{}. {}{}.", letter(line), rows[0], rows[1], letter(other), row),
          points.at(line, rows[0]), points.at(line, rows[1]), points.at(other, row)};
}

TEST(PointMacros, DistanceOfAPointFromALine) {
  for (unsigned round = 0; round < 2 * kRounds; ++round) {
    RandomPoints points(round);
    const LineAndPoint given = named(points, round);
    const int in_plane = points.below(4);
    const int row = 1 + points.below(5);
    const std::string call = fmt::format("G131 {} S{} D{}. W1.", given.words, in_plane, row);
    SCOPED_TRACE(call);
    const auto line = Eigen::ParametrizedLine<double, 3>::Through(given.from, given.to);
    const Vector3d square = given.point - line.projection(given.point);

    const RunOutput output = points.program.run(call);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_LT((point_of(output, 109, row) - square).norm(), 1e-9);
    double distance = line.distance(given.point);
    if (in_plane > 0) {
      const auto flat = Eigen::Hyperplane<double, 2>::Through(seen(given.from, in_plane - 1),
                                                              seen(given.to, in_plane - 1));
      distance = flat.absDistance(seen(given.point, in_plane - 1));
    }
    EXPECT_NEAR(value_of(output, 154 + row).value(), distance, 1e-9);
  }
}

}  // namespace
}  // namespace g31::point_macros_test
