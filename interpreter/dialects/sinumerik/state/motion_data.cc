#include "interpreter/dialects/sinumerik/state/motion_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"

namespace g31::sinumerik {
namespace {

double positive_or(double value, double otherwise) {
  return value > 0.0 ? value : otherwise;
}

}  // namespace

MotionData::MotionData(const Globals& globals)
    : stop_fine_(globals.place("$MA_STOP_LIMIT_FINE")),
      stop_coarse_(globals.place("$MA_STOP_LIMIT_COARSE")),
      stop_factor_(globals.place("$MA_STOP_LIMIT_FACTOR")),
      jerk_(globals.place("$MA_MAX_AX_JERK")),
      acceleration_(globals.place("$MA_MAX_AX_ACCEL")),
      overload_(globals.place("$MA_MAX_ACCEL_OVL_FACTOR")),
      limit_minus_(globals.place("$MA_POS_LIMIT_MINUS")),
      limit_plus_(globals.place("$MA_POS_LIMIT_PLUS")),
      clock_(globals.place("$MN_SYSCLOCK_CYCLE_TIME")),
      clock_ratio_(globals.place("$MN_IPO_SYSCLOCK_TIME_RATIO")),
      stop_mode_(globals.place("$MC_EXACT_POS_MODE")),
      rounding_(globals.place("$MC_SMOOTHING_MODE")),
      longest_compressed_(globals.place("$MC_COMPRESS_BLOCK_PATH_LIMIT")),
      codes_at_start_(globals.place("$MC_GCODE_RESET_VALUES")) {}

void MotionData::take(const machine::AxisData& of_machine, std::vector<double>& numbers) {
  of_machine_ = of_machine;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    numbers[stop_fine_ + i] = of_machine.stop_fine[axis];
    numbers[stop_coarse_ + i] = of_machine.stop_coarse[axis];
    if (is_linear_axis(static_cast<int>(i)) && of_machine.jerk_per_s3[axis] > 0.0) {
      numbers[jerk_ + i] = of_machine.jerk_per_s3[axis] / kMmPerMetre;
    }
  }
  if (!of_machine.jerk_per_s3.isZero(0.0)) {
    numbers[codes_at_start_ + static_cast<std::size_t>(Group::Acceleration) - 1] =
        number_in_group("SOFT");
  }
  changed(numbers);
}

machine::AxisData MotionData::data_of(const std::vector<double>& numbers) const {
  machine::AxisData data = of_machine_;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double factor = positive_or(numbers[stop_factor_ + i], 1.0);
    data.stop_fine[axis] = positive_or(factor * numbers[stop_fine_ + i], data.stop_fine[axis]);
    data.stop_coarse[axis] =
        positive_or(factor * numbers[stop_coarse_ + i], data.stop_coarse[axis]);
    if (is_linear_axis(static_cast<int>(i)) && written_.contains(jerk_ + i) &&
        numbers[jerk_ + i] >= 0.0) {
      data.jerk_per_s3[axis] = kMmPerMetre * numbers[jerk_ + i];
    }
    if (written_.contains(limit_minus_ + i)) {
      data.travel_min[axis] = numbers[limit_minus_ + i];
    }
    if (written_.contains(limit_plus_ + i)) {
      data.travel_max[axis] = numbers[limit_plus_ + i];
    }
    if (is_linear_axis(static_cast<int>(i)) && written_.contains(overload_ + i)) {
      const double cycle_s = numbers[clock_] * numbers[clock_ratio_];
      const double jump =
          kMmPerMetre * numbers[acceleration_ + i] * (numbers[overload_ + i] - 1.0) * cycle_s;
      data.corner_jump_per_s[axis] = std::max(0.0, jump);
    }
  }
  return data;
}

std::optional<machine::AxisData> MotionData::changed(const std::vector<double>& numbers) {
  constexpr std::size_t kKinds = 8;
  taken_.resize(kKinds * kAxisCount);
  bool is_other = std::exchange(is_new_, false);
  double* taken = taken_.data();
  // Each block asks: bytes are compared faster than numbers.
  constexpr std::size_t kBytes = kAxisCount * sizeof(double);
  for (const std::size_t place : {stop_fine_, stop_coarse_, stop_factor_, jerk_, acceleration_,
                                  overload_, limit_minus_, limit_plus_}) {
    if (std::memcmp(taken, &numbers[place], kBytes) != 0) {
      is_other = true;
      std::memcpy(taken, &numbers[place], kBytes);
    }
    taken += kAxisCount;
  }
  return is_other ? std::optional(data_of(numbers)) : std::nullopt;
}

bool MotionData::rounds_by_distance(const std::vector<double>& numbers) const {
  const long digit = std::lround(numbers[rounding_]) / 1000 % 10;
  return digit == 1 || digit == 5;
}

std::optional<machine::BlockEnd> MotionData::stop(const std::vector<double>& numbers,
                                                  bool is_rapid) const {
  const long mode = std::lround(numbers[stop_mode_]);
  switch (is_rapid ? mode % 10 : mode / 10 % 10) {
    case 1:
      return machine::BlockEnd::ExactStop;
    case 2:
      return machine::BlockEnd::CoarseStop;
    case 3:
      return machine::BlockEnd::CommandStop;
    default:
      return std::nullopt;
  }
}

}  // namespace g31::sinumerik
