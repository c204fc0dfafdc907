// Paths under TRAORI on the simulated machine: roundings, chamfers, cutter radius compensation and
// circles are those of the programmed plane for the part, whatever the rotary axes do meanwhile.
// Where the tip is, sample by sample of the trace, comes of matrices of the machine; what it must
// keep is a distance in closed form.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/run/session.h"
#include "tests/interpreter/traced_machine.h"
#include "tests/support/control_run.h"
#include "tests/support/worked_machines.h"

namespace g31::sinumerik::traori_path_test {
namespace {

using machine::AxisChainSetup;
using machine::TraceSample;
using testing::FilesInMemory;

constexpr double kRadiusMm = 4.0;
constexpr double kHalfLengthMm = 20.0;
constexpr double kHalfWidthMm = 15.0;

struct Machine {
  const char* name;
  AxisChainSetup chain;
  Point p_M_origin;   ///< of G54
  std::string first;  ///< letter of the axis that turns
  std::string other;  ///< and of one that turns twice as far
};

std::vector<Machine> machines() {
  using namespace machine::worked;
  return {{"K1", k1(), {40, -25, -380}, "A", "C"},  {"K2", k2(), {230, -120, -420}, "B", "C"},
          {"K3", k3(), {30, 40, -350}, "B", "C"},   {"K4", k4(), {300, 100, -500}, "A", "C"},
          {"K5", k5(), {300, 100, -500}, "B", "C"}, {"K6", k6(), {20, -30, -380}, "B", "C"}};
}

/// A program on the simulated machine, with a trace.
class TracedRun final : public runtime::Observer {
 public:
  TracedRun(const Machine& machine, const std::string& program)
      : turning_(axis_index(machine.first.front())),
        files_({{"case.mpf", program + "\nM30\n"}}),
        sources_(files_),
        library_(sources_),
        traced_(machine.chain, machine.p_M_origin, 0.01) {
    library_.add_file("case.mpf");
    Session session(library_, traced_.centre(), *this);
    runtime::ControlSetup control = traced_.told(machine.chain);
    control.tools[1].radius_mm = kRadiusMm;
    testing::TracedMachine::run(session, control);
  }

  void on_move(const runtime::MoveEvent& move) override { moves.push_back(move); }

  /// What turns as far as this on the way counts.
  [[nodiscard]] std::vector<AxisPositions> between(double low_deg, double high_deg) const {
    std::vector<AxisPositions> found;
    for (const TraceSample& sample : traced_.samples()) {
      const AxisPositions& q_M = sample.q_M_commanded;
      if (q_M[turning_] > low_deg && q_M[turning_] < high_deg) {
        found.push_back(q_M);
      }
    }
    return found;
  }

  [[nodiscard]] Point tip_at(const AxisPositions& q_M) const { return traced_.tip_at(q_M); }

  std::vector<runtime::MoveEvent> moves;

