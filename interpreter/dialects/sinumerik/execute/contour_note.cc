// Contours that a cycle reads before it cuts along them.

#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

using path::PlanePoint;
using path::PlaneWay;

/// Shorter ways are none, mm.
constexpr double kNoWay = 1e-9;

bool is_empty(const PlaneWay& way) {
  return !way.arc && (way.to - way.from).norm() <= kNoWay;
}

PlanePoint in_plane(const Channel& channel, const AxisPositions& q_P) {
  const AxisPositions q_W = channel.path_to_work(q_P);
  const Plane plane = channel.plane();
  return {q_W[plane.first], q_W[plane.second]};
}

std::optional<path::ArcShape> noted_arc(const Channel& channel, const path::PathBlock& path) {
  if (!path.arc) {
    return std::nullopt;
  }
  const Plane plane = channel.plane();
  AxisPositions q_P_centre = path.q_M_end;
  q_P_centre[plane.first] = path.arc->centre.x();
  q_P_centre[plane.second] = path.arc->centre.y();
  using machine::Turn;
  const bool is_clockwise =
      (path.arc->turn == Turn::Clockwise) != plane_of_path(channel).is_mirrored;
  return path::ArcShape{in_plane(channel, q_P_centre),
                        is_clockwise ? Turn::Clockwise : Turn::Counterclockwise};
}

/// A block of the compensation whose axes are those of the plane.
path::PathBlock plain_block(const PlaneWay& way) {
  path::PathBlock block;
  block.q_M_end = path::OffsetPlane().moved(AxisPositions::Zero(), way.to);
  block.arc = way.arc;
  block.g = !way.arc ? 1 : way.arc->turn == machine::Turn::Clockwise ? 2 : 3;
  block.feed_mm_min = 1.0;
  return block;
}

/// Takes what came out of the compensation behind the ways that there are.
void append_ways(std::vector<PlaneWay>& ways, PlanePoint& at, const path::PathItems& items) {
  for (const path::PathItem& item : items) {
    const auto& block = std::get<path::PathBlock>(item);
    const PlanePoint to = path::OffsetPlane().of(block.q_M_end);
    ways.push_back({at, to, block.arc});
    at = to;
  }
}

}  // namespace

MaybeFailure fits_into_contour(const Channel& channel, const Block& block) {
  if (!channel.noted_contour) {
    return std::nullopt;
  }
  const GCode* const code = block.code_of(Group::OneBlock);
  const bool goes_elsewhere = code != nullptr && (code->action == GAction::Reference ||
                                                  code->action == GAction::FixedPoint);
  const bool moves_others = block.words.has_positioning || !channel.couplings.empty() ||
                            channel.suppression != 0 || has_direction(block);
  if (goes_elsewhere || moves_others || goes_by_axes(channel) || listens_to_probe(channel, block)) {
    return failure(AlarmId::ContourMotion);
  }
  return std::nullopt;
}

MaybeFailure note_way(Channel& channel, const path::PathBlock& path) {
  NotedContour& contour = *channel.noted_contour;
  if (contour.ways.size() >= NotedContour::kMostWays) {
    return failure(AlarmId::ContourTooLong,
                   fmt::format("a contour has {} blocks at most", NotedContour::kMostWays));
  }
  contour.ways.push_back(
      {in_plane(channel, contour.q_P), in_plane(channel, path.q_M_end), noted_arc(channel, path)});
  contour.q_P = path.q_M_end;
  return std::nullopt;
}

MaybeFailure begin_contour(Channel& channel) {
  if (MaybeFailure wrong = leave_compensation(channel)) {
    return wrong;
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  channel.arrived_at_machine();
  NotedContour contour;
  contour.q_P = channel.path_position();
  channel.noted_contour = std::move(contour);
  return std::nullopt;
}

Result<std::vector<PlaneWay>, Failure> end_contour(Channel& channel) {
  if (!channel.noted_contour) {
    return failure(AlarmId::ContourTooShort);
  }
  MaybeFailure wrong = line_without_end(channel);
  wrong = wrong ? wrong : finish_corners(channel);
  std::vector<PlaneWay> ways = std::move(channel.noted_contour->ways);
  channel.noted_contour.reset();
  channel.arrived_at_machine();
  if (wrong) {
    return *wrong;
  }
  if (!ways.empty()) {
    ways.erase(ways.begin());
  }
  std::erase_if(ways, is_empty);
  if (ways.empty()) {
    return failure(AlarmId::ContourTooShort);
  }
  return ways;
}

/// By the compensation of a tool, which comes to the contour from beside its start.
Result<std::vector<PlaneWay>, Failure> contour_beside(std::vector<PlaneWay> ways, double left_mm) {
  std::erase_if(ways, is_empty);
  if (ways.empty() || left_mm == 0.0) {
    return ways;
  }
  path::CutterCompensation compensation;
  path::CompensationRules rules;
  rules.outside = path::OutsideCorner::Arc;
  compensation.set_rules(rules);
  path::CompensationCommand command;
  command.state = path::CompensationCommand::State::On;
  command.offset = left_mm;
  const PlanePoint ahead = path::direction_at_start(ways.front());
  const PlanePoint beside = ways.front().from + 2.0 * left_mm * PlanePoint(-ahead.y(), ahead.x());
  const auto at_start = path::OffsetPlane().moved(AxisPositions::Zero(), beside);
  compensation.engage(at_start, command.plane);
  std::vector<PlaneWay> result;
  PlanePoint at = beside;
  const auto take = [&](path::CompensationResult given) -> MaybeFailure {
    if (!given) {
      return failure(AlarmId::CompensationCollision, "finishing allowance of a contour");
    }
    append_ways(result, at, given.value());
    return std::nullopt;
  };
  MaybeFailure wrong =
      take(compensation.take(plain_block({beside, ways.front().from, std::nullopt}), command));
  for (std::size_t i = 0; i < ways.size() && !wrong; ++i) {
    wrong = take(compensation.take(plain_block(ways[i]), command));
  }
  wrong = wrong ? wrong : take(compensation.flush());
  if (wrong) {
    return *wrong;
  }
  G31_EXPECTS(!result.empty());
  result.erase(result.begin());
  std::erase_if(result, is_empty);
  return result;
}

}  // namespace g31::sinumerik
