#include "interpreter/dialects/fanuc/text/scanner.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "interpreter/syntax/decimal.h"
#include "interpreter/syntax/tree.h"
#include "machine/base/utf_8.h"

namespace g31::fanuc {
namespace {

constexpr bool is_letter(char c) {
  return c >= 'A' && c <= 'Z';
}

/// What a plain word and its end need behind the place where it begins: a letter, a sign, digits, a
/// point, digits, a blank, a line end and another character.
constexpr std::size_t kWordRoom = 2 + 2 * syntax::kFewDigits + 5;

/// Whether a character, behind a word or the blank that follows it, belongs to something else.
constexpr auto kEndsWord = [] {
  std::array<bool, 256> ends{};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ends[i] = is_letter(kShown[i]) || kShown[i] == '\n';
  }
  return ends;
}();

/// Steps over a blank, and over the CR of a line end.  @returns whether nothing that would belong
/// to a number follows: a digit or a point behind a blank would
bool ends_plainly(const char* text, std::size_t& at) {
  at += text[at] == ' ' ? 1U : 0U;
  if (kEndsWord[static_cast<unsigned char>(text[at])]) [[likely]] {
    return true;
  }
  at += text[at] == '\r' ? 1U : 0U;
  return text[at] == '\n';
}

/// @param written  digits, perhaps a point and, between them, what counts for nothing
double value_of_many_digits(std::string_view written) {
  std::string plain;
  for (const char c : written) {
    if (is_digit(c) || c == '.') {
      plain.push_back(c);
    }
  }
  double value = 0.0;
  const auto end = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (end.ec == std::errc::result_out_of_range) {
    const bool is_large = plain.find_first_not_of('0') < plain.find('.');
    return is_large ? std::numeric_limits<double>::max() : 0.0;
  }
  return value;
}

}  // namespace

std::string why_no_word(std::string_view text, char next) {
  if (is_digit(next)) {
    return "a block begins with an address letter, but this is a digit (0 instead of the letter "
           "O?)";
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return "this file is UTF-16: save it as ASCII or UTF-8";
  }
  return fmt::format("{} cannot begin a word", source::quoted(next));
}

std::string_view letter_o_hint(char next) {
  return next == 'O' ? " (the letter O instead of 0?)" : "";
}

std::string digit_count(std::uint8_t digits) {
  return fmt::format("{} digits{}", digits, digits == 255 ? " or more" : "");
}

[[gnu::hot]] char Scanner::peek_behind_blanks() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (counts_for_nothing(c)) {
      ++at_;
    } else if (c == '(') {
      skip_comment();
    } else if (c == ')' && comment_.end != 0) {
      ++at_;  // ends a comment nested in the last one: comments do not nest, but people write so
    } else if (c == '%') {
      return ends_tape(at_) ? '\n' : c;
    } else {
      return c == ')' ? c : kShown[static_cast<unsigned char>(c)];
    }
  }
  return '\n';
}

void Scanner::skip_comment() {
  const std::size_t begin = at_ + 1;
  std::size_t end = begin;
  while (end < text_.size() && text_[end] != ')' && text_[end] != '\n') {
    ++end;
  }
  const bool goes_on =
      comment_.end != 0 && at_ >= comment_.end &&
      text_.substr(comment_.end, at_ - comment_.end).find_first_not_of(") \t\r") == text_.npos;
  if (!goes_on) {
    comment_ = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }
  at_ = end < text_.size() && text_[end] == ')' ? end + 1 : end;
}

bool Scanner::accept(char expected) {
  if (peek() != expected) {
    return false;
  }
  step();
  return true;
}

/// A % with nothing behind it on its line.
bool Scanner::ends_tape(std::size_t percent) const {
  const std::size_t next = first_that_counts(text_, percent + 1);
  return next >= text_.size() || text_[next] == '\n';
}

void Scanner::skip_leader() {
  if (text_.starts_with(kByteOrderMark)) {
    at_ = kByteOrderMark.size();
  }
  const std::size_t begin = at_;
  const auto at_percent = [this] { return at_ < text_.size() && text_[at_] == '%'; };
  while (at_ < text_.size() && peek() == '\n' && !at_percent()) {
    skip_block();
  }
  at_ = at_percent() ? std::min(text_.find('\n', at_), text_.size() - 1) + 1 : begin;
  comment_ = {};
}

[[gnu::hot]] bool Scanner::at_tape_end() const {
  const std::size_t next = first_that_counts(text_, at_);
  return next < text_.size() && text_[next] == '%';
}

void Scanner::skip_rest_of_block() {
  comment_ = {};
  while (peek() != '\n') {
    step();
  }
  if (at_ >= text_.size() || text_[at_] == '%') {
    comment_ = {};
    return;
  }
  // A `;` and the end of its line end one block, not two.
  const std::size_t next =
      text_[at_] == ';' ? first_that_counts(text_, at_ + 1) : std::string_view::npos;
  at_ = next < text_.size() && text_[next] == '\n' ? next + 1 : at_ + 1;
  comment_ = {};
}

/// Whether digits or the first point follow, perhaps behind blanks, which are stepped over.
bool Scanner::number_goes_on(bool has_point) {
  const char next = peek();
  return is_digit(next) || (next == '.' && !has_point);
}

