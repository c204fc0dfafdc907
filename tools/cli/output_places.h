#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/session/refusal.h"

namespace g31::cli {

/// Where an option wants something written.
struct OutputPlace {
  std::string_view option;
  std::string path;  ///< "-": standard output; "": nothing is wanted
  /// Whether it is asked before the work if it can be written there; otherwise the command sees to
  /// its place itself.
  bool is_asked_first = false;
};

/// Of a text that is to name a file for an output: what is wrong with it; empty: nothing.
std::string why_no_place(const std::string& text);

/// Of a text that is to say where printouts go: the same.
std::string why_no_printer(const std::string& text);

/// Lists of files and folders that a command reads, or has read.
using InputLists = std::vector<std::vector<std::string>>;

/// Why outputs may not be where they are wanted: a file that is to be read is there, or another
/// output is to be.
std::optional<session::Refusal> wrong_place(const std::vector<OutputPlace>& outputs,
                                            const InputLists& inputs);

/// The same before the work, when it is also asked whether outputs can be written.
std::optional<session::Refusal> wrong_outputs(const std::vector<OutputPlace>& outputs,
                                              const InputLists& inputs);

/// Where an option wants something, if nothing is wrong with that place whatever is wrong with
/// those of the other outputs: what is refused is told there.  @returns "" where there is none
std::string sound_place(std::string_view option, const std::vector<OutputPlace>& outputs,
                        const InputLists& inputs);

}  // namespace g31::cli
