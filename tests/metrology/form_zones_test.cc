// Zones against brute force, closed forms and long double.

#include "probe/metrology/form_zones.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/units/point.h"
#include "probe/metrology/minimax_fit.h"
#include "tests/support/effort.h"

namespace g31::form_zones_test {
namespace {

double between(double low, double high, std::uint64_t seed, std::uint64_t which) {
  return low + (high - low) * uniform(Stream{seed, 5}, which);
}

/// The smallest strip: one of its sides holds two of the points.
double smallest_strip(const std::vector<double>& x, const std::vector<double>& y) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const double slope = (y[j] - y[i]) / (x[j] - x[i]);
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      for (std::size_t k = 0; k < x.size(); ++k) {
        low = std::min(low, y[k] - slope * x[k]);
        high = std::max(high, y[k] - slope * x[k]);
      }
      least = std::min(least, high - low);
    }
  }
  return least;
}

/// The range about the line of least squares, in long double.
double range_about_line(const std::vector<double>& x, const std::vector<double>& y) {
  long double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    n += 1;
    sx += x[k];
    sy += y[k];
    sxx += static_cast<long double>(x[k]) * x[k];
    sxy += static_cast<long double>(x[k]) * y[k];
  }
  const long double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  long double low = HUGE_VALL, high = -HUGE_VALL;
  for (std::size_t k = 0; k < x.size(); ++k) {
    low = std::min(low, y[k] - slope * x[k]);
    high = std::max(high, y[k] - slope * x[k]);
  }
  return static_cast<double>(high - low);
}

TEST(Straightness, IsThatOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::vector<double> x;
    std::vector<double> y;
    const auto count = static_cast<std::uint64_t>(between(2.0, 40.0, seed, 0));
    for (std::uint64_t k = 0; k < count; ++k) {
      x.push_back(100.0 * static_cast<double>(k) + (seed % 3 == 0 ? 5e5 : 0.0));
      // Ties and collinear points as well: rounded to few values.
      const double value = between(-0.01, 0.01, seed, k + 1);
      y.push_back(seed % 2 == 0 ? value : std::round(value * 300.0) / 300.0);
    }
    const auto zones = metrology::straightness_of(x, y);
    EXPECT_NEAR(zones.minimum_zone, smallest_strip(x, y), 1e-12) << seed;
    EXPECT_NEAR(zones.least_squares, range_about_line(x, y), 1e-12) << seed;
    EXPECT_LE(zones.minimum_zone, zones.least_squares + 1e-15);
    EXPECT_LE(zones.minimum_zone, zones.end_points + 1e-15);
  }
}

TEST(Straightness, OfABowIsItsClosedForm) {
  std::vector<double> x;
  std::vector<double> y;
  for (int k = 0; k <= 100; ++k) {
    x.push_back(k);
    y.push_back(0.01 * (1.0 - (k / 50.0 - 1.0) * (k / 50.0 - 1.0)) + 0.003 * k);
  }
  const auto zones = metrology::straightness_of(x, y);
  EXPECT_NEAR(zones.end_points, 0.01, 1e-15);
  EXPECT_NEAR(zones.minimum_zone, 0.01, 1e-15);
}

/// The smallest distance of two parallel planes: of each four points, or of three and one.
double smallest_slab(const Eigen::MatrixX3d& p) {
  double least = HUGE_VAL;
  const auto slopes = [&](const Point& u, const Point& v) {
    const Point normal = u.cross(v);
    if (normal.norm() > 1e-9 * u.norm() * v.norm()) {
      const Eigen::VectorXd off = p * normal.normalized();
      least = std::min(least, off.maxCoeff() - off.minCoeff());
    }
  };
  const auto at = [&](Eigen::Index i) -> Point { return p.row(i).transpose(); };
  for (Eigen::Index i = 0; i < p.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < p.rows(); ++j) {
      for (Eigen::Index k = 0; k < p.rows(); ++k) {
        for (Eigen::Index l = k + 1; l < p.rows(); ++l) {
          slopes(at(j) - at(i), at(l) - at(k));  // an edge above, an edge below; or a face
        }
      }
    }
  }
  return least;
}

