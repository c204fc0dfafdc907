#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "tests/support/run_program.h"

namespace g31::testing {

/// A table of common variables that the G100 family reads and writes.
enum class Buffer { A, B, C };

/// Rows of the buffers before the start, and the calls to run on them.
class PointProgram {
 public:
  void put(Buffer buffer, int row, const Eigen::Vector3d& point) {
    const int before_row_1 = buffer == Buffer::A ? 159 : buffer == Buffer::B ? 99 : 104;
    for (int axis = 0; axis < 3; ++axis) {
      assignments_.push_back(
          fmt::format("#{}={:.17g}", before_row_1 + 15 * axis + row, point[axis]));
    }
  }

  /// Runs the call; every variable that the family writes is in the document.
  [[nodiscard]] RunOutput run(const std::string& call) const {
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("call.nc", "%\nO1\n" + call + "\nM30\n%\n")};
    options.setups = {"parts/library/hirose_figures/machine.toml"};
    options.assignments = assignments_;
    options.prints = {"#100-#199"};
    return run_program(options);
  }

 private:
  std::vector<std::string> assignments_;
};

/// A variable of the document; nullopt: vacant.
inline std::optional<double> value_of(const RunOutput& output, int variable) {
  const auto& value = output.document.at("variables").at(fmt::format("#{}", variable));
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

/// Row `row` of a buffer whose X column begins behind `before_row_1`; NaN where it is vacant.
inline Eigen::Vector3d point_of(const RunOutput& output, int before_row_1, int row) {
  Eigen::Vector3d point;
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = value_of(output, before_row_1 + 15 * axis + row)
                      .value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return point;
}

}  // namespace g31::testing
