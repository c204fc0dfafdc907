// What SINUMERIK motion asks of the machine, beyond the ends of its moves.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/run/session.h"
#include "machine/port/forwarding_machine.h"
#include "tests/support/recording_machine.h"

namespace g31::sinumerik_motion_test {
namespace {

using Lines = std::vector<std::string>;

/// One program and nothing else.
class OneFile final : public source::FileSystem {
 public:
  explicit OneFile(std::string text) : text_(std::move(text)) {}
  std::optional<std::string> read(const std::string&) override { return text_; }
  std::vector<std::string> list(const std::string&) override { return {}; }

 private:
  std::string text_;
};

/// Keeps the ends of straight moves.
class EndsMachine final : public machine::ForwardingMachine {
 public:
  using ForwardingMachine::ForwardingMachine;
  using ForwardingMachine::move;
  Result<AxisPositions, machine::MachineFault> move(const machine::LinearMove& move) override {
    ends_.push_back(move.q_M_end);
    return machine_.move(move);
  }
  [[nodiscard]] const std::vector<AxisPositions>& ends() const { return ends_; }

 private:
  std::vector<AxisPositions> ends_;
};

template <typename Machine>
void run(const std::string& program, Machine& machine) {
  OneFile file(program);
  source::SourceMap sources(file);
  sinumerik::ProgramLibrary library(sources);
  library.add_file("main.mpf");
  runtime::Observer observer;
  sinumerik::Session session(library, machine, observer);
  session.configure({});
  const runtime::Outcome outcome = session.run({});
  EXPECT_FALSE(outcome.alarm.has_value()) << outcome.alarm->number;
}

Lines log_of(const std::string& program) {
  testing::RecordingMachine machine;
  run(program, machine);
  return machine.log();
}

TEST(SinumerikSpindle, IsOrientedAbsolutelyAndByAnAngle) {
  EXPECT_EQ(log_of("SPOS=30\nSPOS[1]=DC(90)\nSPOS=IC(-100)\nSPOSA=AC(45)\nM19\nM30\n"),
            (Lines{"orient 30", "orient 90", "orient -10", "orient 45", "orient 0"}));
}

TEST(SinumerikCircles, HaveTheirCentres) {
  struct Case {
    const char* what;
    const char* program;
    const char* last;
  };
  const Case kCases[] = {
      {"tangent to the move before", "G0 X10\nCT X20 Y10 F100",
       "arc ccw 20.000 10.000 0.000 centre X10.000 Y10.000 F100"},
      {"tangent to an arc before", "G0 X10\nCT X20 Y10 F100\nX30 Y20",
       "arc cw 30.000 20.000 0.000 centre X30.000 Y10.000 F100"},
      {"about the pole", "G111 X5 Y0\nG0 AP=0 RP=10\nG3 AP=90 F100",
       "arc ccw 5.000 10.000 0.000 centre X5.000 Y0.000 F100"},
      {"AR with a centre", "G2 AR=90 I10 F100",
       "arc cw 10.000 10.000 0.000 centre X10.000 Y0.000 F100"},
      {"DIAMON: I=AC is a diameter, I a radius", "DIAMON G2 X40 Y0 I=AC(20) J0 F100",
       "arc cw 20.000 0.000 0.000 centre X10.000 Y0.000 F100"},
      {"the corner of a compensated path",
       "T1 M6\n$TC_DP6[1,1]=5\nD1 G0 X-20 Y-10\nG41 G1 X0 Y0 F100\nY20\nX20 G40",
       "move 20.000 20.000 0.000 F100"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    EXPECT_EQ(log_of(std::string(c.program) + "\nM30\n").back(), c.last);
  }
}

TEST(SinumerikCircles, InATiltedPlaneStayOnTheCircle) {
  testing::RecordingMachine recording;
  EndsMachine machine(recording);
  run("ROT X30 Y20\nG0 X50 Y0 Z3\nG3 X50 Y0 Z3 I-50 J0 F1000\nM30\n", machine);
  // The plane by its own way: the angles of ROT turn about Z, then the new Y, then the new X.
  const double x = 30.0 * std::numbers::pi / 180.0;
  const double y = 20.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d normal(std::sin(y) * std::cos(x), -std::sin(x), std::cos(y) * std::cos(x));
  const Eigen::Vector3d centre = 3.0 * normal;
  ASSERT_GT(machine.ends().size(), 100U);
  Eigen::Vector3d from = machine.ends().front().head<3>();
  double length = 0.0;
  for (const AxisPositions& q : machine.ends()) {
    const Eigen::Vector3d p = q.head<3>();
    EXPECT_NEAR((p - centre).norm(), 50.0, 1e-9);
    EXPECT_NEAR((p - centre).dot(normal), 0.0, 1e-9);
    EXPECT_LE(50.0 - ((p + from) / 2.0 - centre).norm(), 5.001e-4);
    length += (p - from).norm();
    from = p;
  }
  EXPECT_NEAR(length, 100.0 * std::numbers::pi, 1e-2);
}

}  // namespace
}  // namespace g31::sinumerik_motion_test
