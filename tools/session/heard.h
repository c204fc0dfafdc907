#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "interpreter/source/file_system.h"
#include "interpreter/source/source_map.h"
#include "tools/session/control.h"
#include "tools/session/message_comments.h"

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

/// The comments of programs that allow a message, whichever files are asked for: each is read once,
/// so many runs of a program may share them.  Any number of threads may ask.
class ProgramComments {
 public:
  /// @param files  outlives it
  ProgramComments(source::FileSystem& files, const Control& control);

  /// Of a file that cannot be read, or is longer than kLongestFile, there are none.
  const std::vector<MessageComment>& of(const std::string& file);

 private:
  static constexpr std::size_t kLongestFile = 16U << 20U;

  bool may_have_comments(const std::string& file);

  source::FileSystem& files_;
  CommentForm form_;
  std::mutex mutex_;
  std::map<std::string, std::vector<MessageComment>> by_file_;
};

/// Takes out of an outcome what comments of the programs allow (message_comments.h), then what
/// `codes` name; errors stay.  A comment of the main program, or of a file that messages are of,
/// which allowed nothing in a completed run is a note itself (PRB326).
/// @param program  the path of the main program
/// @param codes    of warnings and notes
/// @param sources  of the programs that ran
Heard heard(runtime::Outcome outcome, ProgramComments& comments, const std::string& program,
            const std::vector<std::string>& codes, const source::SourceMap& sources);

}  // namespace g31::session
