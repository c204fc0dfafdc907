#include "tests/support/tool_measuring_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace g31::testing {

MeasuringRun run_sheets(const std::string& body, const std::vector<std::string>& sheets,
                        const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("part.mpf", body + "\nM30\n")};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    options.setups.push_back(folder.write(fmt::format("sheet{}.toml", i), sheets[i]));
  }
  options.prints = names;
  options.touches = true;
  return {run_program(options)};
}

MeasuringRun run_tools(const std::string& body, const std::vector<std::string>& sheets,
                       const std::vector<std::string>& names) {
  std::vector<std::string> all = {kToolSheet};
  all.insert(all.end(), sheets.begin(), sheets.end());
  return run_sheets(body, all, names);
}

MeasuringRun expect_tools(const std::string& body, const std::vector<std::string>& sheets,
                          const std::vector<ExpectedValue>& expected, double tolerance,
                          const std::vector<std::string>& more) {
  std::vector<std::string> names = more;
  for (const ExpectedValue& row : expected) {
    names.push_back(row.name);
  }
  MeasuringRun run = run_tools(body, sheets, names);
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  for (const ExpectedValue& row : expected) {
    EXPECT_NEAR(run.at(row.name), row.value, tolerance) << row.name;
  }
  return run;
}

std::string with_tool(int tool, double x, double y) {
  return fmt::format("T{} M6\nG54 D1\nG0 SUPA X{:.3f} Y{:.3f} Z-280\n", tool, x, y);
}

}  // namespace g31::testing
