#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace g31::session {

/// How a dialect writes comments.
enum class CommentForm : std::uint8_t {
  Parentheses,  ///< (...), of Fanuc
  Semicolon,    ///< ; to the end of the line, of SINUMERIK
};

/// A comment that says which message nobody wants to hear: `(g31: allow PRB301 reason)`.
struct AllowComment {
  std::string code;    ///< in capitals; "": the comment names none
  std::string reason;  ///< what stands behind the codes; may be empty
  int line = 0;        ///< where the comment stands, from 1
  int column = 0;
  std::string text;  ///< of that line
  /// The lines it is for: its own; alone on a line the next one with a block; before the first
  /// block of the file all of them.
  int first_line = 0;
  int last_line = 0;
};

/// The comments of a program, in their order; one with several codes is several.  Letters count the
/// same small and in capitals.
std::vector<AllowComment> allow_comments(std::string_view program, CommentForm form);

}  // namespace g31::session
