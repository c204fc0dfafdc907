#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

constexpr int kAreaOn = number_in_group("WALIMON");
constexpr double kSlack = 1e-6;

}  // namespace

bool is_place(const Eigen::Ref<const Eigen::VectorXd>& place) {
  return place.allFinite() && place.cwiseAbs().maxCoeff() <= kFarthestPlace;
}

MaybeFailure limit(Channel& channel, const Block& block, const GCode& code) {
  const bool is_lower = code.action == GAction::LowerLimit;
  AxisPositions& q = is_lower ? channel.working_area.q_low : channel.working_area.q_high;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const BlockWords::Word& word = block.words.axis(axis);
    if (word.present) {
      q[axis] = channel.stored_datum(axis, word.value);
      channel.working_area.is_set = true;
    }
  }
  const auto take_speed = [&](int number, Spindle& spindle, double speed) {
    if (is_lower) {
      spindle.lowest = speed;
    } else if (!channel.keep_speed_limit(Channel::SpeedDatum::OfG26, number, speed)) {
      spindle.highest = speed;
    }
  };
  if (block.words.has(Address::Speed)) {
    take_speed(channel.master_number(), channel.spindle, block.words[Address::Speed].value);
  }
  for (const BlockWords::SpindleWord& word : block.words.spindle_words) {
    if (word.address == Address::Speed) {
      take_speed(word.spindle, channel.other_spindles[word.spindle], word.value);
    }
  }
  return std::nullopt;
}

MaybeFailure out_of_reach(const Channel& channel, const AxisPositions& q_P_end) {
  if (!is_place(q_P_end)) {
    return failure(AlarmId::ValueOutOfLimits, "the axes do not go so far");
  }
  if (!channel.working_area.is_set || channel.group[Group::WorkingArea] != kAreaOn) {
    return std::nullopt;
  }
  const AxisPositions q_tip = channel.path_to_basic(q_P_end);
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const double low = channel.working_area.q_low[axis] - kSlack;
    const double high = channel.working_area.q_high[axis] + kSlack;
    if (q_tip[axis] < low || q_tip[axis] > high) {
      return failure(AlarmId::WorkingArea,
                     fmt::format("{}{:.4f}{}", kAxisLetters[axis], q_tip[axis],
                                 q_tip[axis] < low ? " is below G25" : " is above G26"));
    }
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik
