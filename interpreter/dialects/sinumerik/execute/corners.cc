#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

using path::CornerWish;
using Kind = CornerWish::Kind;

/// As kCornerWords has their addresses.
constexpr Kind kKinds[] = {Kind::Rounding, Kind::ChamferLength, Kind::ChamferWidth};
static_assert(std::size(kKinds) == std::size(kCornerWords));

/// Of the block, or RNDM.
MaybeFailure take_wish(Channel& channel, const BlockWords& words) {
  CornerWish& wish = channel.corners.wish;
  wish.kind = channel.corners.modal_radius_mm > 0.0 ? Kind::Rounding : Kind::Sharp;
  wish.size_mm = channel.corners.modal_radius_mm;
  wish.feed_mm_min = 0.0;
  wish.tolerance_mm = path::CornerWish().tolerance_mm;
  wish.mixed_size_mm = 0.0;
  int given = 0;
  for (std::size_t i = 0; i < std::size(kCornerWords); ++i) {
    const BlockWords::Word& word = words[kCornerWords[i]];
    if (!word.present) {
      continue;
    }
    if (++given > 1) {
      return failure(second_corner());
    }
    if (MaybeFailure wrong = failure(wrong_corner(word.value))) {
      return wrong;
    }
    wish.kind = word.value > 0.0 ? kKinds[i] : Kind::Sharp;
    wish.size_mm = word.value * channel.mm_per_length();
  }
  return std::nullopt;
}

/// ADIS, ADISPOS and ATOL stay in force.
void take_rounding(Channel& channel, const BlockWords& words) {
  if (words.has(Address::Smoothing)) {
    channel.corners.passing_mm =
        std::max(0.0, words[Address::Smoothing].value * channel.mm_per_length());
  }
  if (words.has(Address::SmoothingRapid)) {
    channel.corners.passing_rapid_mm =
        std::max(0.0, words[Address::SmoothingRapid].value * channel.mm_per_length());
  }
  if (words.has(Address::AxisTolerance)) {
    channel.corners.axis_tolerance_mm =
        std::max(0.0, words[Address::AxisTolerance].value * channel.mm_per_length());
  }
}

/// How G641 to G645 limit a rounding.
enum class RoundedBy { Nothing, Distance, Tolerance };

/// G644 as MD20480 has it; with a transformation as G642, from general knowledge.
RoundedBy rounded_by(const Channel& channel) {
  const int how = channel.group[Group::BlockTransition];
  if (how == number_in_group("G641")) {
    return RoundedBy::Distance;
  }
  if (how == number_in_group("G644")) {
    return channel.motion_data.rounds_by_distance(channel.numbers) && !channel.leads()
               ? RoundedBy::Distance
               : RoundedBy::Tolerance;
  }
  const bool is_one = how == number_in_group("G642") || how == number_in_group("G643") ||
                      how == number_in_group("G645");
  return is_one ? RoundedBy::Tolerance : RoundedBy::Nothing;
}

/// What G641 to G645 make of the corner behind a line at feed, and with ADISPOS of that behind a
/// rapid.
///
/// The control's curve is not documented; an arc leaves a corner of 90 degrees by 0.414 of ADIS.
/// Source: 840D programming 10.2004 p. 5-8; 828D Basic Functions 09/2011, B1, rounding.
void wish_to_pass_by(Channel& channel, path::CornerWish& wish) {
  const RoundedBy by = rounded_by(channel);
  const bool by_distance = by == RoundedBy::Distance;
  const bool is_line = channel.group[Group::Motion] == number_in_group("G1");
  const bool is_rapid = channel.group[Group::Motion] == number_in_group("G0") && by_distance &&
                        channel.corners.passing_rapid_mm > 0.0;
  if (by == RoundedBy::Nothing || !(is_line || is_rapid) || is_compensation_on(channel) ||
      !channel.couplings.empty() || block_end(channel) != machine::BlockEnd::PassOn) {
    return;
  }
  const PlaneOfPath plane = plane_of_path(channel);
  if (!plane.is_parallel) {
    return;
  }
  wish.kind = Kind::PassBy;
  wish.size_mm = std::numeric_limits<double>::infinity();
  if (by_distance) {
    const CornerStage& corners = channel.corners;
    wish.size_mm = (is_rapid ? corners.passing_rapid_mm : corners.passing_mm) * plane.scale;
    wish.mixed_size_mm = std::min(corners.passing_rapid_mm, corners.passing_mm) * plane.scale;
    return;
  }
  const double tolerance = channel.corners.axis_tolerance_mm;
  const Plane axes = channel.plane();
  for (const auto& [index, axis] : {std::pair(0, axes.first), std::pair(1, axes.second)}) {
    wish.tolerance_mm[index] =
        std::max(0.0, tolerance > 0.0 ? tolerance : channel.rounding_tolerance(axis));
  }
}

}  // namespace

MaybeFailure finish_passing_by(Channel& channel, const Block& block) {
  const bool goes_on = commands_motion(block) && block.words.machine_code_count == 0 &&
                       !is_compensation_on(channel) &&
                       (channel.group[Group::Motion] == number_in_group("G1") ||
                        channel.group[Group::Motion] == number_in_group("G0"));
  return !goes_on && channel.corners.contour.holds_to_pass_by() ? finish_corners(channel)
                                                                : std::nullopt;
}

MaybeFailure read_corner(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  CornerStage& corners = channel.corners;
  if (words.has(Address::ModalRounding)) {
    corners.modal_radius_mm = words[Address::ModalRounding].value * channel.mm_per_length();
  }
  if (words.has(Address::ModalCornerFeed)) {
    corners.modal_feed = programmed(channel, words[Address::ModalCornerFeed].value);
  }
  if (MaybeFailure wrong = take_wish(channel, words)) {
    return wrong;
  }
  take_rounding(channel, words);
  if (corners.wish.kind == Kind::Sharp) {
    wish_to_pass_by(channel, corners.wish);
    return std::nullopt;
  }
  const PlaneOfPath plane = plane_of_path(channel);
  if (!plane.is_parallel) {
    return failure(AlarmId::NotImplemented, "RND and CHF in a tilted or unequally scaled plane");
  }
  corners.wish.size_mm *= plane.scale;
  const Feed feed = words.has(Address::CornerFeed)
                        ? programmed(channel, words[Address::CornerFeed].value)
                        : corners.modal_feed;
  if (feed.word > 0.0 && feed_meaning(channel.group[Group::FeedType]) != FeedMeaning::InverseTime) {
    FeedWay way;
    way.feed = feed;
    way.radius_from_mm = way.radius_to_mm = channel.present()[kTransverseAxis];
    const auto in_force = feed_in_force(channel, block, way);
    if (!in_force) {
      return in_force.error();
    }
    corners.wish.feed_mm_min = in_force.value();
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik
