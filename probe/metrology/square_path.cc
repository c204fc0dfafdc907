#include "probe/metrology/square_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace g31::metrology {
namespace {

/// A way along one axis goes so little along the other.
constexpr double kStraight = 0.1;
/// So near the nominal side a sample belongs to it, in half sides.
constexpr double kBesideSide = 0.2;
/// So near the diagonal a path that ends there is taken to be on it.
constexpr double kOnDiagonal = 0.002;

constexpr std::array<std::array<double, 2>, 4> kCorners = {
    {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}};

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Points evenly spread along the way.
/// @param numbers  of their samples
std::vector<Eigen::Vector2d> spread_points(const PlaneSamples& samples, double step,
                                           std::vector<std::size_t>& numbers) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples.look();
    const Eigen::Vector2d p = samples.at(i);
    if (points.empty() || (p - points.back()).squaredNorm() >= step * step) {
      points.push_back(p);
      numbers.push_back(i);
    }
  }
  return points;
}

/// The ways to the square and away from it lead across its sides.
SampleRange range_on(const PlaneSamples& samples, const std::vector<Eigen::Vector2d>& points,
                     const std::vector<std::size_t>& numbers, const Square& square) {
  const auto runs_along = [&](std::size_t i) {
    const Eigen::Vector2d q = points[i] - square.centre;
    const Eigen::Vector2d step = (points[i + 1] - points[i]).cwiseAbs();
    const Eigen::Index across = std::abs(q.x()) > std::abs(q.y()) ? 0 : 1;
    const bool is_beside =
        std::abs(std::abs(q[across]) - square.half_side) <= kBesideSide * square.half_side;
    return is_beside && step[across] < step[1 - across];
  };
  std::size_t first = 0;
  std::size_t last = points.size() - 1;
  while (first < last && !runs_along(first)) {
    ++first;
  }
  while (last > first && !runs_along(last - 1)) {
    --last;
  }
  if (first >= last) {
    return {numbers.front(), numbers.back() + 1};
  }
  // Between two points the way turns into the side, or out of it: where it is nearest to the
  // square.
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
  return {nearest(numbers[first], numbers[first + 1]),
          nearest(numbers[last - 1], numbers[last]) + 1};
}

/// Where two sides that face each other are.
struct SidePair {
  double low = 0.0;
  double high = 0.0;
};

/// The two sides across an axis: the places on that axis where the path goes along the other.
std::optional<SidePair> sides_across(const std::vector<Eigen::Vector2d>& points, int axis) {
  std::vector<double> places;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Eigen::Vector2d step = points[i] - points[i - 1];
    if (std::abs(step[axis]) <= kStraight * std::abs(step[1 - axis])) {
      places.push_back(points[i][axis]);
    }
  }
  if (places.size() < 20) {
    return std::nullopt;
  }
  std::ranges::sort(places);
  const double middle = 0.5 * (places[places.size() / 10] + places[places.size() * 9 / 10]);
  const auto cut = std::ranges::lower_bound(places, middle);
  if (cut - places.begin() < 8 || places.end() - cut < 8) {
    return std::nullopt;
  }
  return SidePair{median_of({places.begin(), cut}), median_of({cut, places.end()})};
}

/// The mean places of the middle halves of the sides across an axis.
SidePair refined_sides(const std::vector<Eigen::Vector2d>& points, const Square& square, int axis) {
  const double a = square.half_side;
  std::array<double, 2> sum = {};
  std::array<double, 2> count = {};
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d q = p - square.centre;
    const bool is_beside = std::abs(std::abs(q[axis]) - a) <= kBesideSide * a;
    if (is_beside && std::abs(q[1 - axis]) <= 0.5 * a) {
      const std::size_t side = q[axis] > 0.0 ? 1 : 0;
      sum.at(side) += p[axis];
      count.at(side) += 1.0;
    }
  }
  const auto mean = [&](std::size_t side, double otherwise) {
    return count.at(side) > 0.0 ? sum.at(side) / count.at(side) : otherwise;
  };
  return {mean(0, square.centre[axis] - a), mean(1, square.centre[axis] + a)};
}

Square square_of(const SidePair& x, const SidePair& y, const SquareRequest& request) {
  Square square;
  square.centre =
      request.centre.value_or(Eigen::Vector2d(0.5 * (x.low + x.high), 0.5 * (y.low + y.high)));
  square.half_side = 0.5 * request.side.value_or(0.5 * (x.high - x.low + y.high - y.low));
  return square;
}

/// Whether most of the way runs along the square: of a circle less than half does.
bool follows(const std::vector<Eigen::Vector2d>& points, const Square& square) {
  const auto is_near = [&](const Eigen::Vector2d& p) {
    const double widest = (p - square.centre).cwiseAbs().maxCoeff();
    return std::abs(widest - square.half_side) <= 0.05 * square.half_side;
  };
  const auto near = static_cast<double>(std::ranges::count_if(points, is_near));
  return near >= 0.6 * static_cast<double>(points.size());
}

/// The path at one corner, seen along its diagonal.
class CornerView {
 public:
  CornerView(const PlaneSamples& samples, const Square& square, std::size_t corner)
      : samples_(samples), square_(square), sign_(kCorners.at(corner)[0], kCorners.at(corner)[1]) {}

