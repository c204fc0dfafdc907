#include "tests/support/turning_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace g31::testing {

MeasuringRun run_turning(const std::string& body, const std::vector<std::string>& sheets,
                         const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("turned.mpf", "T1 D1 M6\n" + body + "\nM30\n")};
  options.setups = {folder.write("base.toml", kLatheSheet)};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    options.setups.push_back(folder.write(fmt::format("sheet{}.toml", i), sheets[i]));
  }
  options.prints = names;
  options.touches = true;
  return {run_program(options)};
}

MeasuringRun expect_turned(const std::string& body, const std::vector<std::string>& sheets,
                           const std::vector<ExpectedValue>& expected, double tolerance) {
  std::vector<std::string> names;
  for (const ExpectedValue& row : expected) {
    names.push_back(row.name);
  }
  MeasuringRun run = run_turning(body, sheets, names);
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  if (run.output.document.is_object()) {
    for (const ExpectedValue& row : expected) {
      EXPECT_NEAR(run.at(row.name), row.value, tolerance) << row.name;
    }
  }
  return run;
}

}  // namespace g31::testing
