#include "tools/cli/printouts.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/disk/pipe_stream.h"
#include "tools/printer/line_spec.h"
#include "tools/printer/serial_printer.h"

namespace g31::cli {
namespace {

namespace fs = std::filesystem;

using session::Refusal;
using Printer = std::shared_ptr<runtime::PrinterPort>;

Refusal wrong_printer(const std::string& text, std::string_view why) {
  return session::bad_input(fmt::format("--printer {}: {}", text, why));
}

std::chrono::nanoseconds nanoseconds(double seconds) {
  constexpr double kLongest = 1e9;  // 30 years; ten times that is more than a clock counts
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(std::min(seconds, kLongest)));
}

Result<Printer, Refusal> open_line(const RunOptions& options) {
  const auto line = printer::parse_line_spec(options.printer);
  if (!line) {
    return wrong_printer(options.printer, line.error());
  }
  const auto opened = printer::SerialPrinter::open(
      line.value(), {nanoseconds(options.printer_wait_s),
                     std::chrono::steady_clock::now() + nanoseconds(options.budget.wall_seconds),
                     options.budget.interruption});
  if (!opened) {
    return wrong_printer(options.printer, opened.error());
  }
  return Printer(opened.value());
}

/// A device or a pipe: what is printed goes there at once.
Result<std::FILE*, Refusal> open_device(const std::string& path) {
  struct stat is = {};
  if (::stat(path.c_str(), &is) == 0 && S_ISFIFO(is.st_mode)) {
    const auto pipe = disk::open_pipe(path);
    return pipe ? Result<std::FILE*, Refusal>(pipe.value())
                : wrong_printer(path, fmt::format("cannot write: {}", pipe.error()));
  }
  // A line that waits for its modem would keep us here for ever without O_NONBLOCK.
  const int fd =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666);
  if (fd < 0) {
    return wrong_printer(path, fmt::format("cannot write: {}", std::strerror(errno)));
  }
  if (::isatty(fd) != 0) {
    ::close(fd);
    return wrong_printer(path,
                         fmt::format("a serial line needs its settings: {},4800,e,7,2", path));
  }
  ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) & ~O_NONBLOCK);
  std::FILE* const file = ::fdopen(fd, "wb");
  if (file == nullptr) {
    ::close(fd);
    return wrong_printer(path, std::strerror(errno));
  }
  return file;
}

}  // namespace

Result<std::shared_ptr<Printouts>, session::Refusal> Printouts::open(const RunOptions& options) {
  const std::shared_ptr<Printouts> printouts(new Printouts());
  if (options.printer.empty() || options.printer == "-") {
    // A document has them as well; a table has not.
    const bool is_told = options.json == "-" || options.jsonl == "-" || options.watch != nullptr;
    const bool is_taken = options.trace == "-" || options.readings == "-";
    printouts->stream_ = is_told ? nullptr : is_taken ? stderr : stdout;
    return printouts;
  }
  if (printer::names_a_line(options.printer)) {
    const auto line = open_line(options);
    if (!line) {
      return line.error();
    }
    printouts->printer_ = line.value();
    return printouts;
  }
  printouts->path_ = options.printer;
  std::error_code error;
  if (fs::exists(options.printer, error) && !fs::is_regular_file(options.printer, error)) {
    const auto device = open_device(options.printer);
    if (!device) {
      return device.error();
    }
    printouts->stream_ = device.value();
    return printouts;
  }
  const auto file = disk::PartFile::create(options.printer);
  if (!file) {
    return wrong_printer(options.printer, fmt::format("cannot write: {}", file.error()));
  }
  printouts->file_ = file.value();
  return printouts;
}

Printouts::~Printouts() {
  if (!path_.empty() && stream_ != nullptr) {
    std::fclose(stream_);
  }
}

void Printouts::write(std::string_view text) {
  if (file_ != nullptr) {
    file_->write(text);
  }
  if (stream_ != nullptr && std::fwrite(text.data(), 1, text.size(), stream_) != text.size() &&
      error_ == 0) {
    error_ = errno;
  }
}

std::optional<session::Refusal> Printouts::finish() {
  if (file_ != nullptr) {
    const auto problem = file_->finish();
    return problem ? std::optional(wrong_printer(path_, fmt::format("cannot write: {}", *problem)))
                   : std::nullopt;
  }
  if (path_.empty() || stream_ == nullptr) {
    return std::nullopt;
  }
  std::FILE* const file = stream_;
  stream_ = nullptr;
  if (std::fclose(file) != 0 && error_ == 0) {
    error_ = errno;
  }
  return error_ == 0 ? std::nullopt
                     : std::optional(wrong_printer(
                           path_, fmt::format("cannot write: {}", disk::words_for(error_))));
}

}  // namespace g31::cli
