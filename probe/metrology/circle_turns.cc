#include "probe/metrology/circle_turns.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>

#include "probe/metrology/circle_standstills.h"

namespace g31::metrology {
namespace {

/// So far back is a reversal; less is noise.
constexpr double kReversal = 2.0 * kDegree;
constexpr double kLeastTurn = 10.0 * kDegree;

/// Takes the samples on the circle one by one and cuts them where their angle turns back.
class TurnCutter {
 public:
  TurnCutter(const PlaneSamples& samples, std::vector<CircleTurn>& turns)
      : samples_(samples), turns_(turns) {}

  void take(std::size_t i, double angle) {
    if (angles_.empty()) {
      first_ = i;
      begin_ = low_ = high_ = i;
      angles_.push_back(angle);
      last_ = angle;
      return;
    }
    angles_.push_back(angles_.back() + shorter_way(angle - last_));
    last_ = angle;
    if (direction_ == 0) {
      begin(i);
    } else if (direction_ * (at(i) - at(extreme_)) > 0.0) {
      extreme_ = i;
    } else if (direction_ * (at(extreme_) - at(i)) > kReversal) {
      give_out();
      begin_ = extreme_;
      extreme_ = i;
      direction_ = -direction_;
    }
  }

  /// The next sample is off the circle, or there is none.
  void stop() {
    if (direction_ != 0) {
      give_out();
    }
    angles_.clear();
    direction_ = 0;
  }

 private:
  [[nodiscard]] double at(std::size_t i) const { return angles_[i - first_]; }

  void begin(std::size_t i) {
    low_ = at(i) <= at(low_) ? i : low_;
    high_ = at(i) >= at(high_) ? i : high_;
    if (at(high_) - at(low_) > kReversal) {
      direction_ = low_ < high_ ? 1 : -1;
      begin_ = low_ < high_ ? low_ : high_;
      extreme_ = i;
    }
  }

  void give_out() {
    std::vector<double> way;
    for (std::size_t i = begin_; i <= extreme_; ++i) {
      way.push_back(direction_ * (at(i) - at(begin_)));
    }
    std::size_t begin = begin_;
    for (const std::size_t stop : standstills(samples_.t.subspan(begin_, way.size()), way)) {
      give_out(begin, begin_ + stop);
      begin = begin_ + stop;
    }
    give_out(begin, extreme_);
  }

  void give_out(std::size_t begin, std::size_t end) {
    const double from = at(begin);
    const double to = at(end);
    std::size_t first = begin;
    std::size_t last = end;
    for (std::size_t i = begin; i < end && std::abs(at(i) - from) < kReversal; ++i) {
      first = std::abs(at(i) - from) < kStandstill ? i : first;
    }
    for (std::size_t i = end; i > first && std::abs(at(i) - to) < kReversal; --i) {
      last = std::abs(at(i) - to) < kStandstill ? i : last;
    }
    const double angle = std::abs(at(last) - at(first));
    if (angle >= kLeastTurn) {
      turns_.push_back({first, last + 1, direction_, at(first), angle, 0.0});
    }
  }

  const PlaneSamples& samples_;
  std::vector<CircleTurn>& turns_;
  std::vector<double> angles_;  // unwrapped, of the samples from first_
  double last_ = 0.0;           // as atan2 gave it
  std::size_t first_ = 0;
  std::size_t begin_ = 0;
  std::size_t low_ = 0;
  std::size_t high_ = 0;
  std::size_t extreme_ = 0;
  int direction_ = 0;
};

/// Over the samples [begin, end), rad, positive counter-clockwise.
double angle_passed(const PlaneSamples& samples, const Circle& circle, std::size_t begin,
                    std::size_t end) {
  double angle = 0.0;
  double before = angle_about(circle.centre, samples.at(begin));
  for (std::size_t i = begin + 1; i < end; ++i) {
    const double now = angle_about(circle.centre, samples.at(i));
    angle += shorter_way(now - before);
    before = now;
  }
  return angle;
}

/// Angle by time where the path neither starts nor ends.
double mean_speed(const PlaneSamples& samples, const Circle& circle, const CircleTurn& turn) {
  const std::size_t tenth = (turn.end - turn.begin) / 10;
  const std::size_t first = turn.begin + tenth;
  const std::size_t last = turn.end - 1 - tenth;
  const double time = samples.t[last] - samples.t[first];
  return time > 0.0 ? angle_passed(samples, circle, first, last + 1) / time : 0.0;
}

}  // namespace

std::vector<CircleTurn> circle_turns(const PlaneSamples& samples, const Circle& circle,
                                     double near) {
  std::vector<CircleTurn> turns;
  TurnCutter cutter(samples, turns);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d q = samples.at(i) - circle.centre;
    if (std::abs(q.norm() - circle.radius) <= near * circle.radius) {
      cutter.take(i, std::atan2(q.y(), q.x()));
    } else {
      cutter.stop();
    }
  }
  cutter.stop();
  for (CircleTurn& turn : turns) {
    turn.omega = mean_speed(samples, circle, turn);
  }
  return turns;
}

CircleTurn part_of(const PlaneSamples& samples, const Circle& circle, const CircleTurn& turn,
                   std::size_t begin, std::size_t end) {
  const double from = angle_about(circle.centre, samples.at(begin));
  const double angle = turn.direction * angle_passed(samples, circle, begin, end);
  return {begin, end, turn.direction, from, angle, turn.omega};
}

double angle_of(std::span<const CircleTurn> turns, int direction) {
  double angle = 0.0;
  for (const CircleTurn& turn : turns) {
    angle += turn.direction == direction ? turn.angle : 0.0;
  }
  return angle;
}

bool pass_whole_turn(std::span<const CircleTurn> turns, int direction) {
  constexpr int kDegrees = 360;
  std::bitset<kDegrees> passed;
  for (const CircleTurn& turn : turns) {
    if (turn.direction != direction) {
      continue;
    }
    const double to = turn.from + direction * turn.angle;
    const auto first = static_cast<int>(std::floor(std::min(turn.from, to) / kDegree));
    const auto last = static_cast<int>(std::floor(std::max(turn.from, to) / kDegree));
    for (int i = first; i <= std::min(last, first + kDegrees); ++i) {
      passed.set(static_cast<std::size_t>((i % kDegrees + kDegrees) % kDegrees));
    }
  }
  return passed.count() + 2 >= kDegrees;
}

}  // namespace g31::metrology
