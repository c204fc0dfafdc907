// G43.4 on the simulated machine: where the tip is while the axes turn, sample by sample of the
// trace, against matrices of the true machine.  The six machines and the errors are the worked
// examples of the five-axis specification.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/interpreter/traced_machine.h"
#include "tests/support/control_run.h"
#include "tests/support/worked_machines.h"

namespace g31::fanuc::tip_control_test {
namespace {

using machine::AxisChainSetup;
using machine::TraceSample;
using testing::FilesInMemory;

/// What is true and what the control believes.
struct Machine {
  AxisChainSetup truth;
  AxisChainSetup believed;
  Point p_M_origin;  ///< of G54
};

/// A program on the simulated machine, with a trace.
class TracedRun final : public runtime::Observer {
 public:
  TracedRun(const Machine& machine, const std::string& program, double period_s = 0.01)
      : files_({{"case.nc", "O0001\n" + program + "\nM30\n"}}),
        sources_(files_),
        library_(sources_),
        traced_(machine.truth, machine.p_M_origin, period_s) {
    library_.add_file("case.nc");
    Session session(*find_profile("fanuc-30i"), library_, traced_.centre(), *this);
    testing::TracedMachine::run(session, traced_.told(machine.believed));
  }

  [[nodiscard]] const std::vector<TraceSample>& samples() const { return traced_.samples(); }
  [[nodiscard]] Point tip_at(const AxisPositions& q_M) const { return traced_.tip_at(q_M); }
  [[nodiscard]] Point tip_at_end() const { return tip_at(end()); }
  [[nodiscard]] AxisPositions end() const { return traced_.end(); }

 private:
  FilesInMemory files_;
  source::SourceMap sources_;
  ProgramLibrary library_;
  testing::TracedMachine traced_;
};

struct Range {
  const char* name;
  AxisChainSetup chain;
  Point p_M_origin;
  const char* from;
  const char* to;
};

std::vector<Range> whole_ranges() {
  using namespace machine::worked;
  return {{"K1", k1(), {40, -25, -380}, "A-120.C-360.", "A120.C360."},
          {"K2", k2(), {230, -120, -420}, "B-95.C-360.", "B110.C360."},
          {"K3", k3(), {30, 40, -350}, "B-180.C-360.", "B180.C360."},
          {"K4", k4(), {300, 100, -500}, "C-360.A-110.", "C360.A110."},
          {"K5", k5(), {300, 100, -500}, "C-360.B-180.", "C360.B180."},
          {"K6", k6(), {20, -30, -380}, "B0.C-360.", "B180.C360."}};
}

TEST(TipControl, HoldsTheTipWhileTheAxesTurnThroughTheirWholeRange) {
  for (const Range& r : whole_ranges()) {
    SCOPED_TRACE(r.name);
    const std::string program = std::string("G90G43.4H1\nG1X30.Y-20.Z10.F1000.\n") + r.from +
                                "F3000.\n" + r.to + "\nG0" + r.from;
    const TracedRun run({r.chain, r.chain, r.p_M_origin}, program);
    const Point w(30, -20, 10);
    int held = 0;
    double worst = 0.0;
    for (const TraceSample& sample : run.samples()) {
      const Point off = run.tip_at(sample.q_M_commanded) - w;
      const bool turns = !rotary_axes(sample.q_M_commanded).isZero(0.0);
      if (turns) {
        ++held;
        worst = std::max(worst, off.norm());
      }
    }
    EXPECT_GT(held, 1000);
    EXPECT_LT(worst, 1e-9);
  }
}

TEST(TipControl, TheTipGoesStraightForThePart) {
  for (const Range& r : whole_ranges()) {
    SCOPED_TRACE(r.name);
    const std::string program = std::string("G90G43.4H1\nG0X30.Y-20.Z10.") + r.from +
                                "\nG4P100\nG1F3000.X-15.Y40.Z25." + r.to;
    const TracedRun run({r.chain, r.chain, r.p_M_origin}, program);
    const Point from(30, -20, 10);
    const Point along = (Point(-15, 40, 25) - from).normalized();
    double worst = 0.0;
    int on_line = 0;
    bool has_come = false;  // to where the line begins
    for (const TraceSample& sample : run.samples()) {
      const Point off = run.tip_at(sample.q_M_commanded) - from;
      has_come = has_come || off.norm() < 1e-9;
      if (has_come) {
        ++on_line;
        worst = std::max(worst, (off - off.dot(along) * along).norm());
      }
    }
    EXPECT_GT(on_line, 100);
    EXPECT_LT(worst, 1e-9);
    EXPECT_LT((run.tip_at_end() - Point(-15, 40, 25)).norm(), 1e-9);
  }
}

struct Injected {
  const char* name;
  AxisChainSetup truth;
  AxisChainSetup believed;
  Point p_M_origin;
  const char* turn;
  Point off;
};

/// The errors that the specification has worked out, 1e-9 mm.
TEST(TipControl, TheTipLeavesItsPlaceByTheErrorOfWhatIsBelieved) {
  using namespace machine::worked;
  AxisChainSetup off_centre = k1();
  off_centre.rotary[2].p_M_centre = {5.03, -3.02, 0.0};
  AxisChainSetup tilted = k1();
  const double arc = 20.0 / 3600.0 * std::numbers::pi / 180.0;
  tilted.rotary[2].axis_M = {0.0, -std::sin(arc), std::cos(arc)};
  AxisChainSetup higher = k2();
  higher.rotary[1].p_M_centre.z() = 180.05;
  const Point origin1(40, -25, -380);
  const Point origin2(230, -120, -420);
  const Injected cases[] = {
      {"centre, 0", k1(), off_centre, origin1, "A0C0", {0, 0, 0}},
      {"centre", k1(), off_centre, origin1, "A35.C-70.", {-0.038533248, -0.015031181, 0}},
      {"centre, other way",
       k1(),
       off_centre,
       origin1,
       "A-60.C110.",
       {-0.021466752, 0.055031181, 0}},
      {"centre, tilted", k1(), off_centre, origin1, "A90.C45.", {0.005355339, 0.027071068, 0}},
      {"tilt", tilted, k1(), origin1, "A35.C-70.", {-0.033712818, 0.023606386, -0.008599777}},
      {"tilt, other way",
       tilted,
       k1(),
       origin1,
       "A-60.C110.",
       {0.033712406, 0.048146283, 0.000461865}},
      {"tilt, tilted", tilted, k1(), origin1, "A90.C45.", {0.025368062, 0.010507637, 0.003264826}},
      {"head", higher, k2(), origin2, "B35.C-70.", {-0.009808735, 0.026949277, 0.009042398}},
      {"head, level", higher, k2(), origin2, "B-90.C110.", {-0.017101007, 0.046984631, 0.05}},
  };
  for (const Injected& c : cases) {
    SCOPED_TRACE(c.name);
    const TracedRun run({c.truth, c.believed, c.p_M_origin},
                        std::string("G90G43.4H1\nG0X30.Y-20.Z10.\n") + c.turn, 1.0);
    const Point off = run.tip_at_end() - Point(30, -20, 10);
    EXPECT_LT((off - c.off).cwiseAbs().maxCoeff(), 1.5e-9) << off.transpose();
  }
}

}  // namespace
}  // namespace g31::fanuc::tip_control_test