TEST(Flatness, IsThatOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const bool is_grid = seed % 2 == 0;
    Eigen::MatrixX3d p(is_grid ? 16 : 14, 3);
    for (Eigen::Index i = 0; i < p.rows(); ++i) {
      const auto which = static_cast<std::uint64_t>(i);
      const double z = between(-0.01, 0.01, seed, 3 * which + 2);
      p.row(i) << (is_grid ? 100.0 * static_cast<double>(i % 4) : between(0, 500, seed, 3 * which)),
          (is_grid ? 80.0 * static_cast<double>(i / 4) : between(0, 500, seed, 3 * which + 1)),
          (seed % 4 == 0 ? std::round(z * 300.0) / 300.0 : z) + 0.02 * static_cast<double>(i % 4);
    }
    const auto zones = metrology::flatness_of(p);
    ASSERT_TRUE(zones.has_value());
    EXPECT_NEAR(zones->zones.minimum_zone, smallest_slab(p), 1e-12) << seed;
    EXPECT_GE(zones->zones.least_squares, zones->zones.minimum_zone - 1e-15);
  }
}

/// Few points anywhere, which are no face: the smallest of several zones.
TEST(Flatness, OfWhatIsNoFaceIsThatOfBruteForce) {
  for (std::uint64_t seed = 1; seed <= testing::of_many(400U); ++seed) {
    Eigen::MatrixX3d p(static_cast<Eigen::Index>(4 + seed % 9), 3);
    const double height = std::pow(10.0, between(-1.5, 0.0, seed, 0)) * 100.0;
    for (Eigen::Index i = 0; i < p.rows(); ++i) {
      const auto which = static_cast<std::uint64_t>(3 * i);
      p.row(i) << between(-100, 100, seed, which + 1), between(-100, 100, seed, which + 2),
          between(-height, height, seed, which + 3);
    }
    const auto found = metrology::flatness_of(p);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->zones.minimum_zone, smallest_slab(p), 1e-9) << seed;
    // Of least squares: square to the plane of the smallest variance.
    const Eigen::MatrixX3d off = p.rowwise() - p.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(off.transpose() * off);
    const Eigen::VectorXd heights = off * spread.eigenvectors().col(0);
    EXPECT_NEAR(found->zones.least_squares, heights.maxCoeff() - heights.minCoeff(), 1e-9) << seed;
  }
}

/// Some turn: of a wall, of a sloping face, of one upside down.
Eigen::Quaterniond turn_of(std::uint64_t which) {
  if (which == 0) {
    return Eigen::Quaterniond(std::numbers::sqrt2 / 2.0, 0.0, std::numbers::sqrt2 / 2.0, 0.0);
  }
  Eigen::Quaterniond turn(between(-1, 1, 9, 4 * which), between(-1, 1, 9, 4 * which + 1),
                          between(-1, 1, 9, 4 * which + 2), between(-1, 1, 9, 4 * which + 3));
  return turn.normalized();
}

TEST(Flatness, OfASaddleOnAGridIsItsClosedForm) {
  // z = h x y on a grid of -1 .. 1: no plane does better than z = 0.
  Eigen::MatrixX3d p(21 * 21, 3);
  for (int i = 0; i < 21; ++i) {
    for (int j = 0; j < 21; ++j) {
      const double x = 0.1 * i - 1.0;
      const double y = 0.1 * j - 1.0;
      p.row(21 * i + j) << 300.0 * x, 300.0 * y, 0.007 * x * y;
    }
  }
  p = (p * turn_of(1).toRotationMatrix().transpose()).eval();
  const auto zones = metrology::flatness_of(p);
  ASSERT_TRUE(zones.has_value());
  EXPECT_NEAR(zones->zones.minimum_zone, 0.014, 1e-12);
  EXPECT_NEAR(zones->zones.least_squares, 0.014, 1e-12);
  EXPECT_FALSE(metrology::flatness_of(Eigen::MatrixX3d::Zero(5, 3)).has_value());
  p.col(2).setConstant(1.0);
  EXPECT_NEAR(metrology::flatness_of(p)->zones.minimum_zone, 0.0, 1e-12);
}

TEST(Flatness, IsSquareToTheFaceHoweverItLies) {
  for (std::uint64_t which = 0; which < 20; ++which) {
    Eigen::MatrixX3d flat(16, 3);
    for (Eigen::Index i = 0; i < flat.rows(); ++i) {
      const auto at = static_cast<std::uint64_t>(3 * i);
      flat.row(i) << between(-80, 80, 40 + which, at), between(-30, 30, 40 + which, at + 1),
          between(-0.02, 0.02, 40 + which, at + 2);
    }
    const Eigen::MatrixX3d turned =
        (flat * turn_of(which).toRotationMatrix().transpose()).rowwise() +
        Eigen::RowVector3d(300.0, -20.0, 110.0);
    // Of least squares: square to the plane of the smallest variance.
    const Eigen::MatrixX3d off = turned.rowwise() - turned.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(off.transpose() * off);
    const Eigen::VectorXd heights = off * spread.eigenvectors().col(0);
    const auto found = metrology::flatness_of(turned);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->zones.least_squares, heights.maxCoeff() - heights.minCoeff(), 1e-12);
    EXPECT_NEAR(found->zones.minimum_zone, smallest_slab(flat), 1e-12) << which;
    EXPECT_NEAR(found->deviations.maxCoeff(), 0.5 * found->zones.minimum_zone, 1e-12);
    EXPECT_NEAR(found->deviations.minCoeff(), -0.5 * found->zones.minimum_zone, 1e-12);
  }
}

