#include "machine/sim/true_position.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace g31::machine {
TruePosition::TruePosition(const MachineSetup& setup)
    : geometry_(setup.geometric_errors),
      compensation_(setup.compensation),
      leans_(!geometry_.are_zero()),
      growth_(AxisPositions::Zero()),
      q_M_fixed_(AxisPositions::Zero()),
      chain_(setup.chain, setup.p_T_tip) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const AxisSetup& axis = setup.axes[i];
    play_.emplace_back(axis.play, setup.q_M_start[row]);
    cyclic_.push_back(axis.cyclic_error);
    if (axis.cyclic_error.amplitude != 0.0) {
      smooth_way_ = std::min(smooth_way_, 0.25 * axis.cyclic_error.pitch);
    }
    if (is_linear_axis(static_cast<int>(i))) {
      growth_[row] = axis.scale_growth.per_unit();
      q_M_fixed_[row] = axis.scale_fixed_at;
    }
  }
  has_play_ = !std::ranges::all_of(play_, &errors::AxisPlay::is_zero);
  const bool has_cyclic = smooth_way_ < std::numeric_limits<double>::infinity();
  is_exact_ =
      !leans_ && compensation_.are_zero() && growth_.isZero(0.0) && !has_play_ && !has_cyclic;
}

AxisPositions TruePosition::without_play(const AxisPositions& q_M) const {
  AxisPositions q_M_true = q_M + growth_.cwiseProduct(q_M - q_M_fixed_);
  const Point arm_M = chain_.tool_vector(q_M);
  q_M_true.head<kLinearAxisCount>() += geometry_.at(linear_axes(q_M), arm_M);
  q_M_true.head<kLinearAxisCount>() += compensation_.at(linear_axes(q_M), arm_M);
  for (std::size_t i = 0; i < cyclic_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    q_M_true[row] += cyclic_[i].at(q_M[row]);
  }
  if (!corrections_.are_none()) {
    q_M_true += corrections_.at(q_M, direction_to(q_M));
  }
  return q_M_true;
}

AxisPositions TruePosition::after(const AxisPositions& q_M) const {
  if (is_ideal()) {
    return q_M;
  }
  AxisPositions q_M_true = without_play(q_M);
  if (!has_play_) {
    return q_M_true;
  }
  for (std::size_t i = 0; i < play_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    q_M_true[row] += play_[i].after(q_M[row]).offset();
  }
  return q_M_true;
}

ToolPlace TruePosition::place_after(const AxisPositions& q_M) const {
  ToolPlace place = chain_.for_part(after(q_M));
  if (leans_) {
    place.lean_rad = geometry_.turn_at(linear_axes(q_M));
    if (chain_.is_turned(q_M)) {
      place.lean_rad = chain_.part_from_machine(q_M).linear() * place.lean_rad;
    }
  }
  return place;
}

AxisPositions TruePosition::direction_to(const AxisPositions& q_M) const {
  AxisPositions direction = direction_;
  for (Eigen::Index i = 0; has_directions_ && i < q_M.size(); ++i) {
    const double way = q_M[i] - q_M_last_[i];
    if (std::abs(way) > errors::kLeastReversal) {
      direction[i] = way > 0.0 ? 1.0 : -1.0;
    }
  }
  return direction;
}

void TruePosition::correct_by(AxisCorrections corrections, const AxisPositions& q_M) {
  corrections_ = std::move(corrections);
  has_directions_ = corrections_.depend_on_direction();
  q_M_last_ = q_M;
}

AxisPositions TruePosition::go_to(const AxisPositions& q_M) {
  if (has_directions_) {
    direction_ = direction_to(q_M);
    q_M_last_ = q_M;
  }
  if (!has_play_) {
    return after(q_M);
  }
  for (std::size_t i = 0; i < play_.size(); ++i) {
    play_[i] = play_[i].after(q_M[static_cast<Eigen::Index>(i)]);
  }
  return after(q_M);
}

}  // namespace g31::machine
