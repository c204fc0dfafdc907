#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/output_budget.h"
#include "machine/base/result.h"
#include "machine/port/machine_port.h"
#include "tools/disk/part_file.h"

namespace g31::report {

/// What displacement sensors read at the stops of a program as a table: a line of names, then a
/// line a stop.
///
///   t,X,Y,Z,A,B
///
/// t in s, axes as commanded in mm and deg (machine coordinates, seven decimals), readings in mm as
/// the shortest text that means the same number.
class ReadingsFile {
 public:
  using AxesPresent = std::array<bool, kAxisCount>;
  /// A sensor, and the analog input that it is wired to.
  struct Column {
    std::string name;
    int input = 0;
  };

  /// @param sensors  of the machine whose rows there will be
  /// @param budget   is charged for each row; outlives the file
  /// @returns why the file cannot be written
  static Result<std::shared_ptr<ReadingsFile>, std::string> create(const std::string& path,
                                                                   const AxesPresent& axes,
                                                                   std::vector<Column> sensors,
                                                                   runtime::OutputBudget& budget);

  /// Where the axes of the machine are now, and what its sensors read there.
  void add_row(const machine::MachinePort& machine);

  /// Gives the file its name.  @returns why it is not whole; nullopt: it is
  std::optional<std::string> finish();

 private:
  ReadingsFile(const std::string& path, std::shared_ptr<disk::PartFile> file,
               const AxesPresent& axes, std::vector<Column> sensors, runtime::OutputBudget& budget);

  std::string path_;
  std::shared_ptr<disk::PartFile> file_;
  AxesPresent axes_;
  std::vector<Column> sensors_;
  runtime::OutputBudget& budget_;
};

}  // namespace g31::report