 private:
  int turning_;
  FilesInMemory files_;
  source::SourceMap sources_;
  ProgramLibrary library_;
  testing::TracedMachine traced_;
};

/// How far a point is from a rectangle about the origin, its corners rounded; inside less than 0.
double off_rectangle(const Point& p, double corner_mm) {
  const Eigen::Vector2d q(std::abs(p.x()) - (kHalfLengthMm - corner_mm),
                          std::abs(p.y()) - (kHalfWidthMm - corner_mm));
  return q.cwiseMax(0.0).norm() + std::min(0.0, q.maxCoeff()) - corner_mm;
}

/// Words of both rotary axes.
std::string turned(const Machine& machine, double degrees) {
  return " " + machine.first + "=" + std::to_string(degrees) + " " + machine.other + "=" +
         std::to_string(2.0 * degrees);
}

/// Round the rectangle clockwise from its lower left corner, the axes turning from 10 to 50.
std::string round_the_rectangle(const Machine& machine, const std::string& corner) {
  return "X-20 Y15" + turned(machine, 20) + corner + "\nX20" + turned(machine, 30) + corner +
         "\nY-15" + turned(machine, 40) + corner + "\nX-20" + turned(machine, 50) + "\n";
}

TEST(TraoriPath, CompensationKeepsTheRadiusWhileTheAxesTurn) {
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    const TracedRun run(m, "T1 M6\nG54 D1\nTRAORI\nG0 X-60 Y-60 Z-2" + turned(m, 10) +
                               "\nG1 G41 F4000 X-20 Y-15\n" + round_the_rectangle(m, "") +
                               "G0 G40 X-60 Y-60\nTRAFOOF");
    const auto samples = run.between(10.0, 50.0);
    EXPECT_GT(samples.size(), 100U);
    double worst = 0.0;
    for (const AxisPositions& q_M : samples) {
      const Point tip = run.tip_at(q_M);
      worst =
          std::max({worst, std::abs(off_rectangle(tip, 0.0) - kRadiusMm), std::abs(tip.z() + 2.0)});
    }
    EXPECT_LT(worst, 1e-9);
  }
}

/// PTP: the axes go straight to where the tip is wanted; with CP the tip goes straight again.
TEST(TraoriPath, PointToPointTheAxesGoStraight) {
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    const std::string begin = "T1 M6\nG54 D1\nTRAORI\nG0 X30 Y-20 Z10" + turned(m, 10) + "\n";
    const std::string there = "X-15 Y40 Z25" + turned(m, 50) + "\n";
    for (const char* const motion : {"G0 ", "G1 F3000 "}) {
      const TracedRun run(m, begin + "PTP\n" + motion + there);
      const std::vector<AxisPositions> way = run.between(10.0001, 49.9999);
      ASSERT_GT(way.size(), 20U);
      const AxisPositions along = way.back() - way.front();
      double worst = 0.0;
      double bent = 0.0;
      for (const AxisPositions& q_M : way) {
        const AxisPositions from_front = q_M - way.front();
        const double part = from_front.dot(along) / along.squaredNorm();
        worst = std::max(worst, (from_front - part * along).cwiseAbs().maxCoeff());
        const Point p = run.tip_at(q_M) - Point(30, -20, 10);
        const Point line = Point(-45, 60, 15).normalized();
        bent = std::max(bent, (p - p.dot(line) * line).norm());
      }
      EXPECT_LT(worst, 1e-9);
      EXPECT_GT(bent, 1.0) << "the tip goes along a curve";
      EXPECT_LT((run.tip_at(run.moves.back().q_M_to) - Point(-15, 40, 25)).norm(), 1e-9);
    }
    const TracedRun again(m, begin + "PTP\nCP\nG1 F3000 " + there);
    double worst = 0.0;
    for (const AxisPositions& q_M : again.between(10.0001, 49.9999)) {
      const Point p = again.tip_at(q_M) - Point(30, -20, 10);
      const Point line = Point(-45, 60, 15).normalized();
      worst = std::max(worst, (p - p.dot(line) * line).norm());
    }
    EXPECT_LT(worst, 1e-9);
  }
}

TEST(TraoriPath, RoundingsAreThoseOfThePartAndTheAxesTurnOnOverThem) {
  constexpr double kCornerMm = 3.0;
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    const TracedRun run(m, "T1 M6\nG54 D1\nTRAORI\nG0 X-20 Y-15 Z-2" + turned(m, 10) +
                               "\nG1 F4000\n" + round_the_rectangle(m, " RND=3") + "TRAFOOF");
    const auto samples = run.between(10.0, 50.0);
    EXPECT_GT(samples.size(), 100U);
    double worst = 0.0;
    int on_corners = 0;
    for (const AxisPositions& q_M : samples) {
      const Point tip = run.tip_at(q_M);
      // The contour begins and ends at the lower left corner, which is sharp.
      const bool at_sharp = tip.x() < -10.0 && tip.y() < -10.0;
      const double corner = at_sharp ? 0.0 : kCornerMm;
      worst = std::max({worst, std::abs(off_rectangle(tip, corner)), std::abs(tip.z() + 2.0)});
      on_corners += !at_sharp && std::abs(tip.x()) > 17.01 && std::abs(tip.y()) > 12.01 ? 1 : 0;
    }
    EXPECT_LT(worst, 1e-9);
    EXPECT_GT(on_corners, 5);
    // 20 degrees at the upper left corner: the rounding begins 27 of 30 mm along, ends 3 of 40.
    const int axis = axis_index(m.first.front());
    ASSERT_EQ(run.moves.size(), 8U);
    EXPECT_NEAR(run.moves[1].q_M_to[axis], 10.0 + 10.0 * 27.0 / 30.0, 1e-12);
    EXPECT_EQ(run.moves[2].g, 2);
    EXPECT_NEAR(run.moves[2].q_M_to[axis], 20.0 + 10.0 * 3.0 / 40.0, 1e-12);
  }
}

