// Ways that lead into a circle and out of it at a tangent, standstills amid it and errors of form:
// what belongs to the circle, and that nothing else counts.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "probe/metrology/circle_evaluation.h"
#include "probe/metrology/circle_standstills.h"

namespace g31::circle_leads_test {
namespace {

using metrology::CircleEvaluation;
using metrology::kDegree;

constexpr double kPi = std::numbers::pi;

/// A path at 20 mm/s, a sample each ms.
struct Path {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;

  void add(double at_x, double at_y) {
    t.push_back(1e-3 * static_cast<double>(t.size()));
    x.push_back(at_x);
    y.push_back(at_y);
  }
  /// Counter-clockwise where the angle rises.
  void arc(const Eigen::Vector2d& centre, double radius, double from, double to) {
    const int steps = std::max(1, static_cast<int>(radius * std::abs(to - from) / kStep));
    for (int i = 0; i < steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      add(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle));
    }
  }
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const int steps = std::max(1, static_cast<int>((to - from).norm() / kStep));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d p = from + (to - from) * i / steps;
      add(p.x(), p.y());
    }
  }
  [[nodiscard]] CircleEvaluation evaluated(std::optional<double> radius) const {
    const auto made = metrology::evaluate_circle({t, x, y}, {radius, {}, 0.0});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error());
    return made.ok() ? made.value() : CircleEvaluation();
  }

  static constexpr double kStep = 0.02;
};

std::size_t samples_of(const CircleEvaluation& circle) {
  std::size_t all = 0;
  for (const metrology::CircleTurn& turn : circle.turns) {
    all += turn.end - turn.begin;
  }
  return all;
}

void expect_no_errors(const CircleEvaluation& circle) {
  EXPECT_LT(circle.radial_error.width(), 1e-8);
  EXPECT_LT(circle.minimum_zone.value_or(1.0), 1e-8);
  EXPECT_NEAR(circle.mean_radial_error, 0.0, 1e-9);
  EXPECT_NEAR(circle.reference.centre.norm(), 0.0, 1e-9);
  for (const std::size_t axis : {0U, 1U}) {
    EXPECT_NEAR(circle.fit.errors.backlash.at(axis), 0.0, 1e-9);
    EXPECT_NEAR(circle.fit.errors.scale.at(axis), 0.0, 1e-10);
  }
  EXPECT_NEAR(circle.fit.errors.squareness, 0.0, 1e-10);
  EXPECT_NEAR(circle.fit.errors.mismatch, 0.0, 1e-10);
}

/// Quarter arcs of a fifth of the radius, half arcs of three quarters of it, arcs that bend the
/// other way and tangents, of one turn and of both ways round: an ideal path has no errors.
TEST(CircleLeads, DoNotCount) {
  constexpr double kRadius = 50.0;
  for (const double lead : {10.0, 25.0, 37.5, 42.0, -10.0, -40.0, 0.0}) {
    for (const double start : {0.0, 0.5 * kPi, 2.2}) {
      for (const bool both : {false, true}) {
        Path path;
        for (const double way : both ? std::vector{1.0, -1.0} : std::vector{1.0}) {
          const Eigen::Vector2d out(std::cos(start), std::sin(start));
          const Eigen::Vector2d along = way * Eigen::Vector2d(-out.y(), out.x());
          const Eigen::Vector2d at = kRadius * out;
          const Eigen::Vector2d middle = (kRadius - lead) * out;
          const double from = lead > 0.0 ? start : start + kPi;
          const double turn = lead > 0.0 ? way * kPi : -way * kPi;
          if (lead != 0.0) {
            path.arc(middle, std::abs(lead), from - turn, from);
          } else {
            path.line(at - 30.0 * along, at);
          }
          path.arc({0.0, 0.0}, kRadius, start, start + way * 2.0 * kPi);
          if (lead != 0.0) {
            path.arc(middle, std::abs(lead), from, from + turn);
          } else {
            path.line(at, at + 30.0 * along);
          }
        }
        SCOPED_TRACE(::testing::Message() << "lead " << lead << " start " << start << both);
        const CircleEvaluation circle = path.evaluated(kRadius);
        expect_no_errors(circle);
        EXPECT_EQ(circle.fit.has_mismatch, both);
        // Nearly all of the circle does: ends that fall below a nanometre cannot be told.
        const double whole = (both ? 2.0 : 1.0) * 2.0 * kPi * kRadius / Path::kStep;
        EXPECT_NEAR(static_cast<double>(samples_of(circle)), whole, 0.01 * whole);
      }
    }
  }
}

