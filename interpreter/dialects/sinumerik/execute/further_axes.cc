#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

constexpr double kSecondsPerMinute = 60.0;

constexpr int first_further() {
  return kFirstFurtherAxis;
}
constexpr int end_of_further() {
  return static_cast<int>(kAxisNumbers);
}

const BlockWords::Word& path_word(const Block& block, int axis) {
  return block.words[address_of_axis(axis)];
}
const BlockWords::Word& positioning_word(const Block& block, int axis) {
  return block.words.positioning[static_cast<std::size_t>(axis)];
}

MaybeFailure beyond_travel(const FurtherAxis& further, int axis, double place) {
  return place < further.travel_min || place > further.travel_max
             ? MaybeFailure(failure(AlarmId::SoftLimit,
                                    fmt::format("{}{:g}: {:g} to {:g}", letter_of_axis(axis), place,
                                                further.travel_min, further.travel_max)))
             : std::nullopt;
}

/// Where a word sends the axis, mm.
Result<double, Failure> place_of(const Channel& channel, int axis, const BlockWords::Word& word) {
  const FurtherAxis* const further = channel.further(axis);
  if (further == nullptr) {
    return no_such_axis(axis);
  }
  const bool adds = counts_from_present(channel, word.modification);
  if (word.modification != Modification::None && !is_incremental(word.modification) &&
      !is_absolute(word.modification)) {
    return failure(AlarmId::BadModification,
                   fmt::format("{} is not a rotary axis", letter_of_axis(axis)));
  }
  const Frame frame = channel.active_frame();
  const double from = adds ? frame.undo(axis, further->at) : 0.0;
  const double way = channel.stored_place(
      axis, word.value, adds ? Channel::Counts::Incremental : Channel::Counts::Absolute,
      word.modification);
  const double place = frame.apply(axis, from + way);
  if (MaybeFailure wrong = beyond_travel(*further, axis, place)) {
    return *wrong;
  }
  return place;
}

double rapid_seconds(const FurtherAxis& axis, double way_mm) {
  return kSecondsPerMinute * std::abs(way_mm) / axis.rapid_per_min;
}

/// POS[W] and POSA[W]: at FA or at rapid.
MaybeFailure position_one(Channel& channel, const Block& block, int axis) {
  if (path_word(block, axis).present) {
    return failure(AlarmId::AddressRepeated, fmt::format("{0} and POS[{0}]", letter_of_axis(axis)));
  }
  const auto place = place_of(channel, axis, positioning_word(block, axis));
  if (!place) {
    return place.error();
  }
  FurtherAxis& further = channel.further_axes.at(axis);
  const double way = place.value() - further.at;
  const double feed = positioning_feed(channel, axis);
  further.at = place.value();
  return pause(channel,
               {feed > 0.0 ? kSecondsPerMinute * std::abs(way) / feed : rapid_seconds(further, way),
                block.where});
}

/// W100 and the like: alone they take F or rapid, with axes of the path they arrive with these.
MaybeFailure go_along(Channel& channel, const Block& block, bool with_path) {
  double square = 0.0;
  double rapid_s = 0.0;
  for (int axis = first_further(); axis < end_of_further(); ++axis) {
    if (!path_word(block, axis).present) {
      continue;
    }
    const auto place = place_of(channel, axis, path_word(block, axis));
    if (!place) {
      return place.error();
    }
    FurtherAxis& further = channel.further_axes.at(axis);
    const double way = place.value() - further.at;
    square += way * way;
    rapid_s = std::max(rapid_s, rapid_seconds(further, way));
    further.at = place.value();
  }
  if (with_path || square == 0.0) {
    return std::nullopt;
  }
  if (channel.group[Group::Motion] == number_in_group("G0")) {
    return pause(channel, {rapid_s, block.where});
  }
  FeedWay way;
  way.length_mm = std::sqrt(square);
  way.feed = feed_of_block(channel, block);
  const auto feed = feed_in_force(channel, block, way);
  return feed ? pause(channel, {kSecondsPerMinute * way.length_mm / feed.value(), block.where})
              : MaybeFailure(feed.error());
}

/// G74 W1=0: to the reference point, whatever the word says.
MaybeFailure to_home(Channel& channel, const Block& block) {
  double seconds = 0.0;
  for (int axis = first_further(); axis < end_of_further(); ++axis) {
    if (!path_word(block, axis).present) {
      continue;
    }
    if (channel.further(axis) == nullptr) {
      return no_such_axis(axis);
    }
    FurtherAxis& further = channel.further_axes.at(axis);
    seconds = std::max(seconds, rapid_seconds(further, further.home - further.at));
    further.at = further.home;
  }
  return pause(channel, {seconds, block.where});
}

}  // namespace

double further_rapid_seconds(const Channel& channel, const Block& block) {
  double seconds = 0.0;
  for (int axis = first_further(); axis < end_of_further(); ++axis) {
    const auto place = path_word(block, axis).present
                           ? place_of(channel, axis, path_word(block, axis))
                           : Result<double, Failure>(0.0);
    if (path_word(block, axis).present && place) {
      const FurtherAxis& further = *channel.further(axis);
      seconds = std::max(seconds, rapid_seconds(further, place.value() - further.at));
    }
  }
  return seconds;
}

MaybeFailure cannot_follow(const Channel& channel, const AxisPositions& q_M_way) {
  for (const auto& [axes, factor] : channel.couplings) {
    if (is_further_axis(axes.first)) {
      const FurtherAxis& further = channel.further_axes.at(axes.first);
      if (MaybeFailure wrong =
              beyond_travel(further, axes.first, further.at + factor * q_M_way[axes.second])) {
        return wrong;
      }
    }
  }
  return std::nullopt;
}

void move_followers(Channel& channel, const AxisPositions& q_M_way) {
  for (const auto& [axes, factor] : channel.couplings) {
    if (is_further_axis(axes.first)) {
      channel.further_axes.at(axes.first).at += factor * q_M_way[axes.second];
    }
  }
}

bool moves_further_axes(const Block& block) {
  for (int axis = first_further(); axis < end_of_further(); ++axis) {
    if (path_word(block, axis).present || positioning_word(block, axis).present) {
      return true;
    }
  }
  return false;
}

MaybeFailure move_further_axes(Channel& channel, const Block& block, FurtherMotion motion) {
  if (motion == FurtherMotion::IntoFrame) {
    return std::nullopt;
  }
  for (int axis = first_further(); axis < end_of_further(); ++axis) {
    if (motion == FurtherMotion::Refused && path_word(block, axis).present) {
      return no_frame_of(axis);
    }
    if (positioning_word(block, axis).present) {
      if (MaybeFailure wrong = position_one(channel, block, axis)) {
        return wrong;
      }
    }
  }
  return motion == FurtherMotion::ToHome
             ? to_home(channel, block)
             : go_along(channel, block, motion == FurtherMotion::WithPath);
}

}  // namespace g31::sinumerik
