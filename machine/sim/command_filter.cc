#include "machine/sim/command_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::machine {
namespace {

using Quartic = std::array<AxisPositions, 5>;

/// A cubic through the ends of a piece, with their slopes, is beside it by h^4 / 384 times the
/// fourth derivative.
constexpr double kHermite = 384.0;

/// mm or deg: a control puts out whole increments, so with the last half of one a lag has ended.
constexpr double kHalfIncrement = 5e-4;

AxisPositions value_of(const Quartic& q, double t) {
  return q[0] + t * (q[1] + t * (q[2] + t * (q[3] + t * q[4])));
}

AxisPositions slope_of(const Quartic& q, double t) {
  return q[1] + t * (2.0 * q[2] + t * (3.0 * q[3] + t * 4.0 * q[4]));
}

CommandPiece hermite(const AxisPositions& from, const AxisPositions& slope_from,
                     const AxisPositions& to, const AxisPositions& slope_to, double h) {
  const AxisPositions way = to - from;
  return {{from, slope_from, (3.0 * way - h * (2.0 * slope_from + slope_to)) / (h * h),
           (h * (slope_from + slope_to) - 2.0 * way) / (h * h * h)},
          h};
}

void append(const Quartic& q, double duration_s, std::vector<CommandPiece>& out) {
  const double fourth = 24.0 * q[4].cwiseAbs().maxCoeff();
  if (fourth == 0.0) {
    out.push_back({{q[0], q[1], q[2], q[3]}, duration_s});
    return;
  }
  const double longest_s = std::pow(kHermite * kFilterErrorMm / fourth, 0.25);
  const int count = static_cast<int>(std::min(duration_s / longest_s, 1e6)) + 1;
  const double h = duration_s / count;
  for (int i = 0; i < count; ++i) {
    out.push_back(hermite(value_of(q, i * h), slope_of(q, i * h), value_of(q, (i + 1) * h),
                          slope_of(q, (i + 1) * h), h));
  }
}

/// The same cubic from a later time on.
std::array<double, 4> from_time(const CommandPiece& piece, Eigen::Index axis, double t) {
  const double a = piece.command[0][axis];
  const double b = piece.command[1][axis];
  const double c = piece.command[2][axis];
  const double d = piece.command[3][axis];
  return {a + t * (b + t * (c + t * d)), b + t * (2.0 * c + t * 3.0 * d), c + 3.0 * t * d, d};
}

/// Where the past began, the command had been standing.
std::array<double, 4> cubic_at(const std::deque<CommandPiece>& past, Eigen::Index axis,
                               double before_end_s) {
  double end_s = 0.0;  // of a piece, before the end of all
  for (auto piece = past.rbegin(); piece != past.rend(); ++piece) {
    if (before_end_s <= end_s + piece->duration_s) {
      return from_time(*piece, axis, std::max(0.0, end_s + piece->duration_s - before_end_s));
    }
    end_s += piece->duration_s;
  }
  return {past.front().command[0][axis], 0.0, 0.0, 0.0};
}

}  // namespace

void FilterStage::take(const CommandPiece& in, std::vector<CommandPiece>& out) {
  if (!has_begun_) {
    out_ = in.command[0];
    has_begun_ = true;
  }
  if (shape_ == Shape::Mean) {
    take_mean(in, out);
  } else {
    take_lag(in, out);
  }
}

std::vector<double> FilterStage::boundaries(double duration_s) const {
  std::vector<double> marks = {0.0};
  double end_s = 0.0;
  for (auto piece = past_.rbegin(); piece != past_.rend(); ++piece) {
    // A boundary so long before the end of the past comes by after the time constant less that.
    end_s += piece == past_.rbegin() ? 0.0 : (piece - 1)->duration_s;
    for (const double time_s : time_s_) {
      marks.push_back(time_s - end_s);
    }
  }
  if (!past_.empty()) {
    for (const double time_s : time_s_) {
      marks.push_back(time_s - end_s - past_.front().duration_s);
    }
  }
  for (const double time_s : time_s_) {
    marks.push_back(time_s);
  }
  constexpr double kSameTime = 1e-12;
  std::erase_if(marks, [&](double mark) {
    return mark < 0.0 || (mark > 0.0 && mark > duration_s - kSameTime);
  });
  std::ranges::sort(marks);
  marks.erase(
      std::unique(marks.begin(), marks.end(), [](double a, double b) { return b - a < kSameTime; }),
      marks.end());
  marks.push_back(duration_s);
  return marks;
}

void FilterStage::take_mean(const CommandPiece& in, std::vector<CommandPiece>& out) {
  const std::vector<double> marks = boundaries(in.duration_s);
  remember(in);
  for (std::size_t n = 1; n < marks.size(); ++n) {
    const double from_s = marks[n - 1];
    const double h = marks[n] - from_s;
    Quartic mean = {out_, AxisPositions::Zero(), AxisPositions::Zero(), AxisPositions::Zero(),
                    AxisPositions::Zero()};
    for (Eigen::Index axis = 0; axis < out_.size(); ++axis) {
      const std::array<double, 4> now = from_time(in, axis, from_s);
      const double time_s = time_s_[axis];
      if (time_s == 0.0) {
        for (std::size_t k = 0; k < now.size(); ++k) {
          mean[k][axis] = now[k];
        }
        continue;
      }
      // The middle of the piece tells on which side of a boundary its beginning is.
      const double middle_s = in.duration_s - from_s - 0.5 * h + time_s;
      std::array<double, 4> then = cubic_at(past_, axis, middle_s);
      const CommandPiece shifted = {
          {AxisPositions::Constant(then[0]), AxisPositions::Constant(then[1]),
           AxisPositions::Constant(then[2]), AxisPositions::Constant(then[3])},
          h};
      then = from_time(shifted, axis, -0.5 * h);
      for (std::size_t k = 0; k < now.size(); ++k) {
        mean[k + 1][axis] = (now[k] - then[k]) / (static_cast<double>(k + 1) * time_s);
      }
    }
    append(mean, h, out);
    out_ = value_of(mean, h);
  }
}

