// Squares and their speed, against closed forms of a lagging axis.

#include "probe/metrology/square_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "probe/metrology/path_speed.h"

namespace g31::square_path_test {
namespace {

using metrology::Square;
using metrology::SquareEvaluation;

struct Record {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] metrology::PlaneSamples samples() const { return {t, x, y}; }
};

/// A square of side 100 about a centre, from the middle of the +X side counter-clockwise, at a
/// constant speed of the command; every axis follows with a lag of the first order (0: at once).
Record recorded_square(double speed, double lag, const Eigen::Vector2d& centre, double interval) {
  const auto command = [&](double s) {
    const double a = 50.0;
    s = std::fmod(s, 400.0);
    return s < 50.0    ? Eigen::Vector2d(a, s)
           : s < 150.0 ? Eigen::Vector2d(100.0 - s, a)
           : s < 250.0 ? Eigen::Vector2d(-a, 200.0 - s)
           : s < 350.0 ? Eigen::Vector2d(s - 300.0, -a)
                       : Eigen::Vector2d(a, s - 400.0);
  };
  Record record;
  Eigen::Vector2d q = command(0.0);
  const int substeps = lag > 0.0 ? 50 : 1;
  const double step = interval / substeps;
  double time = 0.0;
  for (int i = 0; time * speed <= 401.0; ++i) {
    record.t.push_back(time);
    record.x.push_back(centre.x() + q.x());
    record.y.push_back(centre.y() + q.y());
    for (int k = 1; k <= substeps; ++k) {
      // The command runs straight within a step: the exact answer of the lag to a ramp.
      const Eigen::Vector2d from = command(speed * (time + (k - 1) * step));
      const Eigen::Vector2d to = command(speed * (time + k * step));
      if (lag == 0.0) {
        q = to;
        continue;
      }
      const Eigen::Vector2d rate = (to - from) / step;
      q = to - lag * rate + std::exp(-step / lag) * (q - from + lag * rate);
    }
    time = interval * (i + 1);
  }
  return record;
}

SquareEvaluation evaluated(const Record& record, const metrology::SquareRequest& request) {
  const auto made = metrology::evaluate_square(record.samples(), request);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error());
  return made.ok() ? made.value() : SquareEvaluation();
}

/// Ways to the square and away from it are none of it: 0.2 mm and 30 mm across the side where it
/// begins, both within the room beside it.
TEST(SquarePath, BeginsAndEndsWhereItRunsAlongASide) {
  for (const double lead : {0.2, 8.0, 30.0}) {
    const Record square = recorded_square(50.0, 0.0, {3.0, 4.0}, 1e-3);
    Record record;
    const auto add = [&](double x, double y) {
      record.t.push_back(1e-3 * static_cast<double>(record.t.size()));
      record.x.push_back(x);
      record.y.push_back(y);
    };
    constexpr int kLead = 200;
    for (int i = 0; i < kLead; ++i) {
      add(53.0 - lead * (kLead - i) / kLead, 4.0);
    }
    for (std::size_t i = 0; i < square.x.size(); ++i) {
      add(square.x[i], square.y[i]);
    }
    for (int i = 1; i <= kLead; ++i) {
      add(square.x.back() - lead * i / kLead, square.y.back());
    }
    const metrology::SampleRange range =
        evaluated(record, {100.0, Eigen::Vector2d(3.0, 4.0)}).on_square;
    EXPECT_EQ(range.begin, static_cast<std::size_t>(kLead)) << lead;
    // The command goes 1 mm beyond the start, and any sample of that is as near.
    EXPECT_NEAR(static_cast<double>(range.end), static_cast<double>(kLead + square.x.size()), 4.0)
        << lead;
  }
}

/// A straight way, both ends apart from the record's, a sample each 0.04 mm.
void add_way(Record& record, const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool has_end) {
  const int steps = static_cast<int>(std::ceil((to - from).norm() / 0.04));
  for (int i = has_end ? 1 : 0; i < (has_end ? steps + 1 : steps); ++i) {
    const Eigen::Vector2d p = from + (to - from) * i / steps;
    record.t.push_back(1e-3 * static_cast<double>(record.t.size()));
    record.x.push_back(p.x());
    record.y.push_back(p.y());
  }
}

