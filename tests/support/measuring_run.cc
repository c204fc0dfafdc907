#include "tests/support/measuring_run.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace g31::testing {

std::string part(const std::string& shape, double x, double y, double z, const std::string& more) {
  return fmt::format(
      "[[part]]\nname = \"{0}\"\nshape = \"{0}\"\nat = [{1:.6f}, {2:.6f}, {3:.6f}]\n{4}\n", shape,
      x, y, z, more);
}

std::string part_aside(const std::string& shape, const std::string& more) {
  return part(shape, 100.2, 49.7, -300.0, more);
}
std::string ring_aside(double bore) {
  return part_aside("ring", fmt::format("bore = {:.4f}", bore));
}

double MeasuringRun::at(const std::string& name) const {
  const auto value = output.document.at("variables").value(name, nlohmann::json());
  return value.is_number() ? value.get<double>() : std::nan("");
}

int MeasuringRun::alarm() const {
  const auto number = output.document.value("/alarm/number"_json_pointer, nlohmann::json());
  return number.is_number() ? number.get<int>() : 0;
}

MeasuringRun run_on_sheets(const std::string& program, const std::vector<std::string>& sheets,
                           const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("part.mpf", program + "\nM30\n")};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    options.setups.push_back(folder.write(fmt::format("sheet{}.toml", i), sheets[i]));
  }
  options.prints = names;
  options.touches = true;
  return {run_program(options)};
}

std::vector<std::string> sheets_behind(const std::string& base,
                                       const std::vector<std::string>& sheets) {
  std::vector<std::string> all = {base};
  all.insert(all.end(), sheets.begin(), sheets.end());
  return all;
}

std::vector<std::string> names_of(const std::vector<ExpectedValue>& expected,
                                  const std::vector<std::string>& more) {
  std::vector<std::string> names = more;
  for (const ExpectedValue& row : expected) {
    names.push_back(row.name);
  }
  return names;
}

/// Whether a measuring cycle is to end with 61304 to 61306, which it shows: the part or the tool is
/// out of tolerance.
bool is_out_of_tolerance(const std::vector<ExpectedValue>& expected) {
  return std::ranges::any_of(expected, [](const ExpectedValue& row) {
    return row.name == "_OVI[9]" && row.value >= 61304.0 && row.value <= 61306.0;
  });
}

void expect_values(const MeasuringRun& run, const std::vector<ExpectedValue>& expected,
                   double tolerance) {
  const bool is_told = is_out_of_tolerance(expected);
  EXPECT_EQ(run.output.exit_code, is_told ? 1 : 0) << run.output.errors;
  EXPECT_EQ(run.output.errors.find("[PRB327]") != std::string::npos, is_told);
  if (run.output.document.is_object()) {
    for (const ExpectedValue& row : expected) {
      EXPECT_NEAR(run.at(row.name), row.value, tolerance) << row.name;
    }
  }
}

MeasuringRun run_measuring(const std::string& body, const std::vector<std::string>& sheets,
                           const std::vector<std::string>& names) {
  return run_on_sheets("T1 M6\nG54 D1\nG0 X0 Y0 Z20\n" + body,
                       sheets_behind(kMeasuringSheet, sheets), names);
}

MeasuringRun expect_measured(const std::string& body, const std::vector<std::string>& sheets,
                             const std::vector<ExpectedValue>& expected, double tolerance,
                             const std::vector<std::string>& more_names) {
  MeasuringRun run = run_measuring(body, sheets, names_of(expected, more_names));
  expect_values(run, expected, tolerance);
  return run;
}

void expect_measured(std::span<const MeasuringCase> cases, double tolerance) {
  for (const MeasuringCase& row : cases) {
    SCOPED_TRACE(row.name);
    expect_measured(row.program, {row.parts, kCalibrated}, row.expected, tolerance);
  }
}

}  // namespace g31::testing