void FilterStage::remember(const CommandPiece& in) {
  past_.push_back(in);
  double kept_s = 0.0;
  auto piece = past_.rbegin();
  // What goes in is not yet past: as much as the longest mean remains before it.
  for (++piece; piece != past_.rend() && kept_s < time_s_.maxCoeff(); ++piece) {
    kept_s += piece->duration_s;
  }
  past_.erase(past_.begin(), piece.base());
}

void FilterStage::take_lag(const CommandPiece& in, std::vector<CommandPiece>& out) {
  // T y' + y = c has the solution c - T c' + T^2 c'' - T^3 c''', and what dies away.
  std::array<AxisPositions, 4> y;
  y[3] = in.command[3];
  y[2] = in.command[2] - 3.0 * time_s_.cwiseProduct(y[3]);
  y[1] = in.command[1] - 2.0 * time_s_.cwiseProduct(y[2]);
  y[0] = in.command[0] - time_s_.cwiseProduct(y[1]);
  const CommandPiece steady{y, in.duration_s};
  const AxisPositions dying = (in.command[0] - behind_) - y[0];
  const auto decayed = [&](double t, bool is_slope) {
    AxisPositions rest = AxisPositions::Zero();
    for (Eigen::Index axis = 0; axis < rest.size(); ++axis) {
      const double time_s = time_s_[axis];
      if (time_s > 0.0) {
        rest[axis] = dying[axis] * std::exp(-t / time_s) * (is_slope ? -1.0 / time_s : 1.0);
      }
    }
    return rest;
  };
  const auto value = [&](double t) -> AxisPositions { return steady.at(t) + decayed(t, false); };
  const auto slope = [&](double t) -> AxisPositions {
    return y[1] + t * (2.0 * y[2] + t * 3.0 * y[3]) + decayed(t, true);
  };
  double from_s = 0.0;
  while (from_s < in.duration_s) {
    double fourth = 0.0;
    for (Eigen::Index axis = 0; axis < dying.size(); ++axis) {
      if (time_s_[axis] > 0.0) {
        fourth = std::max(fourth, std::abs(dying[axis]) * std::exp(-from_s / time_s_[axis]) /
                                      std::pow(time_s_[axis], 4.0));
      }
    }
    const double step_s =
        fourth > 0.0 ? std::pow(kHermite * kFilterErrorMm / fourth, 0.25) : in.duration_s;
    // What is left is not cut so that next to nothing remains.
    const double left_s = in.duration_s - from_s;
    const double to_s = left_s <= 1.01 * step_s ? in.duration_s : from_s + step_s;
    out.push_back(hermite(value(from_s), slope(from_s), value(to_s), slope(to_s), to_s - from_s));
    from_s = to_s;
  }
  behind_ = in.at(in.duration_s) - value(in.duration_s);
}

double FilterStage::rest_s() const {
  if (!has_begun_) {
    return 0.0;
  }
  if (shape_ == Shape::Mean) {
    return time_s_.maxCoeff();
  }
  double longest_s = 0.0;
  for (Eigen::Index axis = 0; axis < behind_.size(); ++axis) {
    const double left = std::abs(behind_[axis]);
    if (left > kHalfIncrement) {
      longest_s = std::max(longest_s, time_s_[axis] * std::log(left / kHalfIncrement));
    }
  }
  return longest_s;
}

CommandFilter::CommandFilter(FeedFilter shape, const AxisPositions& time_s) {
  if (shape == FeedFilter::None || time_s.isZero(0.0)) {
    return;
  }
  if (shape == FeedFilter::Bell) {
    const AxisPositions each_s = time_s / std::numbers::sqrt2;
    stages_.assign(2, FilterStage(FilterStage::Shape::Mean, each_s));
    return;
  }
  stages_.emplace_back(
      shape == FeedFilter::Linear ? FilterStage::Shape::Mean : FilterStage::Shape::Lag, time_s);
}

void CommandFilter::take(const CommandPiece& in, std::vector<CommandPiece>& out) {
  std::vector<CommandPiece> pieces = {in};
  for (FilterStage& stage : stages_) {
    std::vector<CommandPiece> smoothed;
    for (const CommandPiece& piece : pieces) {
      stage.take(piece, smoothed);
    }
    pieces = std::move(smoothed);
  }
  out.insert(out.end(), pieces.begin(), pieces.end());
}

double CommandFilter::rest_s() const {
  double seconds = 0.0;
  for (const FilterStage& stage : stages_) {
    seconds += stage.rest_s();
  }
  return seconds;
}

}  // namespace g31::machine