/// Out of the circle by 11 degrees of its tangent and back: of the two pieces neither is a turn
/// of its own.
TEST(CircleLeads, OfAStraightWayThereAndBackDoNotCount) {
  for (const double length : {10.0, 4.0, 1.5}) {
    Path path;
    path.line({50.0, 0.0}, {50.0, -length});
    path.line({50.0, -length}, {50.0, 0.0});
    path.arc({0.0, 0.0}, 50.0, 0.0, 2.0 * kPi);
    const CircleEvaluation circle = path.evaluated(50.0);
    SCOPED_TRACE(length);
    expect_no_errors(circle);
    EXPECT_FALSE(circle.cw.has_value());
  }
}

/// An arc of less than a turn keeps its ends, and loses what leads to it.
TEST(CircleLeads, OfAnArcDoNotCount) {
  constexpr double kFrom = 20.0 * kDegree;
  constexpr double kTo = 265.0 * kDegree;
  Path path;
  const Eigen::Vector2d first(std::cos(kFrom), std::sin(kFrom));
  const Eigen::Vector2d last(std::cos(kTo), std::sin(kTo));
  path.arc(30.0 * first, 20.0, kFrom - 0.5 * kPi, kFrom);
  path.arc({0.0, 0.0}, 50.0, kFrom, kTo);
  path.arc(30.0 * last, 20.0, kTo, kTo + 0.5 * kPi);
  path.arc(30.0 * last, 20.0, kTo + 0.5 * kPi, kTo);
  path.arc({0.0, 0.0}, 50.0, kTo, kFrom);
  path.arc(30.0 * first, 20.0, kFrom, kFrom - 0.5 * kPi);
  const CircleEvaluation circle = path.evaluated(50.0);
  expect_no_errors(circle);
  const double whole = 2.0 * 50.0 * (kTo - kFrom) / Path::kStep;
  EXPECT_NEAR(static_cast<double>(samples_of(circle)), whole, 0.01 * whole);
}

/// The path of axes that lag behind by their time constants, in closed form: from rest, along arcs,
/// with a pause behind each.
class LaggingPath {
 public:
  static constexpr double kRadius = 50.0;
  static constexpr double kOmega = 2000.0 / 60.0 / kRadius;
  static constexpr double kLagX = 60.0 / 1800.0;
  static constexpr double kLagY = 60.0 / 1900.0;

  /// @param angle  of the arc, rad; negative: clockwise  @param pause_s  behind it
  void arc(double angle, double pause_s) {
    const double omega = angle < 0.0 ? -kOmega : kOmega;
    const double from = angle_;
    const double moved = angle / omega;
    go(moved, [&](double time, double lag, bool is_x) {
      // q' = (c - q) / lag with c = R exp(i (from + omega t)), its real or imaginary part.
      const auto steady = [&](double at) {
        const std::complex<double> q =
            kRadius * std::polar(1.0, from + omega * at) / std::complex<double>(1.0, omega * lag);
        return is_x ? q.real() : q.imag();
      };
      const double start = is_x ? q_.x() : q_.y();
      return steady(time) + (start - steady(0.0)) * std::exp(-time / lag);
    });
    angle_ += angle;
    go(pause_s, [&](double time, double lag, bool is_x) {
      const double end = kRadius * (is_x ? std::cos(angle_) : std::sin(angle_));
      return end + ((is_x ? q_.x() : q_.y()) - end) * std::exp(-time / lag);
    });
  }
  [[nodiscard]] const Path& path() const { return path_; }

 private:
  template <typename At>
  void go(double time, At at) {
    const int steps = static_cast<int>(std::round(time / 1e-3));
    for (int i = 0; i < steps; ++i) {
      const double now = time * i / steps;
      path_.t.push_back(time_ + now);
      path_.x.push_back(at(now, kLagX, true));
      path_.y.push_back(at(now, kLagY, false));
    }
    q_ = {at(time, kLagX, true), at(time, kLagY, false)};
    time_ += time;
  }

  Path path_;
  Eigen::Vector2d q_{kRadius, 0.0};
  double angle_ = 0.0;
  double time_ = 0.0;
};

