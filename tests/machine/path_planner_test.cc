// The speed along paths of many ways.  Times are closed forms: each way at its feed, one ramp from
// rest and to rest, and for each corner what slowing down to its speed costs.

#include "machine/sim/path_planner.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace g31::machine::path_planner_test {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Of each axis, mm and s.
struct Axes {
  double acceleration;
  double jerk;
  double jump;  ///< the speed that an axis may change at once
};

struct Way {
  double length;
  PathLimits limits;
  double corner_speed;
};

std::vector<Way> ways_of(const Points& points, double feed, const Axes& axes) {
  std::vector<Way> ways;
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector2d way = points[i] - points[i - 1];
    const Eigen::Vector2d along = way / way.norm();
    const double most = along.cwiseAbs().maxCoeff();
    const double turn = i > 1 ? (along - before).cwiseAbs().maxCoeff() : 0.0;
    ways.push_back({way.norm(),
                    {feed, axes.acceleration / most, axes.jerk / most},
                    turn > 0.0 ? axes.jump / turn : kInfinite});
    before = along;
  }
  return ways;
}

enum class Release { AtOnce, AtTheEnd };

double planned_s(const std::vector<Way>& ways, Release when = Release::AtOnce) {
  PathPlanner planner;
  double seconds = 0.0;
  const auto add = [&](std::span<const SpanMotion> spans) {
    for (const SpanMotion& span : spans) {
      seconds += span.duration_s();
    }
  };
  for (const Way& way : ways) {
    planner.add(way.length, way.limits, way.corner_speed);
    if (when == Release::AtOnce) {
      add(planner.release());
    }
  }
  const double rest_s = planner.duration_s();
  const double before_s = seconds;
  add(planner.finish());
  EXPECT_NEAR(rest_s, seconds - before_s, 1e-12 * seconds);
  EXPECT_TRUE(planner.is_empty());
  return seconds;
}

Points line_of(int blocks) {
  Points points;
  for (int i = 0; i <= blocks; ++i) {
    points.emplace_back(100.0 * i / blocks, 0.0);
  }
  return points;
}
const Points kSquare = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}};
Points zigzag() {
  Points points;
  for (int i = 0; i <= 40; ++i) {
    points.emplace_back(5.0 * i, i % 2 == 0 ? 0.0 : 5.0);
  }
  return points;
}

struct Case {
  const char* name;
  Points points;
  double jump;
  double seconds[3];  ///< a 2000; a 5000 and jerk 50000; a 5000
};

TEST(PathPlanner, TakesTheTimesOfTheWorkedPaths) {
  const double kF3000 = 50.0;
  const Case kCases[] = {
      {"100 mm in one block", line_of(1), 0.0, {2.025000, 2.063246, 2.010000}},
      {"in a thousand", line_of(1000), 0.0, {2.025000, 2.063246, 2.010000}},
      {"square with stops", kSquare, 0.0, {8.100000, 8.252982, 8.040000}},
      {"400 mm/min", kSquare, 400.0 / 60.0, {8.081333, 8.216329, 8.032533}},
      {"1000 mm/min", kSquare, 1000.0 / 60.0, {8.058333, 8.166525, 8.023333}},
      {"without slowing", kSquare, kInfinite, {8.025000, 8.063246, 8.010000}},
      {"zigzag with stops", zigzag(), 0.0, {6.363961, 7.784173, 5.939697}},
      {"400 mm/min", zigzag(), 400.0 / 60.0, {6.240089, 7.497872, 5.890148}},
      {"1000 mm/min", zigzag(), 1000.0 / 60.0, {6.077263, 7.095934, 5.825018}},
  };
  const Axes kAxes[] = {{2000, 0, 0}, {5000, 50000, 0}, {5000, 0, 0}};
  for (const Case& c : kCases) {
    for (std::size_t i = 0; i < 3; ++i) {
      SCOPED_TRACE(c.name + std::to_string(i));
      const auto ways = ways_of(c.points, kF3000, {kAxes[i].acceleration, kAxes[i].jerk, c.jump});
      const double seconds = planned_s(ways);
      EXPECT_NEAR(seconds, c.seconds[i], 1e-6);
      // The closed form, where every way is long enough for its ramps.
      double form = ramp_s(kF3000, ways.front().limits);
      for (std::size_t k = 0; k < ways.size(); ++k) {
        form += ways[k].length / kF3000;
        const double corner = k > 0 ? std::min(kF3000, ways[k].corner_speed) : kF3000;
        form += (1.0 - corner / kF3000) * ramp_s(kF3000 - corner, ways[k].limits);
      }
      EXPECT_NEAR(seconds, form, kPathPlannerError * form);
    }
  }
}

