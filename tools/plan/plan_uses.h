#pragma once

#include <cstddef>
#include <vector>

#include "probe/planning/inspection_plan.h"

namespace g31::plan {

/// What each point and each measure of a plan has to do with the others; the plan must outlive it.
class PlanUses {
 public:
  explicit PlanUses(const probe::InspectionPlan& plan);

  /// What a cycle measures with this point; null: the point is touched by itself.
  [[nodiscard]] const probe::PlannedRound* round_of(std::size_t point) const {
    return rounds_[point];
  }
  /// The round wall whose diameter a measure is; null: it is none.
  [[nodiscard]] const probe::PlannedRound* wall_across(std::size_t measure) const {
    return walls_[measure];
  }
  /// The measures from or to a point.
  [[nodiscard]] const std::vector<std::size_t>& measures_at(std::size_t point) const {
    return at_[point];
  }
  /// The measures whose last contact is that of this point.
  [[nodiscard]] const std::vector<std::size_t>& measures_ready_at(std::size_t point) const {
    return ready_at_[point];
  }
  /// The points whose contacts nothing needs behind this one.
  [[nodiscard]] const std::vector<std::size_t>& points_done_at(std::size_t point) const {
    return done_at_[point];
  }

 private:
  void take_round(const probe::PlannedRound& round, const probe::InspectionPlan& plan);
  /// @param last_use  of each point so far: the point behind which nothing needs its contact
  void take_measure(std::size_t index, const probe::PlannedMeasure& measure,
                    std::vector<std::size_t>& last_use);

  std::vector<const probe::PlannedRound*> rounds_;  // by point
  std::vector<const probe::PlannedRound*> walls_;   // by measure
  std::vector<std::vector<std::size_t>> at_;
  std::vector<std::vector<std::size_t>> ready_at_;
  std::vector<std::vector<std::size_t>> done_at_;
};

}  // namespace g31::plan
