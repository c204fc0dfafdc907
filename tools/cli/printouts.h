#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "interpreter/runtime/printer_port.h"
#include "machine/base/result.h"
#include "tools/cli/run_command.h"
#include "tools/disk/part_file.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// Where the printouts of a run go: standard output, a file or a printer at a serial line.
class Printouts {
 public:
  /// As --printer says; without it to standard output, unless the document goes there; to standard
  /// error where a table does.
  /// @returns why that cannot be
  static Result<std::shared_ptr<Printouts>, session::Refusal> open(const RunOptions& options);

  Printouts(const Printouts&) = delete;
  Printouts& operator=(const Printouts&) = delete;
  ~Printouts();

  /// The text of a printout; a printer at a line has had it from the control.
  void write(std::string_view text);

  /// Whether people at the terminal see them there.
  [[nodiscard]] bool go_to_standard_output() const { return stream_ == stdout; }

  /// The printer at a line; nullptr: none.
  [[nodiscard]] runtime::PrinterPort* printer() const { return printer_.get(); }

  /// Closes a file.  @returns why it is not whole; nullopt: it is, or there is none
  std::optional<session::Refusal> finish();

 private:
  Printouts() = default;

  std::string path_;
  std::FILE* stream_ = nullptr;  // standard output or error, a device or pipe of ours, or none
  std::shared_ptr<disk::PartFile> file_;
  std::shared_ptr<runtime::PrinterPort> printer_;
  int error_ = 0;  // errno of the first failure
};

}  // namespace g31::cli
