#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Outside comments (MB-008).
constexpr bool counts_for_nothing(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\0';
}

/// The place of the first character from `at` on that counts; the end of the text: there is none.
constexpr std::size_t first_that_counts(std::string_view text, std::size_t at) {
  while (at < text.size() && counts_for_nothing(text[at])) {
    ++at;
  }
  return at;
}

/// What Scanner::peek shows of a character: letters as upper case; 0 where it has to look closer,
/// at blanks and comments.
inline constexpr auto kShown = [] {
  std::array<char, 256> shown{};
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto c = static_cast<char>(static_cast<unsigned char>(i));
    const bool is_lower = c >= 'a' && c <= 'z';
    const bool needs_care =
        c == ' ' || c == '\t' || c == '\r' || c == '\0' || c == '(' || c == ')' || c == '%';
    shown[i] = needs_care ? '\0'
               : is_lower ? static_cast<char>(c - 'a' + 'A')
               : c == ';' ? '\n'
                          : c;
  }
  return shown;
}();

/// A number as it is written, without sign.
struct ScannedNumber {
  ScannedNumber(double number, std::uint8_t all, std::uint8_t behind_point, bool point)
      : value(number), digits(all), decimals(behind_point), has_point(point) {}

  double value;
  std::uint8_t digits;    ///< digits written, capped at 255
  std::uint8_t decimals;  ///< those behind the point, capped at 255
  bool has_point;
};

/// Why a text cannot begin a block here.  @param next  what stands there
std::string why_no_word(std::string_view text, char next);

/// Behind a message, where a letter O stands in the place of a digit perhaps; else "".
std::string_view letter_o_hint(char next);

/// For messages: how many digits ScannedNumber::digits counted.
std::string digit_count(std::uint8_t digits);

/// What plain words have in common.
struct PlainWords {
  std::uint32_t letters = 0;  ///< a bit for each address, A is the lowest
  std::uint32_t digits = 0;   ///< all counts of digits in one (or): no count is larger
};

/// A cursor over the text of one file, one block at a time: a line, or what a `;` ends, as manuals
/// print the end of a block.  Blanks, tabs, CR and NUL count
/// for nothing outside comments (MB-008), comments are stepped over and remembered.
class Scanner {
 public:
  /// @param text must outlive the scanner and be shorter than 4 GiB
  explicit Scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] std::uint32_t position() const { return static_cast<std::uint32_t>(at_); }
  [[nodiscard]] bool at_end_of_text() const { return at_ >= text_.size(); }

  /// The next character that counts, or '\n' at the end of the block; letters as upper case.
  char peek() {
    for (; at_ < text_.size(); ++at_) {
      const char shown = kShown[static_cast<unsigned char>(text_[at_])];
      if (shown != '\0') [[likely]] {
        return shown;
      }
      if (text_[at_] != ' ') {
        break;
      }
    }
    return peek_behind_blanks();
  }

  /// Steps over the character that peek() showed.
  void step() { ++at_; }

  /// Steps over the address that begins with `next`, which peek() showed: a letter, `/`, or the two
  /// characters of ,C and ,R.  @returns it as syntax::Word has it; 0: none begins here
  char address(char next) {
    if ((next >= 'A' && next <= 'Z') || next == '/') [[likely]] {
      ++at_;
      return next;
    }
    return next == ',' ? corner_address() : '\0';
  }

  /// Steps over `expected` if it is next.
  bool accept(char expected);

  /// Steps over what stands before the first block: empty lines and the line of the first %.
  void skip_leader();
  /// Whether a block would begin with %, which ends the tape.
  [[nodiscard]] bool at_tape_end() const;
  /// Whether the end of the line is next, without anything before it.
  [[nodiscard]] bool at_line_end() const { return at_ < text_.size() && text_[at_] == '\n'; }
  /// Steps over the rest of the block and its end, unless the tape ends.
  void skip_block() {
    if (at_line_end()) [[likely]] {
      comment_ = {};
      ++at_;
    } else {
      skip_rest_of_block();
    }
  }
  /// Moves back to a place that position() gave.
  void rewind(std::uint32_t position) { at_ = position; }

  /// A number without sign, or nullopt where none begins.
  std::optional<ScannedNumber> number();

  /// Steps over words as nearly every block of a long program has them, and appends them: an
  /// address and its number without anything between them, one blank behind them at most, numbers
  /// that are exact, and some text behind them.  It ends before the first one that is otherwise.
  PlainWords plain_words(std::vector<syntax::Word>& words);

  /// Whether a block begins, perhaps behind N and its number, which are stepped over then, with a
  /// word that plain_words() may read and that is no O.
  /// @param sequence  the number behind N; it stays as it is where there is none
  bool begins_plainly(std::int32_t& sequence);

  /// Steps over a whole number of eight digits at most that ends its word as plain_words() has it.
  /// @returns -1: there is none, and nothing is stepped over
  std::int32_t plain_integer();

  /// The run of letters that begins here, upper case, at most 8 of them; empty where none begins.
  std::string_view letters();

  /// Steps over a name of letters, digits and underscores, without blanks.  @returns its place,
  /// empty where none begins
  syntax::ShortSpan name();

  /// Steps over `word` if the next letters begin with it.
  bool accept_word(std::string_view word);

  /// The last comment stepped over in this block, without its parentheses, or the first of the last
  /// run of comments; empty span if none.
  [[nodiscard]] syntax::ShortSpan last_comment() const { return comment_; }
  void forget_comment() { comment_ = {}; }

  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  char peek_behind_blanks();
  void skip_rest_of_block();
  char corner_address();
  [[nodiscard]] bool ends_tape(std::size_t percent) const;
  bool number_goes_on(bool has_point);
  void skip_comment();

  std::string_view text_;
  std::size_t at_ = 0;
  syntax::ShortSpan comment_;
  char letters_[8] = {};
};

}  // namespace g31::fanuc
