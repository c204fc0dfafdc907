#include "machine/sim/travel_limits.h"

#include <fmt/format.h>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

const char* unit_of_axis(std::size_t axis) {
  return is_linear_axis(static_cast<int>(axis)) ? "mm" : "deg";
}

}  // namespace

TravelLimits::TravelLimits(const MachineSetup& setup)
    : min_(setup.q_M_start), max_(setup.q_M_start), present_() {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    present_[i] = setup.axes[i].present;
    if (present_[i]) {
      min_[static_cast<Eigen::Index>(i)] = setup.axes[i].travel_min;
      max_[static_cast<Eigen::Index>(i)] = setup.axes[i].travel_max;
    }
  }
}

void TravelLimits::set(const AxisPositions& q_M_min, const AxisPositions& q_M_max) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (present_[i]) {
      min_[axis] = q_M_min[axis];
      max_[axis] = q_M_max[axis];
    }
  }
}

std::optional<AxisTravel> TravelLimits::of(int axis) const {
  return present_.at(static_cast<std::size_t>(axis))
             ? std::optional(AxisTravel{min_[axis], max_[axis]})
             : std::nullopt;
}

std::size_t TravelLimits::first_outside(const AxisPositions& q_M) const {
  G31_EXPECTS(!contain(q_M));
  std::size_t i = 0;
  const auto inside = [&](Eigen::Index axis) {
    return q_M[axis] >= min_[axis] && q_M[axis] <= max_[axis];
  };
  while (inside(static_cast<Eigen::Index>(i))) {
    ++i;
  }
  return i;
}

std::string TravelLimits::violation(const AxisPositions& q_M) const {
  const std::size_t i = first_outside(q_M);
  const auto axis = static_cast<Eigen::Index>(i);
  const char letter = kAxisLetters[i];
  const char* const unit = unit_of_axis(i);
  if (!present_[i]) {
    return fmt::format("axis {} asked to go to {} {}: the machine has no axis {}", letter,
                       q_M[axis], unit, letter);
  }
  const bool above = q_M[axis] > max_[axis];
  return fmt::format("axis {} asked to go to {} {}: {} limit is {} {}", letter, q_M[axis], unit,
                     above ? "upper" : "lower", above ? max_[axis] : min_[axis], unit);
}

}  // namespace g31::machine
