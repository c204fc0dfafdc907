#include "tools/plan/plan_uses.h"

#include <algorithm>
#include <numeric>

namespace g31::plan {

PlanUses::PlanUses(const probe::InspectionPlan& plan)
    : rounds_(plan.points.size()),
      walls_(plan.measures.size()),
      at_(plan.points.size()),
      ready_at_(plan.points.size()),
      done_at_(plan.points.size()) {
  for (const probe::PlannedRound& round : plan.rounds) {
    take_round(round, plan);
  }
  std::vector<std::size_t> last_use(plan.points.size());
  std::iota(last_use.begin(), last_use.end(), std::size_t{0});
  for (std::size_t i = 0; i < plan.measures.size(); ++i) {
    take_measure(i, plan.measures[i], last_use);
  }
  for (std::size_t point = 0; point < last_use.size(); ++point) {
    done_at_[last_use[point]].push_back(point);
  }
}

void PlanUses::take_round(const probe::PlannedRound& round, const probe::InspectionPlan& plan) {
  if (round.by_points.empty()) {
    for (const std::size_t point : round.points) {
      rounds_[point] = rounds_[point] == nullptr ? &round : rounds_[point];
    }
  }
  for (const std::size_t measure : round.measures) {
    if (walls_[measure] == nullptr && plan.measures[measure].what == probe::Characteristic::Size) {
      walls_[measure] = &round;
    }
  }
}

void PlanUses::take_measure(std::size_t index, const probe::PlannedMeasure& measure,
                            std::vector<std::size_t>& last_use) {
  const probe::PlannedRound* const wall = walls_[index];
  const std::size_t last =
      wall != nullptr ? std::ranges::max(wall->points) : std::max(measure.first, measure.second);
  ready_at_[last].push_back(index);
  at_[measure.first].push_back(index);
  if (measure.second != measure.first) {
    at_[measure.second].push_back(index);
  }
  const auto needs = [&](std::size_t point) { last_use[point] = std::max(last_use[point], last); };
  needs(measure.first);
  needs(measure.second);
  if (wall != nullptr) {
    std::ranges::for_each(wall->points, needs);
  }
}

}  // namespace g31::plan