TEST(TraoriPath, ChamfersAreThoseOfThePart) {
  const double leg = 2.0 / std::numbers::sqrt2;  // of a chamfer of 2 mm at a right angle
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    const TracedRun run(m, "T1 M6\nG54 D1\nTRAORI\nG0 X-20 Y-15 Z-2" + turned(m, 10) +
                               "\nG1 F4000\n" + round_the_rectangle(m, " CHF=2") + "TRAFOOF");
    ASSERT_EQ(run.moves.size(), 8U);
    const int axis = axis_index(m.first.front());
    EXPECT_LT((run.tip_at(run.moves[1].q_M_to) - Point(-20.0, 15.0 - leg, -2.0)).norm(), 1e-9);
    EXPECT_LT((run.tip_at(run.moves[2].q_M_to) - Point(-20.0 + leg, 15.0, -2.0)).norm(), 1e-9);
    EXPECT_NEAR(run.moves[1].q_M_to[axis], 10.0 + 10.0 * (30.0 - leg) / 30.0, 1e-12);
    EXPECT_NEAR(run.moves[2].q_M_to[axis], 20.0 + 10.0 * leg / 40.0, 1e-12);
  }
}

TEST(TraoriPath, CompensationLiesInTheTiltedPlaneOfTheFrames) {
  const double tilt = 25.0 * std::numbers::pi / 180.0;
  const Eigen::Matrix3d frame =
      (Eigen::AngleAxisd(0.5 * tilt, Point::UnitZ()) * Eigen::AngleAxisd(tilt, Point::UnitX()))
          .toRotationMatrix();
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    const TracedRun run(m, "T1 M6\nG54 D1\nTRAORI\nROT Z12.5\nAROT X25\nG0 X-60 Y-60 Z-2" +
                               turned(m, 10) + "\nG1 G41 F4000 X-20 Y-15\n" +
                               round_the_rectangle(m, "") + "G0 G40 X-60 Y-60\nTRAFOOF");
    const auto samples = run.between(10.0, 50.0);
    EXPECT_GT(samples.size(), 100U);
    double worst = 0.0;
    for (const AxisPositions& q_M : samples) {
      const Point tip = frame.transpose() * run.tip_at(q_M);
      worst =
          std::max({worst, std::abs(off_rectangle(tip, 0.0) - kRadiusMm), std::abs(tip.z() + 2.0)});
    }
    EXPECT_LT(worst, 1e-9);
  }
}

TEST(TraoriPath, CirclesAreRoundForThePart) {
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    const TracedRun run(m, "T1 M6\nG54 D1\nTRAORI\nROT X15\nG0 X25 Y0 Z5" + turned(m, 10) +
                               "\nG3 F4000 X-7 Y24 I-25 J0" + turned(m, 40) + "\nTRAFOOF");
    const Eigen::Matrix3d frame =
        Eigen::AngleAxisd(15.0 * std::numbers::pi / 180.0, Point::UnitX()).toRotationMatrix();
    const auto samples = run.between(10.0, 40.0);
    EXPECT_GT(samples.size(), 50U);
    const double whole = std::atan2(24.0, -7.0);
    const int axis = axis_index(m.first.front());
    double worst = 0.0;
    double worst_deg = 0.0;
    for (const AxisPositions& q_M : samples) {
      const Point tip = frame.transpose() * run.tip_at(q_M);
      worst =
          std::max({worst, std::abs(std::hypot(tip.x(), tip.y()) - 25.0), std::abs(tip.z() - 5.0)});
      const double share = std::atan2(tip.y(), tip.x()) / whole;
      worst_deg = std::max(worst_deg, std::abs(q_M[axis] - (10.0 + 30.0 * share)));
    }
    EXPECT_LT(worst, 1e-9);
    EXPECT_LT(worst_deg, 1e-9);
  }
}

TEST(TraoriPath, ADifferentToolAndFrameCountFromTheirBlockOn) {
  for (const Machine& m : machines()) {
    SCOPED_TRACE(m.name);
    // A line waits for its corner while the frame behind it comes into force.
    const TracedRun run(m, "T1 M6\nG54 D1\nTRAORI\nG0 X0 Y0 Z0" + turned(m, 20) +
                               "\nG1 F4000 X20 RND=2\nTRANS Z3\nY20\nZ1\nTRAFOOF");
    ASSERT_FALSE(run.moves.empty());
    EXPECT_LT((run.tip_at(run.moves.back().q_M_to) - Point(20.0, 20.0, 4.0)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace g31::sinumerik::traori_path_test
