#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "machine/base/result.h"

namespace g31::metrology {

/// One approach of a target.
struct Approach {
  double target = 0.0;    ///< mm
  double position = 0.0;  ///< reached, mm
  bool is_up = true;      ///< in the positive direction
};

/// What the approaches of one target from one side say, mm.
struct DirectionStatistics {
  double mean = 0.0;           ///< of the deviations
  double s = 0.0;              ///< estimator of their standard deviation, n - 1
  std::size_t approaches = 0;  ///< n
};

struct TargetStatistics {
  double target = 0.0;
  std::optional<DirectionStatistics> up;
  std::optional<DirectionStatistics> down;
};

/// ISO 230-2:2014, mm; what needs both directions is there only if every target has both.
struct PositioningEvaluation {
  std::vector<TargetStatistics> targets;  ///< rising
  std::optional<double> A, A_up, A_down;  ///< accuracy
  std::optional<double> R, R_up, R_down;  ///< repeatability
  std::optional<double> B;                ///< reversal value
  std::optional<double> E, E_up, E_down;  ///< systematic deviation
  std::optional<double> M;                ///< mean bi-directional deviation
};

/// Accuracy and repeatability of positioning of one axis, ISO 230-2:2014: deviations x = position -
/// target, means and standard deviations s of each target and direction,
///
///   B_i = mean_up - mean_down,   B = max |B_i|
///   R_i up = 4 s_up,             R_i = max(2 s_up + 2 s_down + |B_i|, R_i up, R_i down),  R = max
///   E = greatest less least mean of both directions,   M = the same of (mean_up + mean_down) / 2
///   A = max(mean + 2 s) - min(mean - 2 s) of both directions.
///
/// Error: a target that was reached once from a side, and so has no s.
Result<PositioningEvaluation, std::string> evaluate_positioning(
    std::span<const Approach> approaches);

}  // namespace g31::metrology
