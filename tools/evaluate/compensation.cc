#include "tools/evaluate/compensation.h"

#include <fmt/format.h>

namespace g31::evaluate {

std::string compensation_sheet(std::string_view error, const Curve& deviations) {
  std::string text = fmt::format(
      "# Corrections, mm, at machine coordinates of the moving axis.\n[machine.compensation]\n"
      "{} = [\n",
      error);
  for (const auto& [place, deviation] : deviations.points) {
    // Adding 0 makes a zero of -0; TOML wants a point in a number.
    text += fmt::format("  [{:.6f}, {:.9f}],\n", place + 0.0, 0.0 - deviation);
  }
  return text + "]\n";
}

}  // namespace g31::evaluate
