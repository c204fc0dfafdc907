#include "interpreter/dialects/fanuc/coordinates.h"

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
  declared_shift_[axis] += q_W_programmed_[axis] - value;
  refresh();
  q_W_programmed_[axis] = value;
}

void Coordinates::refresh() {
  const AxisPositions before = shift_;
  shift_ = system(0) + system(selected_) + local_shift_ + declared_shift_;
  q_W_programmed_ += before - shift_;
}

}  // namespace g31::fanuc
