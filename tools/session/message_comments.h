#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/session/control.h"

namespace g31::session {

/// How a dialect writes comments.
enum class CommentForm : std::uint8_t {
  Parentheses,  ///< (...), of Fanuc
  Semicolon,    ///< ; to the end of the line, of SINUMERIK
};

CommentForm comment_form(const Control& control);

/// The comment that a line ends in, without what marks it and blanks about it; "": none.
std::string_view last_comment(std::string_view line, CommentForm form);

/// A comment that says which message nobody wants to hear: `(g31: allow PRB301 reason)` of a run,
/// `(g31: disable=NC003 reason)` of `g31 check`.
struct MessageComment {
  enum class Verb : std::uint8_t { Allow, Disable };

  Verb verb = Verb::Allow;
  std::string code;    ///< letters and three digits, in capitals; "": the comment names none
  std::string named;   ///< what stands in the place of the code, as written; may be empty
  std::string reason;  ///< what stands behind the codes; may be empty
  int line = 0;        ///< where the comment stands, from 1
  int column = 0;      ///< the same, in characters
  std::string text;    ///< of that line; empty where it has more than 1,000 bytes
  /// The whole comment, in bytes of the program.
  std::size_t begin = 0;
  std::size_t length = 0;
  /// The lines it is for: its own; alone on a line the next one with a block; before the first
  /// block of the file all of them.
  int first_line = 0;
  int last_line = 0;
};

/// What such a comment begins with, in capitals.
inline constexpr std::string_view kMessageCommentMark = "G31:";

/// Whether a piece of a program may have such a comment: hardly a long program has one.
bool has_message_comment_mark(std::string_view piece);

/// The comments of a program, in their order; one with several codes is several.  Letters count the
/// same small and in capitals.  Of a line the first 20 count.
std::vector<MessageComment> message_comments(std::string_view program, CommentForm form);

}  // namespace g31::session
