#include "tests/support/turning_run.h"

namespace g31::testing {

MeasuringRun run_turning(const std::string& body, const std::vector<std::string>& sheets,
                         const std::vector<std::string>& names) {
  return run_on_sheets("T1 D1 M6\n" + body, sheets_behind(kLatheSheet, sheets), names);
}

MeasuringRun expect_turned(const std::string& body, const std::vector<std::string>& sheets,
                           const std::vector<ExpectedValue>& expected, double tolerance) {
  MeasuringRun run = run_turning(body, sheets, names_of(expected));
  expect_values(run, expected, tolerance);
  return run;
}

}  // namespace g31::testing
