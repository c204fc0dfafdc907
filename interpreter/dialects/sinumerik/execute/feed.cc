#include "interpreter/dialects/sinumerik/execute/feed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::sinumerik {
namespace {

// Numbers of group 15.
constexpr int kInverseTime = 1;          // G93
constexpr int kPerMinute = 2;            // G94
constexpr int kCutting = 4;              // G96
constexpr int kCuttingPerMinute = 7;     // G961
constexpr int kPerMinuteAfterwards = 8;  // G971

constexpr double kMmPerMetre = 1000.0;

/// Minutes of one revolution, by the distance x from the turning centre: |x| / k between two
/// bounds.
class TurnTime {
 public:
  explicit TurnTime(const Channel& channel)
      : per_mm_(2.0 * std::numbers::pi / (channel.spindle.cutting_speed * kMmPerMetre)),
        least_(1.0 / std::min(channel.spindle.highest, channel.spindle.limit)),
        most_(channel.spindle.lowest > 0.0 ? 1.0 / channel.spindle.lowest : WorkingArea::kFar) {}

  [[nodiscard]] double at(double x) const {
    return std::clamp(std::abs(x) * per_mm_, least_, std::max(least_, most_));
  }

  /// Over a way on which x changes evenly.
  [[nodiscard]] double mean(double from, double to) const {
    return std::abs(to - from) < 1e-9 ? at(from) : (integral(to) - integral(from)) / (to - from);
  }

 private:
  /// From 0 to x, odd in x.
  [[nodiscard]] double integral(double x) const {
    const double t = std::abs(x) * per_mm_;
    const double bent = std::min(t, most_);
    double sum = t <= least_ ? least_ * t : (bent * bent + least_ * least_) / 2.0;
    sum += t > most_ ? most_ * (t - most_) : 0.0;
    return std::copysign(sum / per_mm_, x);
  }

  double per_mm_;
  double least_;
  double most_;
};

}  // namespace

bool cuts_at_constant_speed(int feed_type) {
  return feed_type == kCutting || feed_type == kCuttingPerMinute;
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

double spindle_speed(const Channel& channel, double radius_mm) {
  const Spindle& spindle = channel.spindle;
  const double share = spindle.override_percent / 100.0;
  if (!cuts_at_constant_speed(channel.group[15])) {
    return spindle.speed <= 0.0
               ? 0.0
               : std::clamp(spindle.speed * share, std::min(spindle.lowest, spindle.highest),
                            spindle.highest);
  }
  return spindle.cutting_speed <= 0.0 ? 0.0 : share / TurnTime(channel).at(radius_mm);
}

double feed_length(const AxisPositions& q_M_from, const AxisPositions& q_M_to) {
  const AxisPositions way = q_M_to - q_M_from;
  const double linear = way.head<3>().norm();
  return linear > 0.0 ? linear : way.tail<3>().norm();
}

double feed_reference(const Channel& channel, const AxisPositions& q_M_from,
                      const AxisPositions& q_M_to) {
  const AxisPositions way = q_M_to - q_M_from;
  const double rotary = way.tail<3>().norm();
  const bool by_time = feed_meaning(channel.group[15]) == FeedMeaning::InverseTime;
  if (by_time || rotary == 0.0 || way.head<3>().norm() > 0.0) {
    return 1.0;
  }
  return rotary / way.cwiseProduct(channel.axis_settings.mm_per_degree).tail<3>().norm();
}

FeedWay feed_way(Channel& channel, const Block& block, const AxisPositions& q_W_end,
                 double length_mm) {
  FeedWay way;
  way.length_mm = length_mm;
  way.radius_from_mm = channel.present()[kTransverseAxis];
  way.radius_to_mm = q_W_end[kTransverseAxis];
  way.feed =
      block.words.has(Address::BlockFeed) ? block.words[Address::BlockFeed].value : channel.feed;
  return way;
}

double switched(const Channel& channel, double feed_mm_min) {
  const runtime::FeedSwitches& switches = channel.feed_switches;
  return switches.dry_run_mm_min > 0.0 ? switches.dry_run_mm_min
                                       : feed_mm_min * switches.override_percent / 100.0 *
                                             channel.axis_settings.path_override_percent / 100.0;
}

Result<double, Failure> feed_in_force(const Channel& channel, const Block& block,
                                      const FeedWay& way) {
  const int type = channel.group[15];
  const double feed = way.feed * channel.mm_per_feed();
  if (feed_meaning(type) == FeedMeaning::InverseTime) {
    if (!(way.feed > 0.0) || !block.words.has(Address::Feed)) {
      return failure(AlarmId::NoFeed, "G93 needs F in every block");
    }
    return switched(channel, way.feed * way.length_mm);
  }
  if (feed <= 0.0) {
    return failure(AlarmId::NoFeed);
  }
  if (feed_meaning(type) == FeedMeaning::PerMinute) {
    return switched(channel, feed);
  }
  if (!cuts_at_constant_speed(type)) {
    const double speed = spindle_speed(channel, 0.0);
    return speed > 0.0 ? Result<double, Failure>(switched(channel, feed * speed))
                       : failure(AlarmId::NoFeed, "G95 needs F and S");
  }
  const double turn = channel.spindle.cutting_speed > 0.0
                          ? TurnTime(channel).mean(way.radius_from_mm, way.radius_to_mm)
                          : 0.0;
  return turn > 0.0 ? Result<double, Failure>(switched(channel, feed / turn))
                    : failure(AlarmId::NoFeed, "G96 needs F and S, and LIMS at X0");
}

}  // namespace g31::sinumerik
