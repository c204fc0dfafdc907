#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parts/features/feature.h"
#include "parts/geometry/box.h"
#include "probe/planning/inspection_plan.h"
#include "tools/plan/inspection_program.h"
#include "tools/plan/judgement.h"
#include "tools/session/world.h"

namespace g31::plan {

/// A part with what is to be measured on it, the program that does it, and what it was proven by.
struct PlannedPart {
  std::string product;        ///< its file, without its folder
  std::string control;        ///< the profile's name
  std::string program_file;   ///< by its language, without its folder
  session::BuiltParts built;  ///< of the sheet: the product and its fixtures
  parts::Box product_P;
  parts::RecognisedPart part;
  probe::InspectionPlan plan;
  std::string_view cycle;  ///< that measures round walls: "CYCLE977"
  InspectionProgram program;
  double ball_radius_mm = 0.0;
  std::size_t touches = 0;            ///< of the run that proved it
  double machine_time_s = 0.0;        ///< of that run
  std::string notes;                  ///< of that run, as people read them; mostly ""
  double largest_deviation_mm = 0.0;  ///< of a measure in that run
  std::vector<std::optional<double>> proven_values;  ///< of the measures in that run
  Judgement on_product;                              ///< what that run printed
  std::optional<Judgement> as_machined;

  /// Whether a volume is of no kind, or a size is left out.
  [[nodiscard]] bool leaves_something_out() const {
    return !part.unknown.empty() || !plan.left_out.empty();
  }
  /// Whether the program calls a part good that is as drawn.
  [[nodiscard]] bool is_proven() const { return count(on_product, Verdict::Bad) == 0; }
  /// Whether the program came to every measure of the part as machined, where there is one.
  [[nodiscard]] bool measures_as_machined() const {
    return !as_machined || count(*as_machined, Verdict::Missing) == 0;
  }
  /// Whether everything is measured, by a program that is proven.
  [[nodiscard]] bool is_whole() const {
    return !leaves_something_out() && is_proven() && measures_as_machined();
  }
};

/// Of a feature with a round wall that is measured across; null: it has none.
const probe::PlannedRound* round_of(const PlannedPart& planned, std::size_t feature);

/// "F7": the ids of features, and behind them of the volumes of no kind.
std::string feature_id(std::size_t index);

/// What a run judges printed values by.
std::vector<Measure> measures_of(const PlannedPart& planned);

}  // namespace g31::plan