  [[nodiscard]] std::optional<double> error() const {
    std::optional<double> largest;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Eigen::Vector2d q = at(i);
      if (q.minCoeff() < 0.5 * square_.half_side) {
        continue;
      }
      if (std::abs(side_of(q)) <= kOnDiagonal * square_.half_side &&
          (!nearest || distance(q) < distance(at(*nearest)))) {
        nearest = i;
      }
      if (i + 1 < samples_.size() && crosses(q, at(i + 1))) {
        const double error = crossing(i);
        largest = !largest || std::abs(error) > std::abs(*largest) ? error : *largest;
      }
    }
    if (!largest && nearest) {
      largest = square_.ray_error(samples_.at(*nearest));
    }
    return largest;
  }

 private:
  [[nodiscard]] Eigen::Vector2d at(std::size_t i) const {
    return (samples_.at(i) - square_.centre).cwiseProduct(sign_);
  }
  static double side_of(const Eigen::Vector2d& q) { return q.x() - q.y(); }
  [[nodiscard]] double distance(const Eigen::Vector2d& q) const {
    return (q - Eigen::Vector2d::Constant(square_.half_side)).norm();
  }

  /// Across the diagonal rather than along it.
  static bool crosses(const Eigen::Vector2d& q, const Eigen::Vector2d& next) {
    const Eigen::Vector2d step = next - q;
    const bool changes_side = (side_of(q) < 0.0) != (side_of(next) < 0.0);
    return changes_side && std::abs(side_of(step)) >= 0.5 * std::abs(step.sum());
  }

  /// How far beyond the corner the line through two points meets the diagonal.
  [[nodiscard]] double beyond(const Eigen::Vector2d& p, const Eigen::Vector2d& q) const {
    const double share = side_of(p) / (side_of(p) - side_of(q));
    const Eigen::Vector2d meets = p + share * (q - p);
    return std::numbers::sqrt2 * (0.5 * meets.sum() - square_.half_side);
  }

  static double turning(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
  }

  /// The diagonal lies between samples i and i + 1.
  [[nodiscard]] double crossing(std::size_t i) const {
    const double chord = beyond(at(i), at(i + 1));
    if (i < 2 || i + 3 >= samples_.size()) {
      return chord;
    }
    const Eigen::Vector2d before = at(i) - at(i - 1);
    const Eigen::Vector2d behind = at(i + 2) - at(i + 1);
    const double around =
        turning(at(i - 1) - at(i - 2), before) + turning(behind, at(i + 3) - at(i + 2));
    const bool leads_there =
        side_of(before) * side_of(at(i)) < 0.0 && side_of(behind) * side_of(at(i + 1)) > 0.0;
    const bool is_sharp = leads_there && turning(before, behind) > 0.2 + 3.0 * around;
    return is_sharp ? 0.5 * (beyond(at(i - 1), at(i)) + beyond(at(i + 1), at(i + 2))) : chord;
  }

  const PlaneSamples& samples_;
  const Square& square_;
  Eigen::Vector2d sign_;
};

}  // namespace

double Square::ray_error(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - centre;
  const double widest = q.cwiseAbs().maxCoeff();
  return widest > 0.0 ? q.norm() * (1.0 - half_side / widest) : -half_side;
}

double Square::place_of(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - centre;
  const double a = half_side;
  const double widest = q.cwiseAbs().maxCoeff();
  if (widest == 0.0) {
    return 0.0;
  }
  const Eigen::Vector2d on = q * (a / widest);
  if (q.x() == widest) {
    return on.y() >= 0.0 ? on.y() : 8.0 * a + on.y();
  }
  if (q.y() == widest) {
    return 2.0 * a - on.x();
  }
  return q.x() == -widest ? 4.0 * a - on.y() : 6.0 * a + on.x();
}

Result<SquareEvaluation, std::string> evaluate_square(const PlaneSamples& samples,
                                                      const SquareRequest& request) {
  const auto [x_low, x_high] = std::ranges::minmax_element(samples.x);
  const auto [y_low, y_high] = std::ranges::minmax_element(samples.y);
  const double extent = std::hypot(*x_high - *x_low, *y_high - *y_low);
  if (!(extent > 0.0)) {
    return std::string("the path does not move");
  }
  std::vector<std::size_t> numbers;
  const auto points = spread_points(samples, extent / 1000.0, numbers);
  const auto across_x = sides_across(points, 0);
  const auto across_y = sides_across(points, 1);
  if (!across_x || !across_y) {
    return std::string("the path is not a square along the axes");
  }
  Square square = square_of(*across_x, *across_y, request);
  if (!follows(points, square)) {
    return std::string("most of the path does not lie on a square of this side along the axes");
  }
  square = square_of(refined_sides(points, square, 0), refined_sides(points, square, 1), request);
  SquareEvaluation evaluation{square, range_on(samples, points, numbers, square), {}};
  for (std::size_t corner = 0; corner < kCorners.size(); ++corner) {
    evaluation.corner_error.at(corner) = CornerView(samples, square, corner).error();
  }
  return evaluation;
}

}  // namespace g31::metrology
