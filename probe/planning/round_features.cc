#include "probe/planning/round_features.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace g31::probe {
namespace {

constexpr double kSameHeightMm = 1e-6;

std::optional<std::size_t> measure_of(const InspectionPlan& plan, std::size_t feature, char axis,
                                      Characteristic what) {
  const auto found = std::ranges::find_if(plan.measures, [&](const PlannedMeasure& measure) {
    return measure.feature == feature && measure.axis == axis && measure.what == what;
  });
  return found == plan.measures.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - plan.measures.begin()));
}

/// @returns nullopt: not all that a circle has is measured
std::optional<PlannedRound> round_of(const parts::Feature& feature, const InspectionPlan& plan,
                                     std::size_t index) {
  PlannedRound round;
  round.feature = index;
  round.is_standing = feature.is_standing();
  std::size_t next = 0;
  for (const char axis : {'X', 'Y'}) {
    for (const Characteristic what : {Characteristic::Size, Characteristic::Place}) {
      const auto measure = measure_of(plan, index, axis, what);
      if (!measure) {
        return std::nullopt;
      }
      round.measures[next] = *measure;
      round.points[next] = what == Characteristic::Size ? plan.measures[*measure].first
                                                        : plan.measures[*measure].second;
      ++next;
    }
  }
  const auto middle = (feature.own.min + feature.own.max) / 2;
  round.centre_P = {middle.x(), middle.y(), plan.points[round.points[0]].at_P.z()};
  round.diameter_mm = feature.own.max.x() - feature.own.min.x();
  return round;
}

/// What keeps a cycle from measuring it; "": nothing.
std::string obstacle_of(const PlannedRound& round, const InspectionPlan& plan, double clear_z_P,
                        const IsBlocked& is_blocked) {
  for (const std::size_t index : round.points) {
    if (std::abs(plan.points[index].at_P.z() - round.centre_P.z()) > kSameHeightMm) {
      return "its walls are not touched at one height";
    }
  }
  if (round.is_standing) {
    return "";  // each touch begins where one by itself does
  }
  const Point above(round.centre_P.x(), round.centre_P.y(),
                    std::max(clear_z_P, round.centre_P.z()));
  auto why = is_blocked(above, round.centre_P);
  for (const std::size_t index : round.points) {
    why = why ? why : is_blocked(round.centre_P, plan.points[index].start_P);
  }
  return why ? fmt::format("{} on the way from its middle", *why) : "";
}

}  // namespace

std::vector<PlannedRound> round_features(const parts::RecognisedPart& part,
                                         const InspectionPlan& plan, double ball_radius_mm,
                                         double clear_z_P, const IsBlocked& is_blocked) {
  std::vector<PlannedRound> rounds;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    auto round = part.features[i].is_round ? round_of(part.features[i], plan, i) : std::nullopt;
    if (!round) {
      continue;
    }
    round->by_points = obstacle_of(*round, plan, clear_z_P, is_blocked);
    for (const std::size_t index : round->points) {
      const PlannedPoint& point = plan.points[index];
      round->approach_mm =
          std::min(round->approach_mm, (point.start_P - point.at_P).norm() - ball_radius_mm);
    }
    rounds.push_back(*std::move(round));
  }
  return rounds;
}

}  // namespace g31::probe