/// Of whole turns, half ones and quarters with pauses of up to 2 s between them the mismatch is
/// what the two axes truly lag by, and the squareness is none.
TEST(CircleStandstills, DoNotChangeTheMismatch) {
  const double omega = LaggingPath::kOmega;
  const double truth =
      (std::atan(omega * LaggingPath::kLagX) - std::atan(omega * LaggingPath::kLagY)) / omega;
  for (const double part : {360.0, 180.0, 90.0, 120.0}) {
    for (const double pause_s : {0.25, 0.3, 2.0}) {
      LaggingPath path;
      for (const double way : {1.0, -1.0}) {
        for (int i = 0; i < (part < 360.0 ? 360.0 / part : 2); ++i) {
          path.arc(way * part * kDegree, pause_s);
        }
      }
      SCOPED_TRACE(::testing::Message() << part << " degrees, " << pause_s << " s");
      const CircleEvaluation circle = path.path().evaluated(LaggingPath::kRadius);
      ASSERT_TRUE(circle.fit.has_mismatch);
      EXPECT_NEAR(circle.fit.errors.mismatch, truth, 2e-7);
      EXPECT_NEAR(circle.fit.errors.squareness, 0.0, 2e-7);
      EXPECT_LT(circle.fit.u.mismatch, 2e-6);
      // The same as without pauses: the parts make a whole turn.
      EXPECT_NEAR(circle.reference.centre.norm(), 0.0, 2e-4);
    }
  }
}

TEST(CircleStandstills, AreFoundInTheirMiddle) {
  std::vector<double> t;
  std::vector<double> way;
  double time = 0.0;
  // A quarter, a pause, 20 degrees, a pause that comes too soon behind the other, another quarter.
  const auto go = [&](double from, double to) {
    const int steps = to > from ? static_cast<int>(10.0 * (to - from)) : 1000;
    for (int i = 0; i < steps; ++i) {
      t.push_back(time += 1e-3);
      way.push_back((from + (to - from) * i / steps) * kDegree);
    }
  };
  go(0.0, 90.0);
  go(90.0, 90.0);
  go(90.0, 110.0);
  go(110.0, 110.0);
  go(110.0, 200.0);
  const auto found = metrology::standstills(t, way);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(static_cast<double>(found[0]), 1400.0, 5.0);
}

/// An ellipse is all there, however large the difference of its axes: R (1 + e cos 2 theta) within
/// 2 e R, and its minimum zone, too.
TEST(CircleForm, OfAnEllipseCountsAsAWhole) {
  constexpr double kRadius = 10.0;
  constexpr int kTurn = 3600;
  for (const double share : {0.003, 0.0065, 0.01, 0.02, 0.03, 0.05}) {
    for (const int arc : {360, 220}) {
      Path path;
      const int half = kTurn * arc / 360;
      for (int i = 0; i <= 2 * half; ++i) {
        const double theta = 0.5 + 2.0 * kPi * (i <= half ? i : 2 * half - i) / kTurn;
        path.add(kRadius * (1.0 + share) * std::cos(theta),
                 kRadius * (1.0 - share) * std::sin(theta));
      }
      SCOPED_TRACE(::testing::Message() << share << ' ' << arc);
      const CircleEvaluation circle = path.evaluated({});
      EXPECT_GT(static_cast<double>(samples_of(circle)), 0.995 * static_cast<double>(2 * half));
      EXPECT_NEAR(circle.fit.errors.scale[0], share, 1e-9);
      EXPECT_NEAR(circle.fit.errors.scale[1], -share, 1e-9);
      EXPECT_NEAR(circle.fit.errors.backlash[0], 0.0, 1e-9);
      EXPECT_NEAR(circle.radial_error.width(), 2.0 * share * kRadius, 1e-4 * kRadius * share);
      if (arc == 360) {
        EXPECT_NEAR(circle.minimum_zone.value_or(0.0), 2.0 * share * kRadius,
                    1e-4 * kRadius * share);
        EXPECT_NEAR(circle.mean_radial_error, 0.0, 1e-9);
      }
    }
  }
}

/// Of two circles about one centre, 4 percent apart, the one that more of the path runs along.
TEST(CircleForm, OfAnotherCircleDoesNotCount) {
  Path path;
  path.arc({0.0, 0.0}, 48.0, 0.0, 2.0 * kPi);
  path.line({48.0, 0.0}, {50.0, 0.0});
  path.arc({0.0, 0.0}, 50.0, 0.0, 4.0 * kPi);
  expect_no_errors(path.evaluated(50.0));
}

}  // namespace
}  // namespace g31::circle_leads_test