TEST(Flatness, OfAWallByHand) {
  Eigen::MatrixX3d wall(6, 3);
  wall << 0.01, 0, 0, 0, 50, 0, 0, 0, 50, 0.01, 50, 50, 0, 100, 25, 0, 25, 100;
  const auto zones = metrology::flatness_of(wall)->zones;
  EXPECT_NEAR(zones.minimum_zone, 0.010, 1e-6);
  Eigen::MatrixX3d slope(9, 3);
  slope << 0, 0, 0, 50, 0, 50, 100, 0, 100, 0, 50, 0.02, 50, 50, 50.02, 100, 50, 100, 0, 100, 0, 50,
      100, 50, 100, 100, 100.02;
  EXPECT_NEAR(metrology::flatness_of(slope)->zones.minimum_zone, 0.02 / std::numbers::sqrt2, 1e-6);
}

/// A valley along y on a face that lies as `turn` says, its rows from left or from right.
Eigen::VectorXd deviations_of_valley(const Eigen::Matrix3d& turn, bool from_right) {
  Eigen::MatrixX3d valley(9, 3);
  for (int i = 0; i < 9; ++i) {
    const int column = from_right ? 2 - i % 3 : i % 3;
    const double z = column == 1 ? 0.0 : 0.004;
    valley.row(i) = (turn * Eigen::Vector3d(50.0 * column, 50.0 * (i / 3), z)).transpose();
  }
  return metrology::flatness_of(valley)->deviations;
}

// The edges are high, the middle is low, whichever way the rows go.
TEST(Flatness, DeviationsArePositiveOutOfTheFaceInAnyOrderOfItsPoints) {
  const Eigen::Matrix3d as_it_is = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d towards_x;  // columns: where x, y and z of the valley point
  towards_x << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  Eigen::Matrix3d towards_y;
  towards_y << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  for (const Eigen::Matrix3d& turn : {as_it_is, towards_x, towards_y}) {
    for (const bool from_right : {false, true}) {
      const Eigen::VectorXd deviations = deviations_of_valley(turn, from_right);
      for (int i = 0; i < 9; ++i) {
        EXPECT_NEAR(deviations[i], i % 3 == 1 ? -0.002 : 0.002, 1e-12) << from_right << " " << i;
      }
    }
  }
}

TEST(Flatness, OfPointsOnALineIsNone) {
  Eigen::MatrixX3d line(5, 3);
  for (int i = 0; i < 5; ++i) {
    line.row(i) << 10.0 * i + 0.3, 7.0 * i, -3.0 * i;
  }
  EXPECT_FALSE(metrology::flatness_of(line).has_value());
}

/// A surface of given radii about a line near z.
Eigen::MatrixX3d turned(const Eigen::Vector3d& at, const Eigen::Vector3d& along, double radius,
                        double (*error)(double angle, double z)) {
  const Eigen::Vector3d direction = along.normalized();
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction);
  Eigen::MatrixX3d points(36 * 11, 3);
  for (int i = 0; i < 36; ++i) {
    for (int k = 0; k < 11; ++k) {
      const double angle = i * std::numbers::pi / 18.0;
      const double z = 40.0 * k - 200.0;
      const double r = radius + error(angle, z);
      points.row(11 * i + k) =
          (at + turn * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z)).transpose();
    }
  }
  return points;
}

