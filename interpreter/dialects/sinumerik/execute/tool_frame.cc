// Frames in the direction of the tool: that of the tool carrier or of TRAORI, else along the
// machine axis perpendicular to the plane.

#include <Eigen/Geometry>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {
namespace {

constexpr double kParallelToAxis = 1e-9;  // sines below it

/// Which axis of the new system points along the tool: TOROTX, TOFRAMEY; Z when nothing is said.
int axis_along_tool(std::string_view name) {
  const int axis = axis_index(name.back());
  return axis >= 0 && axis < 2 && name != "TOROT" ? axis : 2;
}

/// The system whose axis `along` is `tool`, all in machine coordinates: the axis behind it in the
/// circle X Y Z stays in the plane of both old ones.
Eigen::Matrix3d turned_to(const Eigen::Matrix3d& old, int along, const Eigen::Vector3d& tool) {
  const int second = (along + 1) % 3;
  const Eigen::Vector3d stays = old.col(second);
  const Eigen::Vector3d turns = old.col(along);
  Eigen::Vector3d direction = stays * turns.dot(tool) - turns * stays.dot(tool);
  if (direction.norm() < kParallelToAxis) {
    direction = stays;  // the tool is square to both
  }
  if (direction.dot(stays) < 0.0) {
    direction = -direction;
  }
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  turned.col(along) = tool;
  turned.col(second) = direction.normalized();
  turned.col((along + 2) % 3) = tool.cross(Eigen::Vector3d(turned.col(second)));
  return turned;
}

}  // namespace

MaybeFailure take_tool_way(const Channel& channel, const Block& block, AxisPositions& q_W_end) {
  if (block.words.has_axes() || is_polar(block) || has_direction(block)) {
    return failure(AlarmId::UnexpectedParameter, "MOVT with an axis or a direction");
  }
  AxisPositions q_ahead = channel.path_to_basic(channel.path_position());
  const AxisPositions q_W = channel.active_frame().undo(q_ahead);
  q_ahead.head<3>() += channel.tool_direction(channel.machine_position());
  const Eigen::Vector3d along_W =
      (channel.active_frame().undo(q_ahead) - q_W).head<3>().normalized();
  const BlockWords::Word& word = block.words[Address::ToolWay];
  const double value = word.value * channel.mm_per_length();
  const bool is_place = word.modification == Modification::Absolute;
  q_W_end.head<3>() += (is_place ? value - along_W.dot(q_W_end.head<3>()) : value) * along_W;
  return std::nullopt;
}

void turn_to_tool(Channel& channel, const GCode& code) {
  Frame& frame = channel.program_frame;
  if (code.name == "TOROTOF") {
    if (frame.turn() == channel.tool_turn) {
      frame.set_turn(Eigen::Matrix3d::Identity());
      channel.frames_changed();
    }
    return;
  }
  const Eigen::Matrix3d below = channel.frames_below().turn();
  const Eigen::Vector3d tool = channel.tool_direction(channel.machine_position());
  const Eigen::Matrix3d turned = turned_to(below * frame.turn(), axis_along_tool(code.name), tool);
  if (code.name.starts_with("TOFRAME")) {
    frame = Frame();
  }
  channel.tool_turn = below.transpose() * turned;
  frame.set_turn(channel.tool_turn);
  channel.frames_changed();
}

}  // namespace g31::sinumerik
