#include "interpreter/dialects/sinumerik/execute/feed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/turn_time.h"

namespace g31::sinumerik {
namespace {

// Numbers of group 15.
constexpr int kInverseTime = number_in_group("G93");
constexpr int kPerMinute = number_in_group("G94");
constexpr int kCutting = number_in_group("G96");
constexpr int kAfterwards = number_in_group("G97");
constexpr int kCuttingPerMinute = number_in_group("G961");
constexpr int kPerMinuteAfterwards = number_in_group("G971");

/// mm/min: slower and faster than any axis goes.
constexpr double kLeastFeed = 1e-9;
constexpr double kMostFeed = 1e12;

/// rev/min that LIMS lets the master spindle turn.
double limit_of_master(const Channel& channel) {
  const double of_datum = channel.speed_limit(Channel::SpeedDatum::OfLims, channel.master_number());
  return std::min(of_datum, channel.spindle.limit);
}

/// Of G96, with OVRA.
runtime::TurnTime turn_time(const Channel& channel) {
  const Spindle& spindle = channel.spindle;
  return {spindle.cutting_speed * kMmPerMetre * spindle.override_percent / 100.0, spindle.lowest,
          std::min({spindle.highest, limit_of_master(channel),
                    highest_speed(channel, channel.master_number())})};
}

/// Whether it turns under G96.
bool cuts(const Spindle& spindle) {
  return spindle.cutting_speed > 0.0 && spindle.override_percent > 0.0;
}

/// On a straight way: the feed of the machine, which is that of the linear axes, or of rotary ones
/// that move alone, over that of the axes of FGROUP.  Where none of them moves, F is of the others.
double straight_share(const AxisSettings& settings, const AxisPositions& q_M_way) {
  AxisPositions counted = q_M_way.cwiseProduct(settings.mm_per_degree);
  const double all_rotary = counted.tail<3>().norm();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    counted[static_cast<int>(axis)] *= settings.counts[axis] ? 1.0 : 0.0;
  }
  const double linear = q_M_way.head<3>().norm();
  const double of_machine = linear > 0.0 ? linear : q_M_way.tail<3>().norm();
  const double of_group = counted.norm() > 0.0 ? counted.norm()
                          : linear > 0.0       ? linear
                                               : all_rotary;
  return of_machine > 0.0 ? of_machine / of_group : 1.0;
}

}  // namespace

bool cuts_at_constant_speed(int feed_type) {
  return feed_type == kCutting || feed_type == kCuttingPerMinute;
}

bool keeps_speed(int feed_type) {
  return feed_type == kAfterwards || feed_type == kPerMinuteAfterwards;
}

double metres_of_cutting(const Channel& channel) {
  constexpr double kMetresPerFoot = 0.3048;
  return channel.mm_per_length() == 1.0 ? 1.0 : kMetresPerFoot;
}

FeedMeaning feed_meaning(int feed_type) {
  switch (feed_type) {
    case kInverseTime:
      return FeedMeaning::InverseTime;
    case kPerMinute:
    case kCuttingPerMinute:
    case kPerMinuteAfterwards:
      return FeedMeaning::PerMinute;
    default:
      return FeedMeaning::PerRevolution;
  }
}

double highest_speed(const Channel& channel, int spindle) {
  return std::min(channel.speed_limit(Channel::SpeedDatum::OfMachine, spindle),
                  channel.speed_limit(Channel::SpeedDatum::OfG26, spindle));
}

double limited_speed(const Channel& channel, double programmed) {
  const double limited = std::min(channel.spindle.limited(programmed),
                                  highest_speed(channel, channel.master_number()));
  return channel.group[Group::FeedType] == kAfterwards ? std::min(limited, limit_of_master(channel))
                                                       : limited;
}

double spindle_speed(const Channel& channel, double radius_mm) {
  const Spindle& spindle = channel.spindle;
  if (!cuts_at_constant_speed(channel.group[Group::FeedType])) {
    return spindle.speed <= 0.0 ? 0.0 : limited_speed(channel, spindle.speed);
  }
  const double speed = cuts(spindle) ? 1.0 / turn_time(channel).at(radius_mm) : 0.0;
  return std::isfinite(speed) ? speed : 0.0;
}

double kept_speed(Channel& channel) {
  const double override_percent = std::exchange(channel.spindle.override_percent, 100.0);
  const double speed = spindle_speed(channel, channel.present()[kTransverseAxis]);
  channel.spindle.override_percent = override_percent;
  return speed;
}

double feed_length(const AxisPositions& q_M_from, const AxisPositions& q_M_to) {
  const double linear = (q_M_to.head<3>() - q_M_from.head<3>()).norm();
  return linear > 0.0 ? linear : (q_M_to.tail<3>() - q_M_from.tail<3>()).norm();
}

Result<double, Failure> helix_share(const Channel& channel, double arc_mm, double rise_mm) {
  const Plane plane = channel.plane();
  const std::array<bool, kAxisCount>& counts = channel.axis_settings.counts;
  const auto has = [&](int axis) { return counts[static_cast<std::size_t>(axis)]; };
  if (has(plane.first) != has(plane.second)) {
    return failure(AlarmId::NotImplemented, "a circle with one axis of its plane in FGROUP");
  }
  const double length = std::hypot(arc_mm, rise_mm);
  const double counted =
      std::hypot(has(plane.first) ? arc_mm : 0.0, has(plane.normal) ? rise_mm : 0.0);
  return counted > 0.0 ? length / counted : 1.0;
}