TEST(Cylindricity, KnowsNothingOfWhereTheAxisIs) {
  const auto round = metrology::cylindricity_of(
      turned({0.08, -0.05, 0.0}, {0.004, -0.007, 1.0}, 10.0, [](double, double) { return 0.0; }));
  ASSERT_TRUE(round.has_value());
  EXPECT_NEAR(round->zones.least_squares, 0.0, 1e-9);
  EXPECT_NEAR(round->zones.minimum_zone, 0.0, 1e-9);
  // Thick in the middle: no axis does better than the middle.
  const auto barrel =
      metrology::cylindricity_of(turned({0.05, 0.02, 3.0}, {0.001, 0.002, 1.0}, 10.0,
                                        [](double, double z) { return -0.008 * z * z / 4e4; }));
  EXPECT_NEAR(barrel->zones.minimum_zone, 0.008, 1e-9);
  EXPECT_NEAR(barrel->zones.least_squares, 0.008, 1e-9);
  // The deviations are those of the form, about their mean: the mean of s^2 over eleven places is
  // 0.4.
  for (int i = 0; i < 36; ++i) {
    for (int k = 0; k < 11; ++k) {
      const double s = k / 5.0 - 1.0;
      EXPECT_NEAR(barrel->deviations[11 * i + k], 0.008 * (0.4 - s * s), 1e-9) << i << " " << k;
    }
  }
  // Three lobes twist along the work: the zone is twice their height.
  const auto lobes = metrology::cylindricity_of(
      turned({0.05, 0.02, 3.0}, {0.001, 0.002, 1.0}, 10.0,
             [](double angle, double) { return 0.003 * std::cos(3.0 * angle); }));
  EXPECT_NEAR(lobes->zones.minimum_zone, 0.006, 1e-9);
}

/// How far apart the nearest and the farthest of the points are from the line through (x, y) at
/// z = 0 with the slopes of its direction.
double zone_about(const Eigen::MatrixX3d& points, const Eigen::Vector4d& line) {
  const Point along = Point(line[2], line[3], 1.0).normalized();
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Point q = points.row(i).transpose() - Point(line[0], line[1], 0.0);
    const double r = q.cross(along).norm();
    low = std::min(low, r);
    high = std::max(high, r);
  }
  return high - low;
}

/// Steps in random directions from random places, shorter where none helps.
double searched_zone(const Eigen::MatrixX3d& points, double form, double length,
                     std::uint64_t seed) {
  double least = HUGE_VAL;
  std::uint64_t which = 0;
  const auto any = [&](double size) { return between(-size, size, 1000 + seed, ++which); };
  for (int start = 0; start < 40; ++start) {
    Eigen::Vector4d line(any(form), any(form), any(form) / length, any(form) / length);
    double here = zone_about(points, line);
    for (double size = form; size > 1e-7 * form;) {
      bool is_better = false;
      for (int i = 0; i < 40 && !is_better; ++i) {
        const Eigen::Vector4d next =
            line + Eigen::Vector4d(any(size), any(size), any(size) / length, any(size) / length);
        const double there = zone_about(points, next);
        is_better = there < here;
        if (is_better) {
          line = next;
          here = there;
        }
      }
      size *= is_better ? 1.5 : 0.5;
    }
    least = std::min(least, here);
  }
  return least;
}

TEST(Cylindricity, OfCoarseFormIsTheSmallestZone) {
  for (std::uint64_t seed = 1; seed <= testing::of_many(40U); ++seed) {
    const auto levels = static_cast<int>(2 + seed % 3);
    const int angles = seed % 2 == 0 ? 4 : 7;
    const double form = 10.0 * std::pow(10.0, between(-2.0, -0.3, seed, 0));
    Eigen::MatrixX3d points(levels * angles, 3);
    for (int i = 0; i < points.rows(); ++i) {
      const double angle = 2.0 * std::numbers::pi * (i % angles) / angles;
      const double r = 10.0 + between(-form, form, seed, static_cast<std::uint64_t>(i) + 1);
      points.row(i) << r * std::cos(angle), r * std::sin(angle), 20.0 * (i / angles) - 20.0;
    }
    const auto found = metrology::cylindricity_of(points);
    ASSERT_TRUE(found.has_value());
    const double searched = searched_zone(points, form, 20.0, seed);
    EXPECT_LE(found->zones.minimum_zone, searched + 1e-9) << seed;
  }
}

TEST(Cylindricity, HasASmallerZoneThanLeastSquares) {
  const auto found = metrology::cylindricity_of(
      turned({0.01, 0.0, 0.0}, {0.0, 0.001, 1.0}, 10.0, [](double angle, double z) {
        return 0.004 * std::exp(-8.0 * (1.0 - std::cos(angle))) * (z > 100.0 ? 1.0 : 0.0);
      }));
  ASSERT_TRUE(found.has_value());
  EXPECT_LT(found->zones.minimum_zone, found->zones.least_squares);
  EXPECT_LT(found->zones.minimum_zone, 0.004);
  Eigen::MatrixX3d line(8, 3);
  for (int i = 0; i < 8; ++i) {
    line.row(i) << 10.0, 0.0, i;
  }
  EXPECT_FALSE(metrology::cylindricity_of(line).has_value());
}

}  // namespace
}  // namespace g31::form_zones_test