// Beside the closed forms of their own: LinuxCNC 2.9.0~pre1 with a period of 1 ms, 5000 mm/s^2 and
// no jerk.
TEST(PathPlanner, IsAsFastAsLinuxCnc) {
  const Axes kAxes = {5000, 0, 0};
  const auto ratio = [&](const Points& points, double jump, double linux_cnc_s) {
    return planned_s(ways_of(points, 50.0, {kAxes.acceleration, kAxes.jerk, jump})) / linux_cnc_s;
  };
  EXPECT_NEAR(ratio(line_of(1), 0.0, 2.022), 1.0, 0.015);
  EXPECT_NEAR(ratio(line_of(1000), 0.0, 2.018), 1.0, 0.015);
  EXPECT_NEAR(ratio(kSquare, 0.0, 8.050), 1.0, 0.015);
  EXPECT_NEAR(ratio(zigzag(), 0.0, 6.002), 1.0, 0.015);
}

TEST(PathPlanner, APolygonSlowsDownAsFarAsItsCornersSay) {
  Points circle;
  for (int i = 0; i <= 720; ++i) {
    const double angle = i * std::numbers::pi / 360.0;
    circle.emplace_back(50.0 * std::cos(angle), 50.0 * std::sin(angle));
  }
  const double kF2000 = 2000.0 / 60.0;
  for (const auto& [jump, seconds] : {std::pair(0.1, 13.5704), {0.2, 10.1083}, {0.3, 9.4414}}) {
    EXPECT_NEAR(planned_s(ways_of(circle, kF2000, {2000, 0, jump})), seconds, 5e-5) << jump;
  }
}

/// Random ways, some with the same limits in a row.
std::vector<Way> random_ways(std::mt19937& random, double jerk) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Way> ways;
  const int count = 1 + static_cast<int>(30.0 * unit(random));
  for (int i = 0; i < count; ++i) {
    Way way{std::pow(10.0, 4.0 * unit(random) - 3.0),
            {5.0 + 95.0 * unit(random), 500.0 + 4000.0 * unit(random), jerk},
            unit(random) < 0.3 ? kInfinite : 80.0 * unit(random) * unit(random)};
    if (i > 0 && unit(random) < 0.3) {
      way.limits = ways.back().limits;
    }
    ways.push_back(way);
  }
  return ways;
}

double ramp_way(double from, double to, const PathLimits& limits) {
  return 0.5 * (from + to) * ramp_s(std::abs(to - from), limits);
}

double bisected(double low, double high, const std::function<bool(double)>& fits) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

/// The second way: the speeds at the corners fall until no way is too short any more, each found by
/// halving; ways alike are put together first.
double relaxed_s(std::vector<Way> ways) {
  for (std::size_t i = 1; i < ways.size();) {
    Way& before = ways[i - 1];
    const bool alike = before.limits.speed == ways[i].limits.speed &&
                       before.limits.acceleration == ways[i].limits.acceleration;
    if (alike && ways[i].corner_speed >= before.limits.speed) {
      before.length += ways[i].length;
      ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  std::vector<double> speeds(ways.size() + 1, 0.0);
  for (std::size_t i = 1; i < ways.size(); ++i) {
    speeds[i] = std::min({ways[i].corner_speed, ways[i].limits.speed, ways[i - 1].limits.speed});
  }
  for (bool falls = true; falls;) {
    falls = false;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const auto reach = [&](double& fast, double slow) {
        if (fast > slow && ramp_way(slow, fast, ways[i].limits) > ways[i].length * (1 + 1e-14)) {
          fast = bisected(slow, fast, [&](double v) {
            return ramp_way(slow, v, ways[i].limits) <= ways[i].length;
          });
          falls = true;
        }
      };
      reach(speeds[i], speeds[i + 1]);
      reach(speeds[i + 1], speeds[i]);
    }
  }
  double seconds = 0.0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const PathLimits& limits = ways[i].limits;
    const auto ramps = [&](double v) {
      return ramp_way(speeds[i], v, limits) + ramp_way(v, speeds[i + 1], limits);
    };
    const double top = ramps(limits.speed) <= ways[i].length
                           ? limits.speed
                           : bisected(std::max(speeds[i], speeds[i + 1]), limits.speed,
                                      [&](double v) { return ramps(v) <= ways[i].length; });
    seconds += ramp_s(top - speeds[i], limits) + ramp_s(top - speeds[i + 1], limits) +
               (ways[i].length - ramps(top)) / top;
  }
  return seconds;
}