/// A perfect square has no errors, wherever its record comes from and goes to: the centre, inside,
/// outside, along its first side from beyond a corner, a long way.
TEST(SquarePath, WaysThereAndAwayMoveNeitherItsCentreNorItsCorners) {
  const Record square = recorded_square(50.0, 0.0, {3.0, 4.0}, 1e-3);
  const Eigen::Vector2d start(53.0, 4.0);
  const Eigen::Vector2d end(square.x.back(), square.y.back());
  for (const Eigen::Vector2d& from :
       {Eigen::Vector2d(3.0, 4.0), Eigen::Vector2d(48.0, 4.0), Eigen::Vector2d(51.0, -20.0),
        Eigen::Vector2d(73.0, 4.0), Eigen::Vector2d(53.0, -96.0), Eigen::Vector2d(253.0, 4.0),
        Eigen::Vector2d(3.0, -96.0), Eigen::Vector2d(60.0, 60.0)}) {
    Record record;
    add_way(record, from, start, false);
    for (std::size_t i = 0; i < square.x.size(); ++i) {
      record.t.push_back(1e-3 * static_cast<double>(record.t.size()));
      record.x.push_back(square.x[i]);
      record.y.push_back(square.y[i]);
    }
    add_way(record, end, from, true);
    for (const metrology::SquareRequest& request :
         {metrology::SquareRequest{}, metrology::SquareRequest{100.0, std::nullopt},
          metrology::SquareRequest{100.0, Eigen::Vector2d(3.0, 4.0)}}) {
      const SquareEvaluation found = evaluated(record, request);
      EXPECT_NEAR((found.square.centre - Eigen::Vector2d(3.0, 4.0)).norm(), 0.0, 1e-6)
          << from.transpose();
      EXPECT_NEAR(found.square.half_side, 50.0, 1e-6) << from.transpose();
      for (const auto& error : found.corner_error) {
        ASSERT_TRUE(error.has_value()) << from.transpose();
        EXPECT_NEAR(*error, 0.0, 1e-6) << from.transpose();
      }
    }
  }
}

TEST(SquarePath, RayErrorsAreThoseOfThePaper) {
  const Square square{{0.0, 0.0}, 50.0};
  for (int degree = -179; degree <= 180; ++degree) {
    const double angle = degree * std::numbers::pi / 180.0;
    const Eigen::Vector2d p(47.0 * std::cos(angle), 47.0 * std::sin(angle));
    // Equations 18 and 24 with their conditions, as printed.
    const double a = 50.0;
    const bool is_first = (degree >= -45 && degree < 45) || degree >= 135 || degree < -135;
    const double tangent = std::tan(std::atan2(p.y(), p.x()));
    const double ideal = is_first ? std::sqrt(a * a + a * tangent * a * tangent)
                                  : std::sqrt(a / tangent * (a / tangent) + a * a);
    EXPECT_NEAR(square.ray_error(p), p.norm() - ideal, 1e-12) << degree;
  }
  EXPECT_DOUBLE_EQ(square.place_of({10.0, 5.0}), 25.0);
  EXPECT_DOUBLE_EQ(square.place_of({-5.0, 10.0}), 125.0);
  EXPECT_DOUBLE_EQ(square.place_of({-10.0, -5.0}), 225.0);
  EXPECT_DOUBLE_EQ(square.place_of({10.0, -5.0}), 375.0);
}

TEST(SquarePath, OfAnIdealMachineHasNoErrors) {
  for (const double interval : {0.001, 0.00018232}) {
    const SquareEvaluation square =
        evaluated(recorded_square(50.0, 0.0, {200.0, -30.0}, interval), {});
    EXPECT_NEAR(square.square.half_side, 50.0, 1e-9);
    EXPECT_NEAR(square.square.centre.x(), 200.0, 1e-9);
    for (const auto& error : square.corner_error) {
      ASSERT_TRUE(error.has_value());
      EXPECT_NEAR(*error, 0.0, 1e-9);
    }
  }
}

TEST(SquarePath, ALaggingAxisMissesTheCornerByItsClosedForm) {
  // sqrt(2) v T / e where the command does not slow down: 0.931 mm at 3 m/min with 35.79 ms.
  for (const double speed : {1000.0 / 60.0, 50.0}) {
    const SquareEvaluation square =
        evaluated(recorded_square(speed, 0.03579, {0.0, 0.0}, 0.001), {100.0, {{0.0, 0.0}}});
    const double miss = -std::numbers::sqrt2 * speed * 0.03579 / std::numbers::e;
    for (const auto& error : square.corner_error) {
      ASSERT_TRUE(error.has_value());
      EXPECT_NEAR(*error, miss, 1.5e-4);
    }
  }
}

