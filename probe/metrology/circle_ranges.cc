#include "probe/metrology/circle_ranges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::metrology {
namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;
/// Servo loops have settled so long behind the start, and stop so long before the end, s.
constexpr double kSettling = 0.3;
constexpr double kStopping = 0.1;
constexpr double kLeastEnd = 10.0 * kDegree;
constexpr double kLongestEnd = 60.0 * kDegree;
/// Of a turn, at either end: more would leave too little of it.
constexpr double kMostOfTurn = 1.0 / 3.0;
constexpr double kBefore = 2.0 * kDegree;
constexpr double kLeastWindow = 10.0 * kDegree;
constexpr double kWidestWindow = 40.0 * kDegree;
/// Of the axis' way behind a reversal: friction has settled by then.
constexpr double kSettlingWay = 0.5;
/// Residuals are looked at in bins of this width.
constexpr double kBin = 2.0 * kDegree;
constexpr std::size_t kBins = 45;
constexpr double kSignificant = 4.0;

/// The angle behind a reversal at which the axis has gone so far.
double angle_of_way(double way, double radius) {
  return std::acos(std::clamp(1.0 - way / radius, -1.0, 1.0));
}

/// Calls `act(i, place)` for each sample of a turn.
template <typename Act>
void along(const PlaneSamples& samples, const CircleTurn& turn, const Eigen::Vector2d& centre,
           Act act) {
  double way = 0.0;
  double before = turn.from;
  for (std::size_t i = turn.begin; i < turn.end; ++i) {
    samples.look();
    const double angle = angle_about(centre, samples.at(i));
    way += shorter_way(turn.direction * (angle - before));
    before = angle;
    act(i, place_on_turn(turn, way, angle));
  }
}

/// Sums of residuals by the angle since a reversal of one axis.
struct Bin {
  double sum = 0.0;
  double square = 0.0;
  double count = 0.0;
};
using Bins = std::array<Bin, kBins>;

/// What scatter the residuals have far from reversals.
double scatter_of(const std::array<Bins, 2>& bins) {
  Bin all;
  for (const Bins& of_axis : bins) {
    for (std::size_t k = 20; k < 44; ++k) {
      all.square += of_axis.at(k).square;
      all.count += of_axis.at(k).count;
    }
  }
  return all.count > 0.0 ? std::sqrt(all.square / all.count) : 0.0;
}

double widened(double window, const Bins& bins, double scatter) {
  for (auto k = static_cast<std::size_t>(window / kBin); k < kBins; ++k) {
    const Bin& bin = bins.at(k);
    const double limit = kSignificant * scatter * std::sqrt(bin.count);
    if (bin.count == 0.0 || std::abs(bin.sum) <= limit) {
      return window;
    }
    window = static_cast<double>(k + 1) * kBin;
    if (window >= kWidestWindow) {
      return kWidestWindow;
    }
  }
  return window;
}

}  // namespace

PlaceOnTurn place_on_turn(const CircleTurn& turn, double way, double angle) {
  PlaceOnTurn place;
  const auto margin = [&](double time) {
    return std::min(std::clamp(std::abs(turn.omega) * time, kLeastEnd, kLongestEnd),
                    kMostOfTurn * turn.angle);
  };
  place.is_near_end = way < margin(kSettling) || way > turn.angle - margin(kStopping);
  const double quarters = turn.direction * angle / kQuarter;
  const double last = std::floor(quarters);
  place.since = (quarters - last) * kQuarter;
  place.axis = static_cast<int>(std::abs(last)) % 2;  // X turns at 0 and 180 degrees
  place.is_before = kQuarter - place.since < kBefore;
  return place;
}

bool is_described(const PlaceOnTurn& place, const ReversalWindows& windows) {
  return !place.is_before && place.since >= windows.at(static_cast<std::size_t>(place.axis));
}

std::vector<FittedRange> described_ranges(const PlaneSamples& samples,
                                          const std::vector<CircleTurn>& turns,
                                          const Eigen::Vector2d& centre,
                                          const ReversalWindows& windows, Ends ends) {
  std::vector<FittedRange> ranges;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    bool is_open = false;
    along(samples, turns[k], centre, [&](std::size_t i, const PlaceOnTurn& place) {
      const bool is_in =
          (ends == Ends::Fitted || !place.is_near_end) && is_described(place, windows);
      if (is_in && !is_open) {
        ranges.push_back({k, i, i});
      }
      if (is_in) {
        ranges.back().end = i + 1;
      }
      is_open = is_in;
    });
  }
  return ranges;
}

ReversalWindows first_windows(double radius) {
  const double window = std::clamp(angle_of_way(kSettlingWay, radius), kLeastWindow, kWidestWindow);
  return {window, window};
}

ReversalWindows reversal_windows(const PlaneSamples& samples, const std::vector<CircleTurn>& turns,
                                 const CircleFit& fit) {
  std::array<Bins, 2> bins = {};
  for (const CircleTurn& turn : turns) {
    const CircleResidual residual(fit.errors, turn);
    along(samples, turn, fit.errors.centre, [&](std::size_t i, const PlaceOnTurn& place) {
      if (place.is_near_end || place.is_before) {
        return;
      }
      const auto k = std::min(static_cast<std::size_t>(place.since / kBin), kBins - 1);
      Bin& bin = bins.at(static_cast<std::size_t>(place.axis)).at(k);
      const double off = residual.at(samples.at(i));
      bin.sum += off;
      bin.square += off * off;
      bin.count += 1.0;
    });
  }
  const double scatter = scatter_of(bins);
  ReversalWindows windows = first_windows(fit.errors.radius);
  for (std::size_t axis : {0U, 1U}) {
    const double play = angle_of_way(std::abs(fit.errors.backlash.at(axis)), fit.errors.radius);
    const double window = std::min(windows.at(axis) + play, kWidestWindow);
    windows.at(axis) = widened(window, bins.at(axis), scatter);
  }
  return windows;
}

std::array<std::optional<double>, 2> reversal_spikes(const PlaneSamples& samples,
                                                     const std::vector<CircleTurn>& turns,
                                                     const CircleFit& fit,
                                                     const ReversalWindows& windows) {
  std::array<std::optional<double>, 2> spikes;
  for (const CircleTurn& turn : turns) {
    const CircleResidual residual(fit.errors, turn);
    along(samples, turn, fit.errors.centre, [&](std::size_t i, const PlaceOnTurn& place) {
      const auto axis = static_cast<std::size_t>(place.axis);
      if (!place.is_near_end && place.since < windows.at(axis)) {
        spikes.at(axis) = std::max(spikes.at(axis).value_or(0.0), residual.at(samples.at(i)));
      }
    });
  }
  return spikes;
}

}  // namespace g31::metrology
