#pragma once

#include <atomic>
#include <cstddef>
#include <string>

#include "tools/cli/status_line.h"

namespace g31::cli {

/// Says on a terminal how far work has come and how long it will still take.
class Progress {
 public:
  /// @param total  pieces of work; 0: nobody knows how many
  /// @param what   the pieces, "runs"; where nobody knows how many, the work
  /// @param shows  shows_progress()
  Progress(std::size_t total, std::string what, bool shows);

  /// A piece is done, or the work is still going on.  From any thread.
  void one_done();

 private:
  [[nodiscard]] std::string text(std::size_t done, double elapsed_s) const;

  std::size_t total_;
  std::string what_;
  std::atomic<std::size_t> done_ = 0;
  StatusLine line_;
};

}  // namespace g31::cli
