#include "tools/report/trace_file.h"

#include <cerrno>
#include <cstring>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace g31::report {

Result<std::shared_ptr<TraceFile>, std::string> TraceFile::create(const std::string& path,
                                                                  const AxesPresent& axes) {
  std::shared_ptr<TraceFile> trace(new TraceFile(path, axes));
  if (trace->file_ == nullptr) {
    return fmt::format("cannot write {}: {}", path, std::strerror(trace->error_));
  }
  std::string header = "time_s";
  for (const char* const what : {"commanded", "encoder", "true"}) {
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      if (axes.at(i)) {
        header += fmt::format(",{}_{}", kAxisLetters[i], what);
      }
    }
  }
  trace->write(header + "\n");
  return trace;
}

TraceFile::TraceFile(const std::string& path, const AxesPresent& axes)
    : path_(path),
      temporary_(fmt::format("{}.{}.part", path, ::getpid())),
      axes_(axes),
      file_(std::fopen(temporary_.c_str(), "wb")) {
  error_ = file_ == nullptr ? errno : 0;
}

TraceFile::~TraceFile() {
  if (file_ != nullptr) {
    std::fclose(file_);
    std::remove(temporary_.c_str());
  }
}

void TraceFile::on_sample(const machine::TraceSample& sample) {
  line_.clear();
  fmt::format_to(std::back_inserter(line_), "{:.12g}", sample.time_s);
  append(line_, sample.q_M_commanded);
  append(line_, sample.q_M_encoder);
  append(line_, sample.q_M_true);
  line_ += '\n';
  write(line_);
}

void TraceFile::append(std::string& line, const AxisPositions& q) const {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (axes_.at(i)) {
      // Adding 0 makes a zero of -0.
      fmt::format_to(std::back_inserter(line), ",{:.7f}", q[static_cast<Eigen::Index>(i)] + 0.0);
    }
  }
}

void TraceFile::write(const std::string& line) {
  if (error_ == 0 && std::fwrite(line.data(), 1, line.size(), file_) != line.size()) {
    error_ = errno;
  }
}

std::optional<std::string> TraceFile::finish() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) {
    error_ = errno;
  }
  if (error_ == 0 && std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ == 0) {
    return std::nullopt;
  }
  std::remove(temporary_.c_str());
  return fmt::format("cannot write {}: {}", path_, std::strerror(error_));
}

}  // namespace g31::report
