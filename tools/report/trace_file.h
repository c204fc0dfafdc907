#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "interpreter/runtime/output_budget.h"
#include "machine/base/result.h"
#include "machine/port/trace.h"
#include "tools/disk/part_file.h"

namespace g31::report {

/// Axis positions over time as a table: a line of names, then a line a sample.
///
///   time_s,X_commanded,Y_commanded,...,X_encoder,...,X_true,...
///
/// Positions in mm and deg with seven decimals, machine coordinates.
class TraceFile final : public machine::TraceSink {
 public:
  using AxesPresent = std::array<bool, kAxisCount>;

  /// @param budget  is charged for each row; outlives the file
  /// @returns why the file cannot be written
  static Result<std::shared_ptr<TraceFile>, std::string> create(const std::string& path,
                                                                const AxesPresent& axes,
                                                                runtime::OutputBudget& budget);
  void on_sample(const machine::TraceSample& sample) override;
  void on_end(const machine::TraceSample& sample) override;

  /// Gives the file its name.  @returns why it is not whole; nullopt: it is
  std::optional<std::string> finish();

 private:
  TraceFile(const std::string& path, std::shared_ptr<disk::PartFile> file, const AxesPresent& axes,
            runtime::OutputBudget& budget);
  void append(std::string& line, const AxisPositions& q) const;
  void set_line(const machine::TraceSample& sample);

  std::string path_;
  std::shared_ptr<disk::PartFile> file_;
  AxesPresent axes_;
  runtime::OutputBudget& budget_;
  std::string line_;
};

}  // namespace g31::report
