#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "interpreter/runtime/outcome.h"
#include "machine/base/result.h"
#include "probe/planning/plan_inspection.h"
#include "tools/plan/planned_part.h"
#include "tools/session/refusal.h"

namespace g31::plan {

/// What planning a part spends its time on.
enum class PlanWork { Features, Proof, ProofAsMachined, Page };

/// Told again and again how far a work is.
/// @param touches  of the program; 0: not known before it is planned
using PlanWatch = std::function<void(PlanWork work, std::size_t touches)>;

/// What is to be planned.
struct PlanRequest {
  std::string product;                 ///< a STEP file, or a mesh
  std::string stock;                   ///< a file, "X,Y,Z" in mm, or "box"
  std::string control;                 ///< a name; empty: that of the sheet, else the default
  std::string sheet;                   ///< of the user's; empty: a usual one
  std::optional<double> tolerance_mm;  ///< > 0, of every measure
  bool by_points = false;              ///< round walls are not measured by the control's cycles
  std::string as_machined;             ///< a part to run the program on as well; empty: none
  std::string folder;                  ///< in which sheet and program are written, to be run there
  const runtime::Interruption* interruption = nullptr;
  PlanWatch watch = [](PlanWork /*work*/, std::size_t /*touches*/) {};
};

/// From the product to the proven program: sheet and program are in the folder then.
///
/// Error: what cannot be read or planned; the program did not run to its end against the product,
/// and why.
Result<PlannedPart, session::Refusal> plan_part(const PlanRequest& request);

}  // namespace g31::plan
