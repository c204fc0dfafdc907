#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "probe/metrology/circle_directions.h"
#include "probe/metrology/circle_model.h"
#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// What is known of a circle beside its record.
struct CircleRequest {
  std::optional<double> radius;           ///< the commanded one, mm, > 0
  std::optional<Eigen::Vector2d> centre;  ///< of the radial errors, mm
  double resolution = 0.0;                ///< one step of the numbers of the record, mm
  CyclicPitches pitches = {};             ///< of the axes whose cyclic error is sought
};

/// The least and the greatest of many numbers.
struct Extremes {
  double least = 0.0;
  double greatest = 0.0;

  [[nodiscard]] double width() const { return greatest - least; }
};

/// What a recorded circle says.  Index 0 is the first axis of the plane, 1 the second.
struct CircleEvaluation {
  /// Radial errors are about it: as requested, else of least squares over all turns, or that of the
  /// model where no turn is whole.
  Circle reference;
  CircleFit fit;
  std::vector<CircleTurn> turns;
  Extremes radial_error;           ///< mm, over all turns
  double mean_radial_error = 0.0;  ///< mm, mean over the angle of what was recorded
  std::optional<Extremes> ccw;     ///< the same of one direction, where recorded
  std::optional<Extremes> cw;
  /// Smallest distance of two circles that hold the path, mm: all turns, counter-clockwise,
  /// clockwise.
  std::optional<double> minimum_zone;
  std::optional<double> minimum_zone_ccw;
  std::optional<double> minimum_zone_cw;
  std::optional<CircleDirections> directions;  ///< where both were recorded
  std::array<std::optional<double>, 2> spike;  ///< mm; where no reversal was recorded, nothing
};

/// Evaluates a recorded circle.
///
/// What of the record lies on the circle: `find_circle`, `circle_turns`, and `without_leads` of it
/// all but the ways that lead into it and out of it.  Radial error: distance from the centre less
/// the radius, of every sample there.  What makes the path so, `fit`, is fitted to the samples that
/// the model describes: not those within 0.3 s of the start of a turn and 0.1 s of its end (servo
/// loops settle; 10 to 60 degrees, a third of the turn at most), nor those from 2 degrees before a
/// reversal of an axis to 10 degrees behind it and further while the residuals are significant
/// there (play is taken up, friction turns round), at most 40.  What form and friction make
/// uncertain: `add_systematic`.  The spike of an axis is the largest residual outwards in those
/// ranges.
///
/// Error: what is wrong with the record as a circle, one line.
Result<CircleEvaluation, std::string> evaluate_circle(const PlaneSamples& samples,
                                                      const CircleRequest& request);

}  // namespace g31::metrology
