#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "probe/planning/inspection_plan.h"

namespace g31::plan {

enum class ProgramLanguage { Fanuc, Sinumerik };

/// How a program is written.  Its coordinates are those of the work offset, which are the
/// product's.
struct ProgramOptions {
  ProgramLanguage language = ProgramLanguage::Fanuc;
  bool has_metric_code = true;       ///< the control knows G21
  std::string product;               ///< its file, for the heading
  double ball_radius_mm = 3.0;       ///< > 0
  double clear_z_P = 0.0;            ///< of the ball's centre: it travels freely at this height
  double tip_below_centre_mm = 0.0;  ///< of the point that the control's length leads to
  std::optional<int> tool;           ///< the probe's number; none: it is in the spindle
  std::string tool_name;             ///< for controls that call tools by name; "": by number
  int length_offset = 1;             ///< the number of its length, H or D's tool
  std::string switch_on;             ///< a block that switches the probe on; "": it is on
  std::string switch_off;
  double start_up_s = 0.0;        ///< until the probe is ready behind switch_on
  double overtravel_mm = 3.0;     ///< behind the surface, until a touch is given up
  double approach_feed = 1000.0;  ///< mm/min
  double touch_feed = 100.0;
};

/// How a measure leaves the program.
struct PrintedMeasure {
  std::string name;  ///< printed before its value
  int decimals = 5;
  std::string variable;  ///< that has it at the end; "": it is used again before
};

struct InspectionProgram {
  std::string text;
  std::vector<PrintedMeasure> measures;  ///< as the plan has them
  std::size_t touches = 0;               ///< that come in a run
  /// Which of those touches the contact of each point is of, from 0.
  std::vector<std::size_t> touches_of_points;
};

/// Touches the points in their order: over each at the clear height, straight down to its start,
/// against the normal until the ball touches, back, and up.  A measure is computed and printed as
/// soon as both of its points are touched; a touch that does not come is an alarm that names the
/// point.  The four points of a round wall are touched by a cycle, where the plan has nothing
/// against it: on Fanuc O9010 (G100) for each of them, which touches twice; on SINUMERIK CYCLE977
/// twice, since its diameter is that of its second pair of touches.
///
/// Accuracy: values are those of the skip positions within 1e-6 mm (directions of turned features
/// are given in 1e-7 deg).  What a cycle measures is a diameter also where the circle is not where
/// it should be; of single touches it is a chord then.
InspectionProgram inspection_program(const probe::InspectionPlan& plan,
                                     const ProgramOptions& options);

}  // namespace g31::plan
