#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

using path::CompensationCommand;
using path::CompensationRules;
using State = CompensationCommand::State;

constexpr int kOff = number_in_group("G40");
constexpr int kRight = number_in_group("G42");
constexpr int kFeedAtTool = number_in_group("CFTCP");
constexpr int kFeedInside = number_in_group("CFIN");
constexpr int kRoundCorners = number_in_group("KONT");
constexpr int kIntersection = number_in_group("G451");

/// How far directions and scales may differ by rounding.
constexpr double kSame = 1e-12;

/// The compensation itself never gives up reading ahead: too many such blocks are an alarm.
constexpr int kNoIdleLimit = 1'000'000;

CompensationRules::ArcFeed arc_feed_of(int number) {
  switch (number) {
    case kFeedAtTool:
      return CompensationRules::ArcFeed::AtTool;
    case kFeedInside:
      return CompensationRules::ArcFeed::AtContourInside;
    default:
      return CompensationRules::ArcFeed::AtContour;
  }
}

CompensationRules rules_of(const Channel& channel) {
  CompensationRules rules;
  rules.start_up =
      channel.group[Group::Approach] == kRoundCorners ? path::StartUp::TypeB : path::StartUp::TypeA;
  rules.idle_limit = kNoIdleLimit;
  rules.outside = channel.group[Group::OutsideCorner] == kIntersection
                      ? path::OutsideCorner::Intersection
                      : path::OutsideCorner::Arc;
  rules.arc_feed = arc_feed_of(channel.group[Group::ArcFeed]);
  return rules;
}

bool is_side(std::uint16_t bits) {
  return g_codes()[unpacked(bits).row].group == Group::RadiusCompensation;
}

/// Moves that are no part of a contour: the compensation ends in front of them.
bool leaves(const Channel& channel, const Block& block) {
  const GCode* const special = block.code_of(Group::OneBlock);
  const bool to_point = special != nullptr && (special->action == GAction::Reference ||
                                               special->action == GAction::FixedPoint);
  return to_point || channel.suppression != 0 || listens_to_probe(channel, block);
}

Result<CompensationCommand, Failure> command_of(const Channel& channel, const Block& block) {
  CompensationCommand command;
  const bool on = is_compensation_on(channel);
  if (channel.group[Group::RadiusCompensation] != kOff && channel.tool == 0) {
    return failure(AlarmId::CompensationWithoutTool);
  }
  if (on && channel.group[Group::Approach] == kRoundCorners &&
      channel.group[Group::OutsideCorner] == kIntersection) {
    return failure(AlarmId::NotImplemented, "KONT with G451");
  }
  const PlaneOfPath plane = plane_of_path(channel);
  if (on && !plane.is_parallel) {
    return failure(AlarmId::NotImplemented, "G41 and G42 in a tilted or unequally scaled plane");
  }
  command.state = on ? State::On : State::Off;
  command.plane = {channel.plane().first, channel.plane().second};
  // A mirrored path has its part on the other side.
  const bool right = (channel.group[Group::RadiusCompensation] == kRight) != plane.is_mirrored;
  command.offset = right ? -channel.tool_radius() : channel.tool_radius();
  const auto& codes = block.codes;
  command.written = std::any_of(codes.begin(), codes.end(), is_side)
                        ? CompensationCommand::Written::Here
                        : CompensationCommand::Written::Before;
  command.where = block.where;
  return command;
}

}  // namespace

bool is_compensation_on(const Channel& channel) {
  return channel.group[Group::RadiusCompensation] != kOff && channel.edge != 0;
}

PlaneOfPath plane_of_path(const Channel& channel) {
  const Plane plane = channel.plane();
  AxisPositions q[3] = {AxisPositions::Zero(), AxisPositions::Zero(), AxisPositions::Zero()};
  q[1][plane.first] = 1.0;
  q[2][plane.second] = 1.0;
  const Frame frame = channel.active_frame();
  AxisPositions first = frame.apply(q[1]) - frame.apply(q[0]);
  AxisPositions second = frame.apply(q[2]) - frame.apply(q[0]);
  if (channel.orientation.chain) {
    const Eigen::Matrix3d turn = channel.path_turn().transpose();
    first.head<3>() = (turn * first.head<3>()).eval();
    second.head<3>() = (turn * second.head<3>()).eval();
  }
  const double out = std::abs(first[plane.normal]) + std::abs(second[plane.normal]);
  const double stretch = std::abs(first.head<3>().norm() - second.head<3>().norm());
  const double cross =
      first[plane.first] * second[plane.second] - first[plane.second] * second[plane.first];
  const bool is_even = stretch <= kSame;
  return {out <= kSame && is_even, is_even, cross < 0.0, first.head<3>().norm()};
}

MaybeFailure read_compensation(Channel& channel, const Block& block) {
  CutterStage& cutter = channel.cutter;
  if (channel.noted_contour) {
    if (channel.group[Group::RadiusCompensation] != kOff) {
      channel.group[Group::RadiusCompensation] = kOff;
      channel.offset_changed();
    }
    return std::nullopt;
  }
  if (leaves(channel, block)) {
    return leave_compensation(channel);
  }
  const bool begins_or_ends = block.code_of(Group::RadiusCompensation) != nullptr;
  if (MaybeFailure wrong = begins_or_ends ? finish_corners(channel) : std::nullopt) {
    return wrong;
  }
  if (channel.group[Group::RadiusCompensation] == kOff && !cutter.compensation.engaged()) {
    return std::nullopt;
  }
  const auto command = command_of(channel, block);
  if (!command) {
    return command.error();
  }
  cutter.command = command.value();
  cutter.fed = false;
  cutter.compensation.set_rules(rules_of(channel));
  if (cutter.command.state == State::On && !cutter.compensation.engaged()) {
    cutter.compensation.engage(channel.path_position(), cutter.command.plane);
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik
