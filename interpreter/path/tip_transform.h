#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "machine/kinematics/axis_chain.h"
#include "machine/port/axis_transform.h"

namespace g31::path {

/// Holds the tip of the tool where a program has it in the part, whatever the rotary axes do, by
/// what the control believes of the machine (G43.4, G68.2).
///
/// Base coordinates are those of a system that lies still in the part.
class TipTransform final : public machine::AxisTransform {
 public:
  /// @param p_T_tip         mm, the tool tip from the gauge point as the control believes it
  /// @param part_from_base  where the system lies in the part; a rotation and a shift, mm
  TipTransform(const machine::AxisChainSetup& believed, const Point& p_T_tip,
               const Eigen::Isometry3d& part_from_base)
      : chain_(believed, p_T_tip),
        p_T_tip_(p_T_tip),
        part_from_base_(part_from_base),
        base_from_part_(part_from_base.inverse()) {}

  [[nodiscard]] std::optional<AxisPositions> axes_at(const AxisPositions& q_B) const override;
  [[nodiscard]] AxisPositions base_at(const AxisPositions& q_M) const override;

  /// A vector that is held with the tool, mm, in base coordinates.
  /// @param vector_T  with all rotary axes at 0
  [[nodiscard]] Point turned(const AxisPositions& q_M, const Point& vector_T) const;

 private:
  machine::AxisChain chain_;
  Point p_T_tip_;
  Eigen::Isometry3d part_from_base_;
  Eigen::Isometry3d base_from_part_;
};

}  // namespace g31::path