/// Of an axis that is too long the corner lies beside the diagonal, which the path crosses on the
/// side of the other one; of one that is too short, on its own: sqrt(2) a s for a scale s < 0.
TEST(SquarePath, ASharpCornerBesideTheDiagonalCountsWhereThePathCrossesThat) {
  for (const double interval : {2e-4, 1e-3, 2e-3, 3.3e-3, 0.0123}) {
    for (const double scale : {200e-6, -200e-6, 3e-3, -3e-3}) {
      for (const bool is_of_x : {true, false}) {
        Record record = recorded_square(1000.0 / 60.0, 0.0, {0.0, 0.0}, interval);
        for (double& place : is_of_x ? record.x : record.y) {
          place *= 1.0 + scale;
        }
        const SquareEvaluation found = evaluated(record, {100.0, {{0.0, 0.0}}});
        for (const auto& error : found.corner_error) {
          ASSERT_TRUE(error.has_value());
          EXPECT_NEAR(*error, std::min(0.0, std::numbers::sqrt2 * 50.0 * scale), 1e-9)
              << interval << " " << scale;
        }
      }
    }
  }
}

/// Corners cut by 0.05 mm at 1 m/min: the path crosses the diagonal 0.05 / sqrt(2) inside.  Rows on
/// the cut are enough of them up to 2 ms; where one alone lies there nothing is prolonged; where
/// none does, the corner is taken as sharp.  What is unseen holds the truth each time.
TEST(SquarePath, ACutCornerIsNotMadeSharp) {
  constexpr double kSpeed = 1000.0 / 60.0;
  constexpr double kCut = 0.05;
  const double truth = -kCut / std::numbers::sqrt2;
  const Eigen::Vector2d corners[] = {
      {50, 0},           {50, 50 - kCut},   {50 - kCut, 50},  {-50 + kCut, 50}, {-50, 50 - kCut},
      {-50, -50 + kCut}, {-50 + kCut, -50}, {50 - kCut, -50}, {50, -50 + kCut}, {50, 0}};
  for (const double interval : {2e-4, 1e-3, 2e-3, 3e-3, 4e-3, 0.0123}) {
    Record record;
    double offset = 0.0;  // of the next sample from the beginning of a way
    for (std::size_t i = 0; i + 1 < std::size(corners); ++i) {
      const Eigen::Vector2d way = corners[i + 1] - corners[i];
      for (; offset < way.norm(); offset += kSpeed * interval) {
        const Eigen::Vector2d p = corners[i] + way.normalized() * offset;
        record.t.push_back(interval * static_cast<double>(record.t.size()));
        record.x.push_back(p.x());
        record.y.push_back(p.y());
      }
      offset -= way.norm();
    }
    const SquareEvaluation found = evaluated(record, {100.0, {{0.0, 0.0}}});
    for (std::size_t corner = 0; corner < 4; ++corner) {
      ASSERT_TRUE(found.corner_error[corner].has_value());
      const double error = *found.corner_error[corner];
      const auto [low, high] = std::minmax({error, error + found.corner_unseen[corner]});
      EXPECT_LE(low, truth + 1e-9) << interval;
      EXPECT_GE(high, truth - 1e-9) << interval;
      if (interval <= 2e-3) {
        EXPECT_NEAR(error, truth, 1e-9) << interval;
      } else if (interval <= 4e-3) {
        EXPECT_LE(error, truth + 1e-9) << interval;
      }
    }
  }
}

TEST(SquarePath, ACornerWhereThePathEndsHasTheErrorOfItsEnd) {
  Record record;
  const auto line = [&](double x0, double y0, double x1, double y1) {
    for (int i = 0; i <= 1000; ++i) {
      record.t.push_back(0.001 * static_cast<double>(record.t.size()));
      record.x.push_back(x0 + (x1 - x0) * i / 1000.0);
      record.y.push_back(y0 + (y1 - y0) * i / 1000.0);
    }
  };
  line(0.0, 0.0, 50.0, 50.0);  // to the corner along the diagonal
  line(50.0, 50.0, -50.0, 50.0);
  line(-50.0, 50.0, -50.0, -50.0);
  line(-50.0, -50.0, 50.0, -50.0);
  line(50.0, -50.0, 50.0, 49.99);
  const SquareEvaluation square = evaluated(record, {100.0, {{0.0, 0.0}}});
  EXPECT_NEAR(square.corner_error[0].value(), 0.0, 1e-9);
  EXPECT_NEAR(square.corner_error[1].value(), 0.0, 1e-9);
}

