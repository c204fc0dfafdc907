#pragma once

#include <string>

#include "machine/base/result.h"

namespace g31::plan {

/// What an inspection program printed.
struct PrintedResults {
  std::string from;  ///< for messages, in front of the number of a line
  std::string text;
};

/// Of a document g31.run/1 what its program printed, or else the one file that it wrote; any other
/// text as it is.
/// @param name  of the file
///
/// Error: one line: another document, or one whose program printed nothing and wrote no file or
/// several.
Result<PrintedResults, std::string> printed_results(const std::string& name, std::string text);

}  // namespace g31::plan
