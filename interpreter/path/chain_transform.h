#pragma once

#include <optional>

#include "machine/kinematics/transformation.h"
#include "machine/port/axis_transform.h"

namespace g31::path {

/// Leads the axes by a transformation whose places are the tip's within the part (TRAORI): these
/// are its base coordinates.
class ChainTransform final : public machine::AxisTransform {
 public:
  explicit ChainTransform(const machine::Transformation& by) : by_(by) {}

  [[nodiscard]] std::optional<AxisPositions> axes_at(const AxisPositions& q_B) const override;
  [[nodiscard]] AxisPositions base_at(const AxisPositions& q_M) const override;

 private:
  machine::Transformation by_;
};

}  // namespace g31::path