/// A rough record loses no corner at which it begins and ends: 0.3 um of noise move its errors by
/// no more than a few times that.
TEST(SquarePath, ARoughRecordKeepsTheCornerAtWhichItBeginsAndEnds) {
  Record record;
  add_way(record, {0.0, 0.0}, {50.0, 50.0}, false);
  add_way(record, {50.0, 50.0}, {-50.0, 50.0}, false);
  add_way(record, {-50.0, 50.0}, {-50.0, -50.0}, false);
  add_way(record, {-50.0, -50.0}, {50.0, -50.0}, false);
  add_way(record, {50.0, -50.0}, {50.0, 50.0}, false);
  add_way(record, {50.0, 50.0}, {0.0, 0.0}, true);
  for (std::size_t i = 0; i < record.x.size(); ++i) {
    record.x[i] += 1e-3 * (uniform(Stream{7, 1}, 2 * i) - 0.5);
    record.y[i] += 1e-3 * (uniform(Stream{7, 1}, 2 * i + 1) - 0.5);
  }
  for (const metrology::SquareRequest& request :
       {metrology::SquareRequest{}, metrology::SquareRequest{100.0, Eigen::Vector2d(0.0, 0.0)}}) {
    for (const auto& error : evaluated(record, request).corner_error) {
      ASSERT_TRUE(error.has_value());
      EXPECT_NEAR(*error, 0.0, 2e-3);
    }
  }
}

/// Once round a closed way at 0.05 mm a sample, from a place behind its first point on.
Record round_from(double place, const std::vector<Eigen::Vector2d>& corners) {
  constexpr double kStep = 0.05;
  double length = 0.0;
  for (std::size_t n = 0; n < corners.size(); ++n) {
    length += (corners[(n + 1) % corners.size()] - corners[n]).norm();
  }
  Record record;
  for (int i = 0; kStep * i <= length + 1e-9; ++i) {
    double s = std::fmod(place + kStep * i + length, length);
    std::size_t n = 0;
    const auto side = [&] {
      return Eigen::Vector2d(corners[(n + 1) % corners.size()] - corners[n]);
    };
    for (; s > side().norm(); ++n) {
      s -= side().norm();
    }
    const Eigen::Vector2d p = corners[n] + s * side().normalized();
    record.t.push_back(1e-3 * i);
    record.x.push_back(p.x());
    record.y.push_back(p.y());
  }
  return record;
}

/// A square turned by 100 um/m, to either side: its sides cross the diagonals 7.07 um inside the
/// corners, half of them 10 um from where it turns.
TEST(SquarePath, ATurnedSquareMayBeginAnywhereAboutACorner) {
  for (const double turn : {1e-4, -1e-4}) {
    const double in = 50.0 * (1.0 - turn);
    const double out = 50.0 * (1.0 + turn);
    const double t = std::abs(turn);
    const double expected = -std::numbers::sqrt2 * 50.0 * t * (1.0 - t) / (1.0 + t);
    for (int place = -150; place <= 250; place += 7) {
      const Record record =
          round_from(1e-3 * place, {{in, out}, {-out, in}, {-in, -out}, {out, -in}});
      const SquareEvaluation found = evaluated(record, {100.0, {{0.0, 0.0}}});
      for (const auto& error : found.corner_error) {
        ASSERT_TRUE(error.has_value()) << place;
        EXPECT_NEAR(*error, expected, 1e-9) << place;
      }
    }
  }
}

/// Corners cut by 1 mm, across their diagonals half a millimetre inside each axis' side.
TEST(SquarePath, ACutCornerMayBeBegunOn) {
  for (int place = -100; place <= 1500; place += 31) {
    const Record record = round_from(1e-3 * place, {{50.0, 49.0},
                                                    {49.0, 50.0},
                                                    {-49.0, 50.0},
                                                    {-50.0, 49.0},
                                                    {-50.0, -49.0},
                                                    {-49.0, -50.0},
                                                    {49.0, -50.0},
                                                    {50.0, -49.0}});
    const SquareEvaluation found = evaluated(record, {});
    for (const auto& error : found.corner_error) {
      ASSERT_TRUE(error.has_value()) << place;
      EXPECT_NEAR(*error, -0.5 * std::numbers::sqrt2, 1e-3) << place;
    }
  }
}