Feed programmed(const Channel& channel, double word) {
  const bool counts_time = feed_meaning(channel.group[Group::FeedType]) == FeedMeaning::InverseTime;
  return {word, counts_time ? 1.0 : channel.mm_per_feed()};
}

Feed feed_of_block(const Channel& channel, const Block& block) {
  const auto& word = block.words[Address::BlockFeed];
  return word.present ? programmed(channel, word.value) : channel.feed;
}

FeedWay feed_way(Channel& channel, const Block& block, const AxisPositions& q_W_end,
                 double length_mm) {
  FeedWay way;
  way.length_mm = length_mm;
  way.radius_from_mm = channel.present()[kTransverseAxis];
  way.radius_to_mm = q_W_end[kTransverseAxis];
  way.feed = feed_of_block(channel, block);
  if (way.feed.per_word != 1.0) {
    const AxisPositions way_W = q_W_end - channel.present();
    way.turns = way_W.head<3>().isZero(0.0) && !way_W.isZero(0.0);
  }
  if (!channel.axis_settings.counts_as_usual) {
    way.share = straight_share(channel.axis_settings,
                               channel.to_machine(q_W_end) - channel.machine_position());
  }
  return way;
}

double positioning_feed(const Channel& channel, int axis) {
  const auto at = static_cast<std::size_t>(axis);
  return channel.axis_settings.feed[at] * channel.axis_settings.override_percent[at] / 100.0 *
         channel.feed_switches.override_percent / 100.0;
}

double switched(const Channel& channel, double feed_mm_min) {
  const runtime::FeedSwitches& switches = channel.feed_switches;
  return switches.dry_run_mm_min > 0.0 ? switches.dry_run_mm_min
                                       : feed_mm_min * switches.override_percent / 100.0 *
                                             channel.axis_settings.path_override_percent / 100.0 *
                                             (channel.action_override_percent / 100.0);
}

namespace {

/// Minutes that a turn of G96 takes, over the way.
double mean_turn(const runtime::TurnTime& time, const FeedWay& way) {
  if (!way.circle) {
    return time.mean(way.radius_from_mm, way.radius_to_mm);
  }
  const auto on_circle = [&circle = *way.circle](double fraction) {
    const double angle = fraction * circle.sweep_rad;
    return circle.centre_mm + circle.out_mm * std::cos(angle) + circle.ahead_mm * std::sin(angle);
  };
  const double left = way.radius_to_mm - on_circle(1.0);
  return runtime::mean_over_arc(time, way.circle->sweep_rad, [&](double fraction) {
    return on_circle(fraction) + fraction * left;
  });
}

}  // namespace

Result<double, Failure> mean_speed(const Channel& channel, const FeedWay& way) {
  if (!cuts_at_constant_speed(channel.group[Group::FeedType])) {
    const double speed = spindle_speed(channel, 0.0);
    return speed > 0.0 ? Result<double, Failure>(speed)
                       : failure(AlarmId::NoFeed, "the spindle needs S, with G97 a LIMS above 0");
  }
  if (!(channel.spindle.cutting_speed > 0.0)) {
    return failure(AlarmId::NoCuttingSpeed);
  }
  const double speed = cuts(channel.spindle) ? 1.0 / mean_turn(turn_time(channel), way) : 0.0;
  return speed > 0.0 && std::isfinite(speed)
             ? Result<double, Failure>(speed)
             : failure(AlarmId::NoFeed, "G96 needs F, and a LIMS above 0 at X0");
}

void tell_standing_spindle(Channel& channel, const Block& block) {
  const Spindle& spindle = channel.spindle;
  if (!spindle.turns() && !spindle.builder_may_turn) {
    channel.warnings.add(channel.diagnostics, source::DiagnosticId::FeedWithoutTurning,
                         block.where);
  }
}

namespace {

/// mm/min, as F, S and the way make it, without override.
Result<double, Failure> programmed_feed(Channel& channel, const Block& block, const FeedWay& way) {
  const int type = channel.group[Group::FeedType];
  const double feed = (way.turns ? way.feed.word : way.feed.kept()) * way.share;
  if (feed_meaning(type) == FeedMeaning::InverseTime) {
    if (!(way.feed.word > 0.0) || !block.words.has(Address::Feed)) {
      return failure(AlarmId::NoFeed, "G93 needs F in every block");
    }
    // A block without a way takes no time: any feed will do.
    return way.length_mm > 0.0 ? way.feed.word * way.length_mm : way.feed.word;
  }
  if (!is_feed(feed)) {
    return failure(no_feed());
  }
  if (feed_meaning(type) == FeedMeaning::PerMinute) {
    return feed;
  }
  const auto speed = mean_speed(channel, way);
  if (speed && channel.feed_switches.dry_run_mm_min <= 0.0) {
    tell_standing_spindle(channel, block);
  }
  return speed ? Result<double, Failure>(feed * speed.value()) : speed;
}

/// G63 goes at its feed, whatever the override says (programming manual, fundamentals: G63).
bool taps(const Block& block) {
  const GCode* const code = block.code_of(Group::OneBlock);
  return code != nullptr && code->name == "G63";
}

}  // namespace

Result<double, Failure> feed_in_force(Channel& channel, const Block& block, const FeedWay& way) {
  auto feed = programmed_feed(channel, block, way);
  if (feed && !taps(block)) {
    feed = switched(channel, feed.value());
  }
  const bool can_be = !feed || (feed.value() >= kLeastFeed && feed.value() <= kMostFeed);
  return can_be ? feed
                : failure(AlarmId::FeedNotPositive, fmt::format("{:g} mm/min", feed.value()));
}

}  // namespace g31::sinumerik