TEST(PathPlanner, AgreesWithAnotherWayOfPlanning) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Way> ways = random_ways(random, i % 2 == 0 ? 0.0 : 30000.0);
    const double seconds = planned_s(ways);
    const double relaxed = relaxed_s(ways);
    // With jerk a corner may be faster once the one behind it has become slower, which speeds that
    // only fall do not find.
    ASSERT_LE(seconds, relaxed * (1.0 + 1e-9)) << i;
    ASSERT_GE(seconds, relaxed * (i % 2 == 0 ? 1.0 - 1e-9 : 0.998)) << i;
    ASSERT_NEAR(seconds, planned_s(ways, Release::AtTheEnd), 1e-12 * seconds) << i;
  }
}

TEST(PathPlanner, KeepsItsLimitsAndTheSpeedOfItsCorners) {
  std::mt19937 random(8);
  for (int i = 0; i < 200; ++i) {
    const std::vector<Way> ways = random_ways(random, i % 2 == 0 ? 0.0 : 30000.0);
    PathPlanner planner;
    double length = 0.0;
    for (const Way& way : ways) {
      planner.add(way.length, way.limits, way.corner_speed);
      length += way.length;
    }
    double gone = 0.0;
    double speed = 0.0;
    for (const SpanMotion& span : planner.finish()) {
      const MotionPhases phases = span.phases();
      ASSERT_NEAR(phases.phases().front().speed, speed, 1e-9);
      ASSERT_NEAR(phases.length(), span.length(), 1e-9 * (1.0 + span.length()));
      ASSERT_NEAR(phases.duration_s(), span.duration_s(), 1e-12);
      for (const MotionPhase& phase : phases.phases()) {
        speed = phase.speed_after(phase.duration_s);
        ASSERT_GE(speed, -1e-9);
        ASSERT_LE(speed, span.peak_speed() + 1e-9);
      }
      gone += span.length();
    }
    EXPECT_NEAR(speed, 0.0, 1e-9);
    EXPECT_NEAR(gone, length, 1e-9 * length);
  }
}

TEST(PathPlanner, FromRestToRestIsAMotionProfileBitForBit) {
  for (const double jerk : {0.0, 50000.0}) {
    const MotionProfile profile(17.3, 40.0, 1234.5, jerk);
    const SpanMotion span(17.3, {40.0, 1234.5, jerk}, 0.0, 0.0);
    EXPECT_EQ(span.duration_s(), profile.duration_s());
    EXPECT_EQ(span.time_at(3.3), profile.time_at(3.3));
    EXPECT_EQ(span.peak_speed(), profile.peak_speed());
  }
}

// What is kept does not grow with the path: a corner that can be passed settles all before it.
TEST(PathPlanner, GivesOutWhatNothingChangesAnyMore) {
  PathPlanner planner;
  std::size_t given = 0;
  for (int i = 0; i < 10'000; ++i) {
    planner.add(0.1, {50.0, 2000.0 + i % 2, 0.0}, 30.0);
    given += planner.release().size();
    // 30 mm/s are braked on 0.225 mm: three ways, and what comes until it is looked again.
    ASSERT_LE(static_cast<std::size_t>(i) + 1 - given, 8U);
  }
}

}  // namespace
}  // namespace g31::machine::path_planner_test
