#include "probe/metrology/circle_turns.h"

#include <cmath>
#include <numbers>

namespace g31::metrology {
namespace {

constexpr double kNearTheCircle = 0.02;
/// So far back is a reversal; less is noise.
constexpr double kReversal = 2.0 * kDegree;
constexpr double kLeastTurn = 10.0 * kDegree;
/// So far along the circle an end of a piece may be standstill or a way along the radius.
constexpr double kStandstill = 0.001;

/// Takes the samples on the circle one by one and cuts them where their angle turns back.
class TurnCutter {
 public:
  explicit TurnCutter(std::vector<CircleTurn>& turns) : turns_(turns) {}

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
    const double from = at(begin_);
    const double to = at(extreme_);
    std::size_t first = begin_;
    std::size_t last = extreme_;
    for (std::size_t i = begin_; i < extreme_ && std::abs(at(i) - from) < kReversal; ++i) {
      first = std::abs(at(i) - from) < kStandstill ? i : first;
    }
    for (std::size_t i = extreme_; i > first && std::abs(at(i) - to) < kReversal; --i) {
      last = std::abs(at(i) - to) < kStandstill ? i : last;
    }
    const double angle = std::abs(at(last) - at(first));
    if (angle >= kLeastTurn) {
      turns_.push_back({first, last + 1, direction_, at(first), angle, 0.0});
    }
  }

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

/// Angle by time where the path neither starts nor ends.
double mean_speed(const PlaneSamples& samples, const Circle& circle, const CircleTurn& turn) {
  const auto angle_at = [&](std::size_t i) {
    const Eigen::Vector2d q = samples.at(i) - circle.centre;
    return std::atan2(q.y(), q.x());
  };
  const std::size_t tenth = (turn.end - turn.begin) / 10;
  const std::size_t first = turn.begin + tenth;
  const std::size_t last = turn.end - 1 - tenth;
  double angle = 0.0;
  double before = angle_at(first);
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double now = angle_at(i);
    angle += shorter_way(now - before);
    before = now;
  }
  const double time = samples.t[last] - samples.t[first];
  return time > 0.0 ? angle / time : 0.0;
}

}  // namespace

std::vector<CircleTurn> circle_turns(const PlaneSamples& samples, const Circle& circle) {
  std::vector<CircleTurn> turns;
  TurnCutter cutter(turns);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d q = samples.at(i) - circle.centre;
    if (std::abs(q.norm() - circle.radius) <= kNearTheCircle * circle.radius) {
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

}  // namespace g31::metrology
