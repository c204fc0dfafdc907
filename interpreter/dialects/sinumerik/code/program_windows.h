#pragma once

#include <memory>

#include "interpreter/dialects/sinumerik/code/compile.h"
#include "interpreter/dialects/sinumerik/code/program_file.h"

namespace g31::sinumerik {

/// Programs beyond this size are compiled window by window; shorter ones at once.
inline constexpr std::uint32_t kWholeProgramBytes = 1U << 20;

/// A long program as a run of windows, of which one at a time is in memory.  The first block that
/// says something of others (a jump, label, call or definition) has it compiled as a whole.
class ProgramWindows {
 public:
  /// Both must outlive the windows.
  ProgramWindows(FiledProgram& program, const Globals& globals)
      : filed_(program), globals_(globals), end_(program.source().text.begin) {}

  /// Where a run goes on.
  struct Place {
    const CompiledProgram* program = nullptr;
    std::int32_t step = 0;
  };
  /// The next window, or a step of the whole; ends the life of the window before.  To be asked once
  /// for the beginning, and at every EndWindow.
  Place next();

 private:
  FiledProgram& filed_;
  const Globals& globals_;
  std::unique_ptr<CompiledProgram> program_;  ///< present window
  std::uint32_t end_;                         ///< of the present window's text
  std::int32_t steps_before_ = 0;
};

}  // namespace g31::sinumerik
