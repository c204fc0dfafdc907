// Tool carriers: TCARR takes the data of one, TCOABS or TCOFR say at which angles it stands, and
// the frame of the part follows a table that turns.

#include <array>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"

namespace g31::sinumerik {
namespace {

constexpr int kFromAxes = number_in_group("TCOABS");
constexpr int kFrameFollows = number_in_group("PAROT");

/// The origin of the frames that a table takes along, from outside.
Frame frames_on_table(const Channel& channel) {
  FrameSet frames = channel.frames_now;
  frames.part = Frame();
  return frames.outer().chained(channel.settable_now);
}

/// All frames in force but that of the turned table.
Frame frames_of_part(const Channel& channel) {
  Frame all = frames_on_table(channel);
  chain(all, channel.frames_now.inner());
  chain(all, channel.program_frame);
  chain(all, channel.frames_now.cycle);
  return all;
}

/// How the table has moved the part since its axes stood at 0.
Eigen::Isometry3d motion_of_part(const Orientation& orientation) {
  Eigen::Isometry3d motion = orientation.vectors.part_motion(orientation.deg);
  motion.pretranslate(-orientation.vectors.part_motion({0.0, 0.0}).translation());
  return motion;
}

/// TCOABS: where the axes of the carrier stand, or what its data say.
void stand_by_axes(Channel& channel, const ToolCarrier& carrier) {
  Orientation& orientation = channel.orientation;
  const AxisPositions q_M = channel.machine_position();
  for (std::size_t i = 0; i < 2; ++i) {
    const int axis = carrier.axes.at(i);
    orientation.deg.at(i) = axis >= 0 ? q_M[axis] - orientation.basic_deg.at(i)
                                      : carrier.numbers.at(ToolCarrier::kAngle1 + i);
  }
}

/// The axis of the frame that TCOFR, TCOFRX and the like bring along the tool.
int axis_along_tool(const Channel& channel) {
  const int number = channel.group[Group::ToolCarrier];
  return number == number_in_group("TCOFRX")   ? 0
         : number == number_in_group("TCOFRY") ? 1
         : number == number_in_group("TCOFRZ") ? 2
                                               : channel.plane().normal;
}

/// TCOFR: the angles that bring the tool along an axis of the frame.  Of two pairs the one with the
/// lower angle of axis 1 comes first and is taken.
MaybeFailure stand_by_frame(Channel& channel) {
  Orientation& orientation = channel.orientation;
  const auto axes = orientation_of(orientation.vectors);
  const Eigen::Vector3d direction = frames_of_part(channel).turn().col(axis_along_tool(channel));
  const Eigen::Vector3d upright = Eigen::Vector3d::Unit(channel.plane().normal);
  machine::RotaryPairs pairs = axes ? axes->pairs_for(direction, upright) : machine::RotaryPairs();
  orientation.solutions = static_cast<int>(pairs.count);
  if (pairs.count == 0) {
    return failure(AlarmId::CarrierNotReached, fmt::format("TCARR={}", orientation.carrier));
  }
  if (pairs.count == 2 && pairs.all[1].deg < pairs.all[0].deg) {
    std::swap(pairs.all[0], pairs.all[1]);
  }
  orientation.deg = pairs.all[0].deg;
  orientation.free_axes = (pairs.all[0].is_free[0] ? 1 : 0) + (pairs.all[0].is_free[1] ? 2 : 0);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t pair = i / 2 < pairs.count ? i / 2 : 0;
    orientation.found_deg.at(i) =
        pairs.all.at(pair).deg.at(i % 2) + orientation.basic_deg.at(i % 2);
  }
  return std::nullopt;
}

MaybeFailure turns_about_nothing(const Orientation& orientation) {
  const std::array<const Point*, 2> directions = {&orientation.vectors.v1, &orientation.vectors.v2};
  for (std::size_t i = 0; i < 2; ++i) {
    if (orientation.deg.at(i) != 0.0 && directions.at(i)->isZero(0.0)) {
      return failure(AlarmId::CarrierWithoutAxis,
                     fmt::format("TCARR={}, axis {}: {:g} degrees", orientation.carrier, i + 1,
                                 orientation.deg.at(i)));
    }
  }
  return std::nullopt;
}

MaybeFailure select(Channel& channel, double number) {
  Orientation& orientation = channel.orientation;
  if (number == 0.0) {
    orientation.carrier = 0;
    return std::nullopt;
  }
  const int index = static_cast<int>(number);
  const auto found = carrier_in_force(channel, index);
  if (!found) {
    return found.error();
  }
  if (!found.value() || number != static_cast<double>(index)) {
    return failure(AlarmId::BadCarrierNumber, fmt::format("TCARR={:g}", number));
  }
  const ToolCarrier& carrier = *found.value();
  const bool with_fine = channel.carriers_have_fine_offsets();
  const auto vectors = carrier.vectors(with_fine);
  if (!vectors) {
    return vectors.error();
  }
  orientation.carrier = index;
  orientation.vectors = vectors.value();
  orientation.basic_deg = {carrier.basic_position(0, with_fine),
                           carrier.basic_position(1, with_fine)};
  return std::nullopt;
}

MaybeFailure turn_carrier(Channel& channel) {
  if (channel.orientation.carrier == 0) {
    return std::nullopt;
  }
  if (channel.group[Group::ToolCarrier] != kFromAxes) {
    return stand_by_frame(channel);
  }
  const auto found = carrier_in_force(channel, channel.orientation.carrier);
  if (!found) {
    return found.error();
  }
  if (!found.value()) {
    return failure(AlarmId::BadCarrierNumber,
                   fmt::format("TCARR={}: its data are cleared", channel.orientation.carrier));
  }
  stand_by_axes(channel, *found.value());
  return turns_about_nothing(channel.orientation);
}

}  // namespace

void follow_table(Channel& channel) {
  const Orientation& orientation = channel.orientation;
  Frame part;
  if (orientation.carrier != 0 && !orientation.chain &&
      orientation.vectors.type != machine::KinematicType::Tool) {
    const Eigen::Isometry3d motion = motion_of_part(orientation);
    Eigen::Vector3d shift = motion.translation();
    if (channel.group[Group::WorkpieceRotation] == kFrameFollows) {
      part.set_turn(motion.linear());
    } else {
      const Eigen::Vector3d origin =
          frames_on_table(channel).apply(AxisPositions(AxisPositions::Zero())).head<3>();
      shift = motion * origin - origin;
    }
    for (int axis = 0; axis < kLinearAxisCount; ++axis) {
      part.set_component(axis, Component::Coarse, shift[axis]);
    }
  }
  channel.stored_frames.part = part;
  channel.frames_now.part = part;
  channel.frame_written();
}

MaybeFailure take_tool_carrier(Channel& channel, const Block& block) {
  const bool selects = block.words.has(Address::ToolCarrier);
  const bool turns = selects || block.code_of(Group::ToolCarrier) != nullptr;
  const bool has_table =
      turns || block.code_of(Group::WorkpieceRotation) != nullptr ||
      (channel.orientation.carrier != 0 && block.code_of(Group::SettableFrame) != nullptr);
  if (!has_table) {
    return std::nullopt;
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  const Orientation before = channel.orientation;
  MaybeFailure wrong =
      selects ? select(channel, block.words[Address::ToolCarrier].value) : std::nullopt;
  if (!wrong && turns) {
    wrong = turn_carrier(channel);
  }
  if (wrong) {
    channel.orientation = before;
    return wrong;
  }
  follow_table(channel);
  return std::nullopt;
}

}  // namespace g31::sinumerik
