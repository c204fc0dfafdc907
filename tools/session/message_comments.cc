#include "tools/session/message_comments.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "interpreter/source/readable_text.h"
#include "machine/base/letters.h"

namespace g31::session {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::size_t kMostOfALine = 20;
constexpr std::size_t kLongestShown = 1000;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  const std::size_t end = text.find_last_not_of(kBlanks);
  return end == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

/// Takes a word in capitals off the front of a text, which may have it in small letters.
bool take(std::string_view& text, std::string_view word) {
  const bool is_there =
      text.size() >= word.size() && in_capitals(text.substr(0, word.size())) == word;
  if (is_there) {
    text = trimmed(text.substr(word.size()));
  }
  return is_there;
}

/// Letters and three digits: PRB301, NC003.
bool is_code(std::string_view word) {
  constexpr std::size_t kDigits = 3;
  const auto is_letter = [](char c) { return c >= 'A' && c <= 'Z'; };
  return word.size() > kDigits && std::all_of(word.begin(), word.end() - kDigits, is_letter) &&
         std::all_of(word.end() - kDigits, word.end(), is_digit);
}

/// Takes the word in the place of a code off the front of a text, and the comma behind it.
std::string take_named(std::string_view& text, bool& has_comma) {
  const std::size_t end = std::min(text.find_first_of(", \t\r"), text.size());
  std::string word(text.substr(0, end));
  text = trimmed(text.substr(end));
  has_comma = text.starts_with(',');
  if (has_comma) {
    text = trimmed(text.substr(1));
  }
  return word;
}

struct Comment {
  std::size_t begin = 0;   ///< in bytes of the line
  std::size_t length = 0;  ///< with what marks it as a comment
  std::string_view text;
};

/// A line, its comments apart.
struct Line {
  std::string_view text;  ///< the whole of it
  std::string block;      ///< what is no comment
  std::vector<Comment> comments;
};

Line split(std::string_view text, CommentForm form) {
  Line line;
  line.text = text;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    is_quoted = is_quoted != (form == CommentForm::Semicolon && text[i] == '"');
    if (form == CommentForm::Parentheses && text[i] == '(') {
      const std::size_t end = std::min(text.find(')', i), text.size());
      const std::size_t behind = std::min(end + 1, text.size());
      line.comments.push_back({i, behind - i, text.substr(i + 1, end - i - 1)});
      i = end;
    } else if (form == CommentForm::Semicolon && text[i] == ';' && !is_quoted) {
      line.comments.push_back({i, text.size() - i, text.substr(i + 1)});
      break;
    } else {
      line.block += text[i];
    }
  }
  return line;
}

/// Whether a line has a block: %, the number of a program and the header of a file are none.
bool has_block(const Line& line, CommentForm form) {
  const std::string_view block = trimmed(line.block);
  if (block.empty() || block.front() == '%') {
    return false;
  }
  const bool is_head = form == CommentForm::Parentheses && block.size() > 1 &&
                       (block.front() == 'O' || block.front() == ':') &&
                       std::ranges::all_of(block.substr(1), is_digit);
  return !is_head;
}

/// Takes what a comment asks for off the front of its text.
std::optional<MessageComment::Verb> take_verb(std::string_view& text) {
  if (!take(text, kMessageCommentMark)) {
    return std::nullopt;
  }
  if (take(text, "ALLOW")) {
    return MessageComment::Verb::Allow;
  }
  if (take(text, "DISABLE") && take(text, "=")) {
    return MessageComment::Verb::Disable;
  }
  return std::nullopt;
}

/// The codes of a comment, each as a comment of its own; where there is none, one that says so.
std::vector<MessageComment> with_codes(MessageComment::Verb verb, std::string_view rest) {
  std::vector<MessageComment> found;
  bool has_comma = false;
  std::string_view behind = rest;
  do {
    rest = behind;
    MessageComment comment;
    comment.verb = verb;
    comment.named = take_named(behind, has_comma);
    const std::string code = in_capitals(comment.named);
    const bool is_expected = found.empty() || has_comma;
    comment.code = is_code(code) ? code : "";
    if (comment.code.empty() && !is_expected) {
      break;
    }
    if (!comment.code.empty()) {
      rest = behind;
    }
    found.push_back(std::move(comment));
  } while (!found.back().code.empty() && !behind.empty());
  for (MessageComment& comment : found) {
    comment.reason = rest;
  }
  return found;
}

/// What a line's comments ask for; the lines they are for are still to be said.
std::vector<MessageComment> asking(const Line& line) {
  std::vector<MessageComment> found;
  for (const Comment& comment : line.comments) {
    std::string_view rest = trimmed(comment.text);
    const auto verb = take_verb(rest);
    if (!verb) {
      continue;
    }
    for (MessageComment& one : with_codes(*verb, rest)) {
      if (found.size() == kMostOfALine) {
        return found;
      }
      one.column = source::column_in(line.text, comment.begin);
      one.begin = comment.begin;
      one.length = comment.length;
      found.push_back(std::move(one));
    }
  }
  return found;
}

}  // namespace

CommentForm comment_form(const Control& control) {
  return std::holds_alternative<FanucControl>(control) ? CommentForm::Parentheses
                                                       : CommentForm::Semicolon;
}

std::string_view last_comment(std::string_view line, CommentForm form) {
  const std::vector<Comment> comments = split(line, form).comments;
  const bool is_last = !comments.empty() &&
                       trimmed(line.substr(comments.back().begin + comments.back().length)).empty();
  return is_last ? trimmed(comments.back().text) : std::string_view();
}

bool has_message_comment_mark(std::string_view piece) {
  constexpr std::size_t kLength = kMessageCommentMark.size();
  for (std::size_t colon = piece.find(':'); colon != std::string_view::npos;
       colon = piece.find(':', colon + 1)) {
    if (colon + 1 >= kLength &&
        in_capitals(piece.substr(colon + 1 - kLength, kLength)) == kMessageCommentMark) {
      return true;
    }
  }
  return false;
}

std::vector<MessageComment> message_comments(std::string_view program, CommentForm form) {
  constexpr int kLast = std::numeric_limits<int>::max();
  std::vector<MessageComment> all;
  if (!has_message_comment_mark(program)) {
    return all;
  }
  std::size_t waiting = 0;  // from here on they are for the next block
  bool is_before_first = true;
  int number = 0;
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    std::string_view text = program.substr(begin, end - begin);
    text = text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
    ++number;
    const Line line = split(text, form);
    const bool is_block = has_block(line, form);
    for (MessageComment& comment : asking(line)) {
      comment.line = number;
      comment.text = text.size() <= kLongestShown ? text : std::string_view();
      comment.begin += begin;
      comment.first_line = is_before_first && !is_block ? 1 : number;
      comment.last_line = is_before_first && !is_block ? kLast : number;
      all.push_back(std::move(comment));
    }
    if (is_before_first && !is_block) {
      waiting = all.size();
    }
    if (is_block) {
      for (; waiting < all.size(); ++waiting) {
        all[waiting].first_line = all[waiting].last_line = number;
      }
      is_before_first = false;
    }
    begin = end + 1;
  }
  return all;
}

}  // namespace g31::session
