#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/circle_form.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {
namespace {

/// Sines of angles below are those of parallel lines.
constexpr double kParallel = 1e-9;

PlaneVector direction_of(double degrees) {
  return {mathematics(FunctionId::COS, degrees, 0.0).value_or(0.0),
          mathematics(FunctionId::SIN, degrees, 0.0).value_or(0.0)};
}

Failure undetermined(double degrees) {
  return failure(AlarmId::BadSyntax,
                 fmt::format("ANG={:g}: the lines do not determine their end", degrees));
}

/// The end of the held line, work coordinates: where it meets the line of the present block.
Result<PlaneVector, Failure> meeting_point(const Channel& channel, const Block& block,
                                           const PlaneVector& from, const PlaneVector& to) {
  const Plane plane = channel.plane();
  if (counts_from_present(channel, block.words.axis(plane.first).modification) ||
      counts_from_present(channel, block.words.axis(plane.second).modification)) {
    return failure(AlarmId::NotImplemented, "the end of two lines by ANG: in absolute coordinates");
  }
  const double degrees = block.words[Address::Angle].value;
  const PlaneVector first = direction_of(channel.held_line->degrees);
  const PlaneVector second = direction_of(degrees);
  const double turn = cross(first, second);
  if (std::abs(turn) < kParallel) {
    return undetermined(degrees);
  }
  return PlaneVector(from + first * (cross(to - from, second) / turn));
}

/// As if the block of the held line were running.
MaybeFailure travel_held(Channel& channel, const HeldLine& line, const Block& block,
                         const AxisPositions& q_W_end) {
  path::PathBlock path;
  path.q_M_end = channel.to_path(q_W_end);
  path.where = line.where;
  path.calls = line.calls;
  path.g = line.g;
  take_modes(channel, path);
  path.ends = line.ends;
  path.rapid_path = line.rapid_path;
  if (path.g == 1) {
    FeedWay way =
        feed_way(channel, block, q_W_end, feed_length(channel.path_position(), path.q_M_end));
    way.feed = line.feed;
    const auto feed = feed_in_force(channel, block, way);
    if (!feed) {
      return feed.error();
    }
    path.feed_mm_min = feed.value();
  }
  const path::CornerWish wish = std::exchange(channel.corners.wish, line.wish);
  const path::CompensationCommand command = std::exchange(channel.cutter.command, line.command);
  MaybeFailure wrong = travel_to(channel, path, q_W_end);
  channel.corners.wish = wish;
  channel.cutter.command = command;
  return wrong;
}

}  // namespace

int plane_words(const Channel& channel, const Block& block) {
  const Plane plane = channel.plane();
  return (block.words.axis(plane.first).present ? 1 : 0) +
         (block.words.axis(plane.second).present ? 1 : 0);
}

MaybeFailure take_angle(const Channel& channel, const Block& block, AxisPositions& q_W_end,
                        const AxisPositions& q_W_from) {
  const Plane plane = channel.plane();
  const double degrees = block.words[Address::Angle].value;
  const int given = plane_words(channel, block);
  if (given == 2 && channel.held_line) {
    return std::nullopt;
  }
  if (given != 1 || channel.held_line) {
    return failure(AlarmId::BadSyntax,
                   "ANG takes one axis of the plane; both axes end a line begun with ANG alone");
  }
  const bool by_first = block.words.axis(plane.first).present;
  const int known = by_first ? plane.first : plane.second;
  const int wanted = by_first ? plane.second : plane.first;
  const PlaneVector along = direction_of(degrees);
  const double advance = by_first ? along.x() : along.y();
  if (std::abs(advance) < kParallel) {
    return undetermined(degrees);
  }
  q_W_end[wanted] = q_W_from[wanted] + (q_W_end[known] - q_W_from[known]) *
                                           (by_first ? along.y() : along.x()) / advance;
  return std::nullopt;
}

MaybeFailure hold_line(Channel& channel, const Block& block) {
  if (channel.held_line) {
    return line_without_end(channel);
  }
  const int motion = channel.group[Group::Motion];
  if (motion != number_in_group("G0") && motion != number_in_group("G1")) {
    return failure(AlarmId::BadSyntax, "ANG alone needs G0 or G1");
  }
  HeldLine line;
  line.degrees = block.words[Address::Angle].value;
  const auto q_W_end = programmed_end(channel, block);
  if (!q_W_end) {
    return q_W_end.error();
  }
  line.q_W_end = q_W_end.value();
  line.feed = feed_of_block(channel, block);
  line.g = motion == number_in_group("G0") ? 0 : 1;
  line.ends = block_end(channel);
  line.rapid_path = channel.rapid_path();
  line.where = block.where;
  line.calls = channel.outlet.calls_now();
  line.wish = channel.corners.wish;
  line.command = channel.cutter.command;
  channel.held_line = line;
  channel.cutter.fed = true;  // its motion comes with the next block
  return std::nullopt;
}

MaybeFailure release_line(Channel& channel, const Block& block,
                          const AxisPositions& q_W_block_end) {
  const Plane plane = channel.plane();
  const auto meeting = meeting_point(channel, block, in_plane(channel.present(), plane),
                                     in_plane(q_W_block_end, plane));
  if (!meeting) {
    return meeting.error();
  }
  const HeldLine line = *channel.held_line;
  channel.held_line.reset();
  AxisPositions q_W_end = line.q_W_end;
  q_W_end[plane.first] = meeting.value().x();
  q_W_end[plane.second] = meeting.value().y();
  MaybeFailure wrong = travel_held(channel, line, block, q_W_end);
  if (wrong && !wrong->where) {
    wrong->where = line.where;
    wrong->calls = line.calls;
  }
  return wrong;
}

MaybeFailure line_without_end(Channel& channel) {
  if (!channel.held_line) {
    return std::nullopt;
  }
  Failure wrong =
      failure(AlarmId::BadSyntax,
              "a line by ANG alone ends with the next one: both axes of the plane and ANG");
  wrong.where = channel.held_line->where;
  wrong.calls = channel.held_line->calls;
  channel.held_line.reset();
  return wrong;
}

}  // namespace g31::sinumerik
