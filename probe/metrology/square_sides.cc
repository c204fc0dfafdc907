#include "probe/metrology/square_sides.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace g31::metrology {
namespace {

/// A way along one axis goes so little along the other.
constexpr double kStraight = 0.1;
/// And so little one that turns into it.
constexpr double kRather = 1.0;
/// So near a side, in half sides, a point is of it.
constexpr double kBesideSide = 0.05;

/// Where two sides that face each other are.
struct SidePair {
  double low = 0.0;
  double high = 0.0;
};

/// Points whose ways along an axis are about at one place across it.
struct StraightWay {
  double place = 0.0;  ///< their median
  std::size_t points = 0;
};

/// Where the path goes along the other axis: the few places with the most points.
std::vector<StraightWay> ways_across(const SpreadPoints& points, double extent, int axis) {
  constexpr double kApart = 0.01;  // of the extent
  constexpr std::size_t kLeastPoints = 8;
  constexpr std::size_t kMostWays = 6;
  std::vector<double> places;
  for (std::size_t i = 1; i < points.at.size(); ++i) {
    const Eigen::Vector2d step = points.at[i] - points.at[i - 1];
    if (std::abs(step[axis]) <= kStraight * std::abs(step[1 - axis])) {
      places.push_back(points.at[i][axis]);
    }
  }
  std::ranges::sort(places);
  std::vector<StraightWay> ways;
  for (std::size_t begin = 0, end = 1; begin < places.size(); begin = end++) {
    while (end < places.size() && places[end] - places[end - 1] <= kApart * extent) {
      ++end;
    }
    if (end - begin >= kLeastPoints) {
      ways.push_back({places[begin + (end - begin) / 2], end - begin});
    }
  }
  std::ranges::stable_sort(ways, std::ranges::greater(), &StraightWay::points);
  ways.resize(std::min(ways.size(), kMostWays));
  return ways;
}

std::vector<SidePair> pairs_of(const std::vector<StraightWay>& ways) {
  std::vector<SidePair> pairs;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (std::size_t k = i + 1; k < ways.size(); ++k) {
      const auto [low, high] = std::minmax(ways[i].place, ways[k].place);
      pairs.push_back({low, high});
    }
  }
  return pairs;
}

Square square_of(const SidePair& x, const SidePair& y, const SquareRequest& request) {
  Square square;
  square.centre =
      request.centre.value_or(Eigen::Vector2d(0.5 * (x.low + x.high), 0.5 * (y.low + y.high)));
  square.half_side = 0.5 * request.side.value_or(0.5 * (x.high - x.low + y.high - y.low));
  return square;
}

/// How many of these points lie on a square.
std::size_t count_on(const SpreadPoints& points, const SampleRange& range, const Square& square) {
  std::size_t count = 0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const double widest = (points.at[i] - square.centre).cwiseAbs().maxCoeff();
    count += std::abs(widest - square.half_side) <= kBesideSide * square.half_side ? 1U : 0U;
  }
  return count;
}

/// Whether the way from a point to the next runs along the side that it is beside.
bool runs_along(const SpreadPoints& points, std::size_t i, const Square& square, double slope) {
  const Eigen::Vector2d q = points.at[i] - square.centre;
  const Eigen::Vector2d step = (points.at[i + 1] - points.at[i]).cwiseAbs();
  const Eigen::Index across = std::abs(q.x()) > std::abs(q.y()) ? 0 : 1;
  const bool is_beside =
      std::abs(std::abs(q[across]) - square.half_side) <= kBesideSide * square.half_side;
  return is_beside && step[across] < slope * step[1 - across];
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The mean of the places about their median: a way that comes to the side at a small angle does
/// not count.
double mean_about_median(const std::vector<double>& places, double half_side) {
  constexpr double kScattered = 5.0;  // of the median of the distances from the median
  constexpr double kAsGood = 1e-5;    // of half a side
  const double median = median_of(places);
  std::vector<double> distances;
  distances.reserve(places.size());
  for (const double place : places) {
    distances.push_back(std::abs(place - median));
  }
  const double most = std::max(kScattered * median_of(distances), kAsGood * half_side);
  double sum = 0.0;
  double count = 0.0;
  for (const double place : places) {
    if (std::abs(place - median) <= most) {
      sum += place;
      count += 1.0;
    }
  }
  return sum / count;
}

/// The mean places of the middle halves of the sides across an axis.
SidePair refined_sides(const SpreadPoints& points, const SampleRange& along, const Square& square,
                       int axis) {
  const double a = square.half_side;
  std::array<std::vector<double>, 2> places;
  for (std::size_t i = along.begin; i < along.end; ++i) {
    const Eigen::Vector2d q = points.at[i] - square.centre;
    const Eigen::Vector2d step =
        points.at[std::min(i + 1, points.at.size() - 1)] - points.at[i > 0 ? i - 1 : 0];
    const bool is_beside = std::abs(std::abs(q[axis]) - a) <= kBesideSide * a &&
                           std::abs(step[axis]) <= kStraight * std::abs(step[1 - axis]);
    if (is_beside && std::abs(q[1 - axis]) <= 0.5 * a) {
      places.at(q[axis] > 0.0 ? 1 : 0).push_back(points.at[i][axis]);
    }
  }
  return {places[0].empty() ? square.centre[axis] - a : mean_about_median(places[0], a),
          places[1].empty() ? square.centre[axis] + a : mean_about_median(places[1], a)};
}

}  // namespace

