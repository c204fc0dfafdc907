#pragma once

#include <limits>
#include <vector>

#include "machine/errors/axis_play.h"
#include "machine/errors/geometric_errors.h"
#include "machine/kinematics/axis_chain.h"
#include "machine/sim/axis_corrections.h"
#include "machine/sim/machine_setup.h"

namespace g31::machine {

/// Where the tool tip truly is, relative to the part, when the encoders say q_M.
///
/// Added up: geometric errors, what the control compensates (by the sheet and by its own tables),
/// growth of the scales, cyclic errors, backlash and stick motion.  True positions are axis
/// positions of an ideal machine that would have its tip there.
class TruePosition {
 public:
  explicit TruePosition(const MachineSetup& setup);

  /// Whether every true position is the encoder position, bit for bit.
  [[nodiscard]] bool is_ideal() const { return is_exact_ && corrections_.are_none(); }

  /// The true position after a straight way from the last one to q_M.
  [[nodiscard]] AxisPositions after(const AxisPositions& q_M) const;

  /// The same as the tool and the part have it.
  [[nodiscard]] ToolPlace place_after(const AxisPositions& q_M) const;

  /// The same where the way has ended, and the next one will begin.
  AxisPositions go_to(const AxisPositions& q_M);

  /// @param p_T_tip  mm, the tip of the tool from now on, from the gauge point
  void take_tool(const Point& p_T_tip) { chain_.take_tool(p_T_tip); }

  /// Which axes carry the part and the tool.
  [[nodiscard]] const AxisChain& chain() const { return chain_; }

  /// The control adds these from now on.  @param q_M  where the encoders stand
  void correct_by(AxisCorrections corrections, const AxisPositions& q_M);

  /// Whether it depends on the way that the axes have come.
  [[nodiscard]] bool has_play() const { return has_play_ || has_directions_; }

  /// So far along any axis its errors hardly bend, mm or deg: a quarter of the shortest pitch of a
  /// cyclic error; infinite where there is none.
  [[nodiscard]] double smooth_way() const { return smooth_way_; }

 private:
  [[nodiscard]] AxisPositions without_play(const AxisPositions& q_M) const;
  /// In which direction each axis has come to q_M, for tables that ask.
  [[nodiscard]] AxisPositions direction_to(const AxisPositions& q_M) const;

  errors::GeometricErrors geometry_;
  errors::GeometricErrors compensation_;
  bool leans_;                   // there are geometric errors, which may tilt the tool
  AxisCorrections corrections_;  // of the control's own tables
  std::vector<errors::AxisPlay> play_;
  std::vector<errors::CyclicErrorSetup> cyclic_;
  AxisPositions growth_;     // of a scale, per unit of length
  AxisPositions q_M_fixed_;  // where growing scales stay
  AxisChain chain_;
  double smooth_way_ = std::numeric_limits<double>::infinity();
  AxisPositions q_M_last_ = AxisPositions::Zero();   // where the last way ended, with directions
  AxisPositions direction_ = AxisPositions::Zero();  // of it
  bool has_play_ = false;
  bool has_directions_ = false;
  bool is_exact_ = true;  // but for what the control adds
};

}  // namespace g31::machine
