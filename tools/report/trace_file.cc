#include "tools/report/trace_file.h"

#include <utility>

#include <fmt/format.h>

namespace g31::report {

Result<std::shared_ptr<TraceFile>, std::string> TraceFile::create(const std::string& path,
                                                                  const AxesPresent& axes,
                                                                  runtime::OutputBudget& budget) {
  auto file = disk::PartFile::create(path);
  if (!file) {
    return disk::cannot_write(path, file.error());
  }
  std::string header = "time_s";
  for (const char* const what : {"commanded", "encoder", "true"}) {
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      if (axes.at(i)) {
        header += fmt::format(",{}_{}", kAxisLetters[i], what);
      }
    }
  }
  file.value()->write(header + "\n");
  return std::shared_ptr<TraceFile>(new TraceFile(path, file.value(), axes, budget));
}

TraceFile::TraceFile(const std::string& path, std::shared_ptr<disk::PartFile> file,
                     const AxesPresent& axes, runtime::OutputBudget& budget)
    : path_(path), file_(std::move(file)), axes_(axes), budget_(budget) {}

void TraceFile::on_sample(const machine::TraceSample& sample) {
  set_line(sample);
  if (budget_.charge(runtime::Output::Trace, line_.size())) {
    file_->write(line_);
  }
}

/// One row, whatever the others have left of the budget; none where they were cut off.
void TraceFile::on_end(const machine::TraceSample& sample) {
  if (!budget_.is_spent()) {
    set_line(sample);
    file_->write(line_);
  }
}

void TraceFile::set_line(const machine::TraceSample& sample) {
  line_.clear();
  line_ += fmt::format("{:.12g}", sample.time_s);
  append(line_, sample.q_M_commanded);
  append(line_, sample.q_M_encoder);
  append(line_, sample.q_M_true);
  line_ += '\n';
}

void TraceFile::append(std::string& line, const AxisPositions& q) const {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (axes_.at(i)) {
      // Adding 0 makes a zero of -0.
      line += fmt::format(",{:.7f}", q[static_cast<Eigen::Index>(i)] + 0.0);
    }
  }
}

std::optional<std::string> TraceFile::finish() {
  const auto problem = file_->finish();
  return problem ? std::optional(disk::cannot_write(path_, *problem)) : std::nullopt;
}

}  // namespace g31::report
