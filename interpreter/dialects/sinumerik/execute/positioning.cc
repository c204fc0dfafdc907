#include <array>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/measuring.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

constexpr double kMmPerDegree = std::numbers::pi / 180.0;  // on a radius of 1 mm

using Setting = BlockWords::AxisSetting;

/// FA[axis]; of the spindle it says nothing.
void take_feed(Channel& channel, const Setting& setting) {
  if (setting.axis != kSpindleAxis) {
    const double unit =
        is_linear_axis(setting.axis) || is_further_axis(setting.axis) ? channel.mm_per_feed() : 1.0;
    channel.axis_settings.feed[static_cast<std::size_t>(setting.axis)] = setting.value * unit;
  }
}

/// OVRA[axis]
void take_override(Channel& channel, const Setting& setting) {
  if (setting.axis == kSpindleAxis) {
    channel.spindle.override_percent = setting.value;
    tell_spindle(channel);
  } else {
    channel.axis_settings.override_percent[static_cast<std::size_t>(setting.axis)] = setting.value;
  }
}

/// FGREF[axis]
void take_reference_radius(Channel& channel, const Setting& setting) {
  if (!is_machine_axis(setting.axis)) {
    return;
  }
  channel.axis_settings.counts_as_usual = false;
  channel.axis_settings.mm_per_degree[setting.axis] =
      setting.value * channel.mm_per_length() * kMmPerDegree;
}

/// FINEA[axis], COARSEA[axis], IPOENDA[axis]
void take_motion_end(Channel& channel, const Setting& setting) {
  channel.axis_settings.motion_end[static_cast<std::size_t>(setting.axis)] =
      static_cast<MotionEnd>(setting.value);
}

/// DIAMONA[axis] and its kind
void take_diameter(Channel& channel, const Setting& setting) {
  channel.axis_settings.diameter[static_cast<std::size_t>(setting.axis)] =
      static_cast<int>(setting.value);
}

/// The machine has its own.
void take_nothing(Channel& /*channel*/, const Setting& /*setting*/) {}

void take_setting(Channel& channel, const Setting& setting) {
  switch (setting.word) {
#define Path() break
#define Positioning() break
#define Measuring() break
#define Setting(f) return f(channel, setting)
#define AxisSetting(f) return f(channel, setting)
#define Switch(f) return f(channel, setting)
#define AxisSwitch(f) return f(channel, setting)
#define Refused() break
#define AXIS_WORD(id, name, role, least, most, text) \
  case AxisWordId::id:                               \
    role;
#include "interpreter/dialects/sinumerik/vocabulary/axis_words.def"
#undef AXIS_WORD
#undef Refused
#undef AxisSwitch
#undef Switch
#undef AxisSetting
#undef Setting
#undef Measuring
#undef Positioning
#undef Path
  }
  contract_violated("only settings are kept as settings", __FILE__, __LINE__);
}

/// A geometry axis moves alone, in its own direction and beside the path only.
MaybeFailure cannot_position(const Channel& channel, int axis, const AxisPositions& q_M_way) {
  AxisPositions others = q_M_way;
  others[axis] = 0.0;
  if (!others.isZero(1e-9)) {
    return failure(AlarmId::NotImplemented,
                   fmt::format("POS[{}] in a frame that turns it away from its machine axis",
                               kAxisLetters[axis]));
  }
  const Plane plane = channel.plane();
  return channel.cutter.compensation.engaged() && (axis == plane.first || axis == plane.second)
             ? MaybeFailure(
                   failure(AlarmId::NotImplemented,
                           fmt::format("POS[{}] in the plane of G41 and G42", kAxisLetters[axis])))
             : std::nullopt;
}

