#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

using path::CornerWish;
using Kind = CornerWish::Kind;

struct CornerWord {
  Address address;
  Kind kind;
};
constexpr CornerWord kWords[] = {{Address::Rounding, Kind::Rounding},
                                 {Address::Chamfer, Kind::ChamferLength},
                                 {Address::ChamferWidth, Kind::ChamferWidth}};

/// Of the block, or RNDM.
MaybeFailure take_wish(Channel& channel, const BlockWords& words) {
  CornerWish& wish = channel.corners.wish;
  wish.kind = channel.corners.modal_radius_mm > 0.0 ? Kind::Rounding : Kind::Sharp;
  wish.size_mm = channel.corners.modal_radius_mm;
  wish.feed_mm_min = 0.0;
  int given = 0;
  for (const CornerWord& row : kWords) {
    const BlockWords::Word& word = words[row.address];
    if (!word.present) {
      continue;
    }
    if (++given > 1) {
      return failure(AlarmId::UnexpectedParameter, "only one of RND, CHF and CHR in a block");
    }
    if (word.value < 0.0) {
      return failure(AlarmId::ValueOutOfLimits, fmt::format("{:g}", word.value));
    }
    wish.kind = word.value > 0.0 ? row.kind : Kind::Sharp;
    wish.size_mm = word.value * channel.mm_per_length();
  }
  return std::nullopt;
}

}  // namespace

MaybeFailure read_corner(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  CornerStage& corners = channel.corners;
  if (words.has(Address::ModalRounding)) {
    corners.modal_radius_mm = words[Address::ModalRounding].value * channel.mm_per_length();
  }
  if (words.has(Address::ModalCornerFeed)) {
    corners.modal_feed = words[Address::ModalCornerFeed].value;
  }
  if (MaybeFailure wrong = take_wish(channel, words)) {
    return wrong;
  }
  if (corners.wish.kind == Kind::Sharp) {
    return std::nullopt;
  }
  const PlaneInMachine plane = plane_in_machine(channel);
  if (!plane.is_parallel) {
    return failure(AlarmId::NotImplemented, "RND and CHF in a tilted or unequally scaled plane");
  }
  corners.wish.size_mm *= plane.scale;
  const double feed =
      words.has(Address::CornerFeed) ? words[Address::CornerFeed].value : corners.modal_feed;
  if (feed > 0.0 && feed_meaning(channel.group[Group::FeedType]) != FeedMeaning::InverseTime) {
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
