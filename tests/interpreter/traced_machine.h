#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/outcome.h"
#include "machine/sim/machining_centre.h"
#include "tests/support/trace_samples.h"

namespace g31::testing {

/// A machine with all axes that keeps its trace, and a tool of 120 mm in its spindle.
class TracedMachine {
 public:
  static constexpr double kToolLengthMm = 120.0;

  /// @param p_M_origin  of G54
  TracedMachine(const machine::AxisChainSetup& truth, const Point& p_M_origin, double period_s)
      : truth_(truth), p_M_origin_(p_M_origin), centre_(setup_of(truth), nullptr) {
    centre_.trace(period_s, samples_);
  }

  machine::MachiningCentre& centre() { return centre_; }
  [[nodiscard]] AxisPositions end() const { return centre_.position(); }
  [[nodiscard]] const std::vector<machine::TraceSample>& samples() const { return samples_.list; }

  /// What a control is told of it: G54 and tool 1.
  [[nodiscard]] runtime::ControlSetup told(const machine::AxisChainSetup& believed) const {
    runtime::ControlSetup control;
    control.kinematics = believed;
    AxisPositions q_offset = AxisPositions::Zero();
    q_offset.head<3>() = p_M_origin_;
    control.work_offsets["G54"] = q_offset;
    control.tools[1].length_mm = kToolLengthMm;
    return control;
  }

  /// Runs a session of the machine to the end.
  template <typename Session>
  static void run(Session& session, const runtime::ControlSetup& control) {
    EXPECT_TRUE(session.configure(control).empty());
    const runtime::Outcome outcome = session.run({});
    EXPECT_EQ(outcome.status, runtime::Status::Completed)
        << (outcome.alarm ? outcome.alarm->text : "");
  }

  /// The tip in the work coordinate system on the part; mm.
  [[nodiscard]] Point tip_at(const AxisPositions& q_M) const {
    const Point p_T(0.0, 0.0, -kToolLengthMm);
    const machine::AxisChain chain(truth_, p_T);
    return linear_axes(chain.for_part(q_M).q) + p_T - p_M_origin_;
  }

 private:
  static machine::MachineSetup setup_of(const machine::AxisChainSetup& truth) {
    machine::MachineSetup setup;
    setup.chain = truth;
    for (machine::AxisSetup& axis : setup.axes) {
      axis.present = true;
    }
    return setup;
  }

  machine::AxisChainSetup truth_;
  Point p_M_origin_;
  TraceSamples samples_;
  machine::MachiningCentre centre_;
};

}  // namespace g31::testing
