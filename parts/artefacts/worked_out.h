#pragma once

#include <span>
#include <string_view>

#include "parts/artefacts/artefact.h"
#include "parts/artefacts/makers.h"

namespace g31::parts {

/// A row of worked_out.def.
struct WorkedOut {
  std::string_view shape;
  std::string_view name;
  Quantity quantity;
  /// @param sizes  of the shape, with what stands in for those that are not given
  double (*from)(const Sizes& sizes);
  std::string_view text;
};

/// What stands for a size that the sheet does not give.
std::span<const WorkedOut> stand_ins();

/// What no size of the shape says.
std::span<const WorkedOut> worked_out();

}  // namespace g31::parts
