#include "interpreter/dialects/fanuc/state/coordinates.h"

#include "machine/base/contract.h"

namespace g31::fanuc {

const AxisPositions& Coordinates::system(int which) const {
  static const AxisPositions kZero = AxisPositions::Zero();
  G31_EXPECTS(which >= 0 && which <= kSystems + kAdditional);
  if (which <= kSystems) {
    return systems_[static_cast<std::size_t>(which)];
  }
  const auto found = additional_.find(which);
  return found != additional_.end() ? found->second : kZero;
}

void Coordinates::set_system(int which, int axis, double value) {
  G31_EXPECTS(which >= 0 && which <= kSystems + kAdditional);
  if (which <= kSystems) {
    systems_[static_cast<std::size_t>(which)][axis] = value;
  } else {
    additional_.try_emplace(which, AxisPositions::Zero()).first->second[axis] = value;
  }
  refresh();
}

void Coordinates::select(int which) {
  selected_ = which;
  refresh();
}

void Coordinates::set_local_shift(int axis, double value) {
  local_shift_[axis] = value;
  refresh();
}

void Coordinates::declare(int axis, double value) {
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  q_L_programmed_[axis] = value;
  declared_shift_ += q_W - transform_.apply(q_L_programmed_);
  // The local shift of the axis becomes part of the declared one: G92 ends G52 (MB-290).
  declared_shift_[axis] += local_shift_[axis];
  local_shift_[axis] = 0.0;
  shift_ = system(0) + system(selected_) + local_shift_ + declared_shift_;
}

void Coordinates::shift_tool_offset(const AxisPositions& offset) {
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  q_L_programmed_ = transform_.undo(q_W + (tool_offset_ - offset));
  tool_offset_ = offset;
}

void Coordinates::clear_shifts(int axis) {
  local_shift_[axis] = 0.0;
  declared_shift_[axis] = 0.0;
  refresh();
}

void Coordinates::set_transform(const WorkTransform& transform) {
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  transform_ = transform;
  q_L_programmed_ = transform_.undo(q_W);
}

void Coordinates::refresh() {
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  const AxisPositions before = shift_;
  shift_ = system(0) + system(selected_) + local_shift_ + declared_shift_;
  q_L_programmed_ = transform_.undo(q_W + (before - shift_));
}

}  // namespace g31::fanuc