SpreadPoints spread_points(const PlaneSamples& samples, double step) {
  SpreadPoints points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples.look();
    const Eigen::Vector2d p = samples.at(i);
    if (points.at.empty() || (p - points.at.back()).squaredNorm() >= step * step) {
      points.at.push_back(p);
      points.samples.push_back(i);
    }
  }
  return points;
}

std::optional<Square> nearest_square(const SpreadPoints& points, double extent,
                                     const SquareRequest& request) {
  const std::vector<SidePair> across_y = pairs_of(ways_across(points, extent, 1));
  std::optional<Square> nearest;
  std::size_t most = 0;
  for (const SidePair& x : pairs_of(ways_across(points, extent, 0))) {
    for (const SidePair& y : across_y) {
      const Square square = square_of(x, y, request);
      const std::size_t count = count_on(points, {0, points.at.size()}, square);
      if (!nearest || count > most) {
        nearest = square;
        most = count;
      }
    }
  }
  return nearest;
}

SampleRange points_along(const SpreadPoints& points, const Square& square) {
  std::size_t first = 0;
  std::size_t last = points.at.size() - 1;
  while (first < last && !runs_along(points, first, square, kStraight)) {
    ++first;
  }
  while (last > first && !runs_along(points, last - 1, square, kStraight)) {
    --last;
  }
  return first < last ? SampleRange{first, last + 1} : SampleRange{0, points.at.size()};
}

SampleRange samples_from_turn_to_turn(const PlaneSamples& samples, const SpreadPoints& points,
                                      const SampleRange& along) {
  // The sample furthest from the straight line between two points.
  const auto turn = [&](std::size_t from, std::size_t to) {
    const Eigen::Vector2d chord = samples.at(to) - samples.at(from);
    double most = -1.0;
    std::size_t furthest = from;
    for (std::size_t i = from; i <= to; ++i) {
      const Eigen::Vector2d off = samples.at(i) - samples.at(from);
      const double distance = std::abs(chord.x() * off.y() - chord.y() * off.x());
      furthest = distance > most ? i : furthest;
      most = std::max(most, distance);
    }
    return furthest;
  };
  const std::size_t first = along.begin;
  const std::size_t last = along.end - 1;
  const bool begins_there = first == 0;
  const bool ends_there = last + 1 == points.at.size();
  return {
      begins_there ? 0 : turn(points.samples[first - 1], points.samples[first + 1]),
      ends_there ? samples.size() : turn(points.samples[last - 1], points.samples[last + 1]) + 1};
}

SampleRange samples_on(const PlaneSamples& samples, const SpreadPoints& points,
                       const SampleRange& along, const Square& square) {
  const auto nearest = [&](std::size_t from, std::size_t to) {
    std::size_t best = from;
    for (std::size_t i = from; i <= to; ++i) {
      if (std::abs(square.ray_error(samples.at(i))) <
          std::abs(square.ray_error(samples.at(best)))) {
        best = i;
      }
    }
    return best;
  };
  std::size_t first = along.begin;
  std::size_t last = along.end - 1;
  if (first > 0 && runs_along(points, first - 1, square, kRather)) {
    --first;
  }
  if (last + 1 < points.at.size() && runs_along(points, last, square, kRather)) {
    ++last;
  }
  return {nearest(points.samples[first], points.samples[first + 1]),
          nearest(points.samples[last - 1], points.samples[last]) + 1};
}

bool follows(const SpreadPoints& points, const SampleRange& along, const Square& square) {
  const auto on = static_cast<double>(count_on(points, along, square));
  return on >= 0.6 * static_cast<double>(along.end - along.begin);
}

Square refined_square(const SpreadPoints& points, const SampleRange& along, const Square& square,
                      const SquareRequest& request) {
  return square_of(refined_sides(points, along, square, 0), refined_sides(points, along, square, 1),
                   request);
}

}  // namespace g31::metrology
