#pragma once

#include <optional>

#include <Eigen/Core>

#include "machine/kinematics/transformation.h"
#include "machine/port/axis_transform.h"

namespace g31::path {

/// Leads the axes by a transformation whose places are the tip's within the part (TRAORI).
///
/// Base coordinates are these places in a system that is turned within the part.
class ChainTransform final : public machine::AxisTransform {
 public:
  /// @param part_from_base  a rotation; the origin is the part's
  ChainTransform(const machine::Transformation& by, const Eigen::Matrix3d& part_from_base)
      : by_(by), part_from_base_(part_from_base) {}

  [[nodiscard]] std::optional<AxisPositions> axes_at(const AxisPositions& q_B) const override;
  [[nodiscard]] AxisPositions base_at(const AxisPositions& q_M) const override;

 private:
  machine::Transformation by_;
  Eigen::Matrix3d part_from_base_;
};

}  // namespace g31::path
