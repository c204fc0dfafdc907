#include "tools/session/allow_comments.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "machine/base/letters.h"

namespace g31::session {
namespace {

constexpr std::string_view kBlanks = " \t\r";

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

/// Takes a code, three letters and three digits, off the front of a text.
std::string take_code(std::string_view& text) {
  constexpr std::size_t kLetters = 3;
  constexpr std::size_t kLength = 6;
  std::string code = in_capitals(text.substr(0, kLength));
  const bool is_code = code.size() == kLength &&
                       std::all_of(code.begin(), code.begin() + kLetters,
                                   [](char c) { return c >= 'A' && c <= 'Z'; }) &&
                       std::all_of(code.begin() + kLetters, code.end(), is_digit) &&
                       (text.size() == kLength || text[kLength] == ',' ||
                        kBlanks.find(text[kLength]) != kBlanks.npos);
  if (!is_code) {
    return {};
  }
  text = trimmed(text.substr(kLength));
  if (text.starts_with(',')) {
    text = trimmed(text.substr(1));
  }
  return code;
}

struct Comment {
  std::size_t column = 0;  ///< from 0
  std::string_view text;
};

/// A line, its comments apart.
struct Line {
  std::string block;  ///< what is no comment
  std::vector<Comment> comments;
};

Line split(std::string_view text, CommentForm form) {
  Line line;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    is_quoted = is_quoted != (form == CommentForm::Semicolon && text[i] == '"');
    if (form == CommentForm::Parentheses && text[i] == '(') {
      const std::size_t end = std::min(text.find(')', i), text.size());
      line.comments.push_back({i, text.substr(i + 1, end - i - 1)});
      i = end;
    } else if (form == CommentForm::Semicolon && text[i] == ';' && !is_quoted) {
      line.comments.push_back({i, text.substr(i + 1)});
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

/// What of a line's comments allows something; the lines they are for are still to be said.
std::vector<AllowComment> allowing(const Line& line) {
  std::vector<AllowComment> found;
  for (const Comment& comment : line.comments) {
    std::string_view rest = trimmed(comment.text);
    if (!take(rest, "G31:") || !take(rest, "ALLOW")) {
      continue;
    }
    const std::size_t first = found.size();
    do {
      found.push_back({});
      found.back().code = take_code(rest);
      found.back().column = static_cast<int>(comment.column) + 1;
    } while (!found.back().code.empty());
    if (found.size() - first > 1) {
      found.pop_back();  // behind the last code
    }
    std::for_each(found.begin() + static_cast<std::ptrdiff_t>(first), found.end(),
                  [&](AllowComment& allow) { allow.reason = rest; });
  }
  return found;
}

}  // namespace

std::vector<AllowComment> allow_comments(std::string_view program, CommentForm form) {
  constexpr int kLast = std::numeric_limits<int>::max();
  std::vector<AllowComment> all;
  std::size_t waiting = 0;  // from here on they are for the next block
  bool is_before_first = true;
  int number = 0;
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string_view text = program.substr(0, end);
    program.remove_prefix(std::min(end + 1, program.size()));
    ++number;
    const Line line = split(text, form);
    const bool is_block = has_block(line, form);
    for (AllowComment& allow : allowing(line)) {
      allow.line = number;
      allow.text = text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
      allow.first_line = is_before_first && !is_block ? 1 : number;
      allow.last_line = is_before_first && !is_block ? kLast : number;
      all.push_back(std::move(allow));
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
  }
  return all;
}

}  // namespace g31::session