/// Where POS sends an axis, work coordinates.
Result<double, Failure> positioning_place(Channel& channel, const Block& block, int axis) {
  const auto index = static_cast<std::size_t>(axis);
  if (block.words.axis(axis).present) {
    return failure(AlarmId::AddressRepeated, fmt::format("{0} and POS[{0}]", kAxisLetters[index]));
  }
  AxisPositions q_W_end = channel.present();
  const auto place = programmed_place(channel, axis, block.words.positioning[index], q_W_end[axis]);
  if (!place) {
    return place.error();
  }
  q_W_end[axis] = place.value();
  const AxisPositions q_M_way = channel.to_machine(q_W_end) - channel.machine_position();
  if (MaybeFailure wrong = cannot_position(channel, axis, q_M_way)) {
    return *wrong;
  }
  return place.value();
}

/// The path begins behind the axis: where the next block might begin while it brakes, this is how
/// near the machine comes.
machine::BlockEnd end_of(MotionEnd motion_end) {
  switch (motion_end) {
    case MotionEnd::Coarse:
      return machine::BlockEnd::CoarseStop;
    case MotionEnd::Command:
    case MotionEnd::Braking:
      return machine::BlockEnd::CommandStop;
    case MotionEnd::Fine:
      break;
  }
  return machine::BlockEnd::ExactStop;
}

/// @param place_W  work coordinate of the axis
MaybeFailure move_one(Channel& channel, const Block& block, int axis, double place_W) {
  AxisPositions q_W_end = channel.present();
  q_W_end[axis] = place_W;
  if (measures_positioning(block)) {
    return measure_axis(channel, block, q_W_end, positioning_feed(channel, axis));
  }
  path::PathBlock path;
  path.q_M_end = channel.to_path(q_W_end);
  const AxisSettings& settings = channel.axis_settings;
  path.feed_mm_min = positioning_feed(channel, axis);
  path.g = path.feed_mm_min > 0.0 ? 1 : 0;
  path.ends = end_of(settings.motion_end[static_cast<std::size_t>(axis)]);
  path.where = block.where;
  const double cutting_s = channel.outlet.cutting_s();
  MaybeFailure wrong = travel_to(channel, path, q_W_end);
  channel.outlet.set_cutting_s(cutting_s);  // which counts the path only
  return wrong;
}

/// Nothing moves before all of them can: one does not change where another one goes.
MaybeFailure move_each(Channel& channel, const Block& block) {
  std::array<std::optional<double>, kAxisCount> places_W;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!block.words.positioning[axis].present) {
      continue;
    }
    const auto place = positioning_place(channel, block, static_cast<int>(axis));
    if (!place) {
      return place.error();
    }
    places_W[axis] = place.value();
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    MaybeFailure wrong = places_W[axis]
                             ? move_one(channel, block, static_cast<int>(axis), *places_W[axis])
                             : std::nullopt;
    if (wrong) {
      return wrong;
    }
  }
  return std::nullopt;
}

}  // namespace

void take_axis_settings(Channel& channel, const Block& block) {
  if (block.words.has(Address::Override)) {
    channel.axis_settings.path_override_percent = block.words[Address::Override].value;
  }
  for (const BlockWords::AxisSetting& setting : block.words.axis_settings) {
    take_setting(channel, setting);
  }
}

MaybeFailure move_positioning_axes(Channel& channel, const Block& block) {
  const bool measures = measures_positioning(block);
  if (MaybeFailure wrong = measures ? cannot_measure_positioning(block) : std::nullopt) {
    return wrong;
  }
  if (MaybeFailure wrong = measures ? leave_compensation(channel) : finish_corners(channel)) {
    return wrong;
  }
  take_axis_data(channel);
  // The corner of the block and the direction for CT are of its path.
  const Eigen::Vector3d along_P_end = channel.along_P_end;
  const path::CornerWish wish = std::exchange(channel.corners.wish, {});
  MaybeFailure wrong = move_each(channel, block);
  channel.corners.wish = wish;
  channel.along_P_end = along_P_end;
  return wrong;
}

}  // namespace g31::sinumerik
