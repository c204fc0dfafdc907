#pragma once

#include <string>
#include <vector>

#include "tools/cli/exit_code.h"

namespace g31::cli {

/// What the command line of `g31 explain` says.
struct ExplainOptions {
  std::vector<std::string> topics = {};
  std::string control = {};  ///< "" for the default
  std::string json = {};     ///< file of the document, - for standard output; "": none
  bool all = false;
  std::string page = {};  ///< of docs: printed instead
  bool search = false;    ///< by words, even where something is named so
};

/// Prints what the tables of a control, of set-up sheets, shapes, studies, evaluations and codes
/// say about topics, and of a topic that nothing is named by one line for each thing whose text has
/// the words; standard error names the nearest topic of an unknown one.
ExitCode explain_command(const ExplainOptions& options);

}  // namespace g31::cli
