#include "tools/plan/touch_order.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

namespace g31::plan {
namespace {

using Place = Eigen::Vector2d;
using Order = std::vector<std::size_t>;

/// Not all orders of more points than these are tried.
constexpr std::size_t kMostPermuted = 7;

class WayFinder {
 public:
  explicit WayFinder(const probe::InspectionPlan& plan) : plan_(plan) {
    points_of_.resize(plan.features.size());
    std::vector<bool> is_taken(plan.points.size(), false);
    for (const probe::PlannedMeasure& measure : plan.measures) {
      for (const std::size_t point : {measure.first, measure.second}) {
        if (!is_taken[point]) {
          is_taken[point] = true;
          points_of_[measure.feature].push_back(point);
        }
      }
    }
    for (std::size_t i = 0; i < points_of_.size(); ++i) {
      if (!points_of_[i].empty()) {
        features_.push_back(i);
      }
    }
  }

  Order order() {
    visit_nearest();
    improve();
    Order all;
    for (std::size_t i = 0; i < features_.size(); ++i) {
      const bool is_last = i + 1 == features_.size();
      const Place next = is_last ? middle_of(features_[i]) : middle_of(features_[i + 1]);
      const Place from = all.empty() ? start_of_way() : place_of(all.back());
      for (const std::size_t point :
           gathered(shortest(points_of_[features_[i]], from, next), features_[i])) {
        all.push_back(point);
      }
    }
    return all;
  }

 private:
  [[nodiscard]] Place place_of(std::size_t point) const {
    return plan_.points[point].start_P.head<2>();
  }

  [[nodiscard]] Place middle_of(std::size_t feature) const {
    Place sum = Place::Zero();
    for (const std::size_t point : points_of_[feature]) {
      sum += place_of(point);
    }
    return sum / static_cast<double>(points_of_[feature].size());
  }

  /// Beside the first feature: where the probe comes from is not known.
  [[nodiscard]] Place start_of_way() const { return middle_of(features_.front()); }

  void visit_nearest() {
    for (std::size_t i = 1; i + 1 < features_.size(); ++i) {
      const Place here = middle_of(features_[i - 1]);
      const auto rest = features_.begin() + static_cast<std::ptrdiff_t>(i);
      std::iter_swap(rest, std::min_element(rest, features_.end(), [&](auto a, auto b) {
                       return (middle_of(a) - here).norm() < (middle_of(b) - here).norm();
                     }));
    }
  }

  /// Turns stretches of the way round as long as that makes it shorter.
  void improve() {
    std::vector<Place> middles;
    for (const std::size_t feature : features_) {
      middles.push_back(middle_of(feature));
    }
    const auto gap = [&](std::size_t a, std::size_t b) {
      return b < middles.size() ? (middles[a] - middles[b]).norm() : 0.0;
    };
    constexpr double kGainMm = 1e-9;
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t i = 0; i + 2 < middles.size(); ++i) {
        for (std::size_t j = i + 2; j < middles.size(); ++j) {
          const double before = gap(i, i + 1) + gap(j, j + 1);
          const double after = gap(i, j) + (j + 1 < middles.size() ? gap(i + 1, j + 1) : 0.0);
          if (after < before - kGainMm) {
            const auto turn = [&](auto& list) {
              std::reverse(list.begin() + static_cast<std::ptrdiff_t>(i + 1),
                           list.begin() + static_cast<std::ptrdiff_t>(j + 1));
            };
            turn(middles);
            turn(features_);
            is_better = true;
          }
        }
      }
    }
  }

  /// Those of a round wall, which a cycle touches one after the other, behind the first of them.
  [[nodiscard]] Order gathered(Order points, std::size_t feature) const {
    const auto round = std::ranges::find(plan_.rounds, feature, &probe::PlannedRound::feature);
    if (round == plan_.rounds.end() || !round->by_points.empty()) {
      return points;
    }
    const auto is_of_wall = [&round](std::size_t point) {
      return std::ranges::find(round->points, point) != round->points.end();
    };
    const auto first = std::ranges::find_if(points, is_of_wall);
    std::stable_partition(first, points.end(), is_of_wall);
    std::ranges::copy(round->points, first);
    return points;
  }

  [[nodiscard]] Order shortest(Order points, const Place& from, const Place& next) const {
    std::ranges::sort(points);
    if (points.size() > kMostPermuted) {
      return points;
    }
    Order best = points;
    double least = std::numeric_limits<double>::infinity();
    do {
      double length = (place_of(points.front()) - from).norm();
      for (std::size_t i = 1; i < points.size(); ++i) {
        length += (place_of(points[i]) - place_of(points[i - 1])).norm();
      }
      length += (place_of(points.back()) - next).norm();
      if (length < least - 1e-9) {
        least = length;
        best = points;
      }
    } while (std::ranges::next_permutation(points).found);
    return best;
  }

  const probe::InspectionPlan& plan_;
  std::vector<Order> points_of_;  // by feature
  Order features_;                // that have points
};

}  // namespace

void put_in_order(probe::InspectionPlan& plan) {
  if (plan.measures.empty()) {
    return;
  }
  const Order order = WayFinder(plan).order();
  std::vector<probe::PlannedPoint> points;
  std::vector<std::size_t> new_place(plan.points.size());
  for (const std::size_t old_place : order) {
    new_place[old_place] = points.size();
    points.push_back(std::move(plan.points[old_place]));
    points.back().id = fmt::format("P{}", points.size());
  }
  plan.points = std::move(points);
  for (probe::PlannedMeasure& measure : plan.measures) {
    measure.first = new_place[measure.first];
    measure.second = new_place[measure.second];
  }
  for (probe::PlannedRound& round : plan.rounds) {
    for (std::size_t& point : round.points) {
      point = new_place[point];
    }
  }
}

}  // namespace g31::plan
