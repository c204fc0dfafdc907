#include "tools/cli/run_tables.h"

#include <array>
#include <vector>

namespace g31::cli {

Result<Tables, session::Refusal> open_tables(const RunOptions& options, const setup::Job& job,
                                             runtime::OutputBudget& budget) {
  std::array<bool, kAxisCount> axes{};
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    axes.at(i) = job.machine.axes[i].present;
  }
  Tables tables;
  if (!options.trace.empty()) {
    const auto trace = report::TraceFile::create(options.trace, axes, budget);
    if (!trace) {
      return session::bad_input(trace.error());
    }
    tables.trace = trace.value();
  }
  if (!options.readings.empty()) {
    std::vector<report::ReadingsFile::Column> sensors;
    for (const probe::DisplacementSetup& sensor : job.sensors) {
      sensors.push_back({sensor.name, sensor.input});
    }
    const auto readings = report::ReadingsFile::create(options.readings, axes, sensors, budget);
    if (!readings) {
      return session::bad_input(readings.error());
    }
    tables.readings = readings.value();
  }
  return tables;
}

std::optional<session::Refusal> Tables::finish() const {
  for (const auto& problem : {trace != nullptr ? trace->finish() : std::nullopt,
                              readings != nullptr ? readings->finish() : std::nullopt}) {
    if (problem) {
      return session::bad_input(*problem);
    }
  }
  return std::nullopt;
}

}  // namespace g31::cli