/// Few samples a side are evaluated where they tell a square, from its corner on or beside it.
TEST(SquarePath, AFewSamplesAreEnoughOrRefused) {
  int evaluated_ones = 0;
  for (int per_side = 1; per_side <= 12; ++per_side) {
    for (const double place : {0.0, 0.3}) {
      Record record;
      for (int i = 0; i <= 4 * per_side; ++i) {
        const double s = std::fmod(place + i, 4.0 * per_side) / per_side;
        const double along = 100.0 * (s - std::floor(s)) - 50.0;
        const Eigen::Vector2d p = s < 1.0   ? Eigen::Vector2d(-along, 50.0)
                                  : s < 2.0 ? Eigen::Vector2d(-50.0, -along)
                                  : s < 3.0 ? Eigen::Vector2d(along, -50.0)
                                            : Eigen::Vector2d(50.0, along);
        record.t.push_back(i);
        record.x.push_back(p.x());
        record.y.push_back(p.y());
      }
      const auto made = metrology::evaluate_square(record.samples(), {100.0, {{0.0, 0.0}}});
      if (made.ok() && place == 0.0) {
        ++evaluated_ones;
        EXPECT_NEAR(made.value().corner_error[0].value(), 0.0, 1e-9) << per_side;
      }
    }
  }
  EXPECT_GT(evaluated_ones, 0);
}

TEST(SquarePath, RefusesWhatIsNoSquare) {
  Record record;
  for (int i = 0; i < 1000; ++i) {
    record.t.push_back(i);
    record.x.push_back(50.0 * std::cos(0.00628 * i));
    record.y.push_back(50.0 * std::sin(0.00628 * i));
  }
  EXPECT_FALSE(metrology::evaluate_square(record.samples(), {}).ok());
  std::fill(record.x.begin(), record.x.end(), 1.0);
  std::fill(record.y.begin(), record.y.end(), 1.0);
  EXPECT_EQ(metrology::evaluate_square(record.samples(), {}).error(), "the path does not move");
}

TEST(PathSpeed, DipsAtTheCornersAsTheLagSays) {
  constexpr double kLag = 0.03579;
  const Record record = recorded_square(50.0, kLag, {0.0, 0.0}, 0.001);
  const auto speed = metrology::evaluate_speed(metrology::speed_of(record.samples()));
  ASSERT_TRUE(speed.has_value());
  EXPECT_NEAR(speed->usual, 50.0, 1e-6);
  ASSERT_EQ(speed->dips.size(), 4U);
  for (const metrology::SpeedDip& dip : speed->dips) {
    EXPECT_NEAR(dip.speed, 50.0 / std::numbers::sqrt2, 0.01);
    // z^2 + (1 - z)^2 = 0.81 for the shares z = exp(-t/T) of both axes.
    const double root = std::sqrt(0.62) / 2.0;
    const double width = kLag * std::log((0.5 + root) / (0.5 - root));
    EXPECT_NEAR(dip.width, width, 1e-3);
  }
  // The command turns at 1 s; both axes are equally fast T ln 2 later.
  EXPECT_NEAR(speed->dips[0].time, 1.0 + kLag * std::log(2.0), 1e-3);
}

TEST(PathSpeed, OfARoughRecordIsSmoothedAndOfAFineOneIsNot) {
  Record record;
  for (int i = 0; i < 20000; ++i) {
    record.t.push_back(0.00018232 * i);
    record.x.push_back(std::round(1e4 * 0.00018232 * i * 50.0 / 3.0) * 1e-4);  // 0.1 um steps
    record.y.push_back(0.0);
  }
  const metrology::SpeedRecord rough = metrology::speed_of(record.samples());
  EXPECT_GT(rough.interval, 1U);
  const auto speed = metrology::evaluate_speed(rough);
  EXPECT_NEAR(speed->usual, 50.0 / 3.0, 0.17);  // a step is 3 percent
  EXPECT_TRUE(speed->dips.empty());
  for (std::size_t i = 0; i < record.x.size(); ++i) {
    record.x[i] = record.t[i] * 50.0 / 3.0;
  }
  EXPECT_EQ(metrology::speed_of(record.samples()).interval, 1U);
  std::fill(record.x.begin(), record.x.end(), 1.0);
  EXPECT_FALSE(metrology::evaluate_speed(metrology::speed_of(record.samples())).has_value());
}

}  // namespace
}  // namespace g31::square_path_test
