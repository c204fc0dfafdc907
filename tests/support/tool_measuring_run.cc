#include "tests/support/tool_measuring_run.h"

#include <fmt/format.h>

namespace g31::testing {

MeasuringRun run_tools(const std::string& body, const std::vector<std::string>& sheets,
                       const std::vector<std::string>& names) {
  return run_on_sheets(body, sheets_behind(kToolSheet, sheets), names);
}

MeasuringRun expect_tools(const std::string& body, const std::vector<std::string>& sheets,
                          const std::vector<ExpectedValue>& expected, double tolerance,
                          const std::vector<std::string>& more) {
  MeasuringRun run = run_tools(body, sheets, names_of(expected, more));
  expect_values(run, expected, tolerance);
  return run;
}

std::string with_tool(int tool, double x, double y) {
  return fmt::format("T{} M6\nG54 D1\nG0 SUPA X{:.3f} Y{:.3f} Z-280\n", tool, x, y);
}

}  // namespace g31::testing
