#pragma once

#include <string>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "interpreter/source/source_map.h"
#include "tools/session/control.h"

namespace g31::session {

/// A message that somebody has allowed: it is neither shown nor counted.
struct AllowedMessage {
  source::Diagnostic message;
  std::string reason;  ///< as the program gives it; empty where the command line allows it
};

/// What a run came to, as people hear it.
struct Heard {
  runtime::Outcome outcome;  ///< without what is allowed
  std::vector<AllowedMessage> allowed;
};

/// Takes out of an outcome what comments of the programs allow (allow_comments.h), then what
/// `codes` name; errors stay.  A comment of the main program, or of a file that messages are of,
/// which allowed nothing in a completed run is a note itself (PRB326).
/// @param program  the path of the main program
/// @param codes    of warnings and notes
/// @param sources  of the programs that ran; files of more than kLongestFile are not looked at
Heard heard(runtime::Outcome outcome, const Control& control, const std::string& program,
            const std::vector<std::string>& codes, const source::SourceMap& sources);
inline constexpr std::size_t kLongestFile = 16U << 20U;

}  // namespace g31::session
