#pragma once

#include <string>
#include <vector>

#include "interpreter/runtime/interruption.h"
#include "interpreter/source/diagnostic.h"
#include "tools/cli/exit_code.h"

namespace g31::cli {

/// What the command line of `g31 check` says.
struct CheckOptions {
  enum class Format { Text, Json, Sarif, Github };

  std::vector<std::string> files;        ///< or folders
  std::vector<std::string> setups = {};  ///< sheets; later ones win key by key
  std::string control = {};  ///< "": as the sheets say, else each file speaks for itself
  std::vector<std::string> libraries = {};
  std::vector<std::string> disabled = {};  ///< codes of rules
  Format format = Format::Text;
  std::string json = {};  ///< file of the document, - for standard output; "": none
  source::Severity fail_on = source::Severity::Warning;
  std::string baseline = {};  ///< an earlier document; "": none
  bool lists_rules = false;
  bool is_quiet = false;  ///< no progress
  std::string version;    ///< of g31
  const runtime::Interruption* interruption = nullptr;
};

/// Prints what is wrong with programs as far as it can be told without running them.
ExitCode check_command(const CheckOptions& options);

}  // namespace g31::cli
