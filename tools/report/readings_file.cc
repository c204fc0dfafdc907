#include "tools/report/readings_file.h"

#include <utility>

#include <fmt/format.h>

namespace g31::report {

Result<std::shared_ptr<ReadingsFile>, std::string> ReadingsFile::create(
    const std::string& path, const AxesPresent& axes, std::vector<Column> sensors,
    runtime::OutputBudget& budget) {
  auto file = disk::PartFile::create(path);
  if (!file) {
    return disk::cannot_write(path, file.error());
  }
  std::string header = "t";
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (axes.at(i)) {
      header += fmt::format(",{}", kAxisLetters[i]);
    }
  }
  for (const Column& sensor : sensors) {
    header += "," + sensor.name;
  }
  file.value()->write(header + "\n");
  return std::shared_ptr<ReadingsFile>(
      new ReadingsFile(path, file.value(), axes, std::move(sensors), budget));
}

ReadingsFile::ReadingsFile(const std::string& path, std::shared_ptr<disk::PartFile> file,
                           const AxesPresent& axes, std::vector<Column> sensors,
                           runtime::OutputBudget& budget)
    : path_(path),
      file_(std::move(file)),
      axes_(axes),
      sensors_(std::move(sensors)),
      budget_(budget) {}

void ReadingsFile::add_row(const machine::MachinePort& machine) {
  std::string line = fmt::format("{:.12g}", machine.time_s());
  const AxisPositions q_M = machine.position();
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (axes_.at(i)) {
      // Adding 0 makes a zero of -0.
      line += fmt::format(",{:.7f}", q_M[static_cast<Eigen::Index>(i)] + 0.0);
    }
  }
  for (const Column& sensor : sensors_) {
    line += fmt::format(",{}", machine.displacement(sensor.input).value() + 0.0);
  }
  line += '\n';
  if (budget_.charge(runtime::Output::Readings, line.size())) {
    file_->write(line);
  }
}

std::optional<std::string> ReadingsFile::finish() {
  const auto problem = file_->finish();
  return problem ? std::optional(disk::cannot_write(path_, *problem)) : std::nullopt;
}

}  // namespace g31::report