std::optional<ScannedNumber> Scanner::number() {
  const char first = peek();
  if (!is_digit(first) && first != '.') {
    return std::nullopt;
  }
  const std::size_t begin = at_;
  std::uint64_t mantissa = 0;  // of no use beyond syntax::kExactDigits
  int digits = 0;
  int before_point = 0;
  bool has_point = false;
  std::size_t end = at_;
  for (bool goes_on = true; goes_on; goes_on = number_goes_on(has_point)) {
    std::size_t at = at_;  // kept out of memory while digits follow
    syntax::take_digits(text_, at, mantissa);
    digits += static_cast<int>(at - at_);
    at_ = at;
    if (at_ < text_.size() && text_[at_] == '.' && !has_point) {
      has_point = true;
      before_point = digits;
      ++at_;
    }
    end = at_;
  }
  at_ = end;  // what stands behind it is no part of it
  if (digits == 0) {
    rewind(static_cast<std::uint32_t>(begin));
    return std::nullopt;
  }
  const int decimals = has_point ? digits - before_point : 0;
  const double value = digits <= syntax::kExactDigits
                           ? syntax::decimal(mantissa, decimals)
                           : value_of_many_digits(text_.substr(begin, at_ - begin));
  // Made where the caller reads it: a copy would wait for the four stores.
  return std::optional<ScannedNumber>(
      std::in_place, value, static_cast<std::uint8_t>(std::min(digits, 255)),
      static_cast<std::uint8_t>(std::min(decimals, 255)), has_point);
}

[[gnu::hot]] std::int32_t Scanner::plain_integer() {
  constexpr std::size_t kMostDigits = 8;
  if (at_ + kWordRoom > text_.size()) {
    return -1;
  }
  const char* const text = text_.data() + at_;
  std::uint64_t number = 0;
  const std::size_t digits = syntax::take_few_digits(text, number);
  std::size_t end = digits;
  if (digits == 0 || digits > kMostDigits || !ends_plainly(text, end)) {
    return -1;
  }
  at_ += end;
  return static_cast<std::int32_t>(number);
}

bool Scanner::begins_plainly(std::int32_t& sequence) {
  const std::size_t begin = at_;
  if (at_ + kWordRoom <= text_.size() && kShown[static_cast<unsigned char>(text_[at_])] == 'N') {
    ++at_;
    if (const std::int32_t number = plain_integer(); number >= 0) {
      sequence = number;
    } else {
      at_ = begin;
      return false;
    }
  }
  if (at_ + kWordRoom <= text_.size()) {
    const char letter = kShown[static_cast<unsigned char>(text_[at_])];
    const char next = text_[at_ + 1];
    if (is_letter(letter) && letter != 'O' && (is_digit(next) || next == '-' || next == '.')) {
      return true;
    }
  }
  at_ = begin;
  return false;
}

[[gnu::hot]] PlainWords Scanner::plain_words(std::vector<syntax::Word>& words) {
  constexpr double kSigns[] = {1.0, -1.0};
  PlainWords all;
  const std::string_view whole = text_;  // what is looked at is kept out of memory
  std::size_t at = at_;
  while (at + kWordRoom <= whole.size()) {
    const char* const text = whole.data() + at;
    const char letter = kShown[static_cast<unsigned char>(*text)];
    if (!is_letter(letter)) {
      break;
    }
    const std::size_t sign = text[1] == '-' ? 1U : 0U;
    std::uint64_t mantissa = 0;
    std::size_t end = 1 + sign;
    std::size_t digits = syntax::take_few_digits(text + end, mantissa);
    std::size_t decimals = 0;
    end += digits;
    const bool has_point = text[end] == '.';
    if (has_point) {
      ++end;
      decimals = syntax::take_few_digits(text + end, mantissa);
      end += decimals;
      digits += decimals;
    }
    const std::size_t length = end;
    if (digits == 0 || digits > syntax::kExactDigits || !ends_plainly(text, end)) {
      break;
    }
    const double value = syntax::decimal(mantissa, static_cast<int>(decimals));
    syntax::Word& word = words.emplace_back();  // a copy would wait for its parts
    all.letters |= syntax::letter_bit(letter);
    all.digits |= static_cast<std::uint32_t>(digits);
    word.letter = letter;
    word.form = has_point ? syntax::ValueForm::Decimal : syntax::ValueForm::Integer;
    word.digits = static_cast<std::uint8_t>(digits);
    word.decimals = static_cast<std::uint8_t>(decimals);
    word.number = value * kSigns[sign];  // no branch: signs are not to be foretold
    word.span = {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + length)};
    at += end;
  }
  at_ = at;
  return all;
}

char Scanner::corner_address() {
  const std::size_t comma = at_;
  step();
  const char letter = peek();
  if (letter == 'C' || letter == 'R') {
    step();
    return letter == 'C' ? syntax::kChamferWord : syntax::kRoundingWord;
  }
  at_ = comma;
  return '\0';
}

std::string_view Scanner::letters() {
  std::size_t count = 0;
  for (char c = peek(); is_letter(c) && count < sizeof letters_; c = peek()) {
    letters_[count++] = c;
    step();
  }
  return {letters_, count};
}

syntax::ShortSpan Scanner::name() {
  const auto counts = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  peek();
  const std::uint32_t begin = position();
  while (at_ < text_.size() && counts(kShown[static_cast<unsigned char>(text_[at_])])) {
    ++at_;
  }
  return {begin, position()};
}

bool Scanner::accept_word(std::string_view word) {
  const std::uint32_t begin = position();
  for (const char expected : word) {
    if (peek() != expected) {
      rewind(begin);
      return false;
    }
    step();
  }
  return true;
}

}  // namespace g31::fanuc
