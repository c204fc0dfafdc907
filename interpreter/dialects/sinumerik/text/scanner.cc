#include "interpreter/dialects/sinumerik/text/scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "interpreter/dialects/sinumerik/text/digits.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "machine/base/utf_8.h"

namespace g31::sinumerik {
namespace {

struct SymbolRow {
  std::string_view text;
  Symbol symbol;
};

// Longer ones first.
constexpr SymbolRow kSymbols[] = {
    {"==", Symbol::Equal},        {"<>", Symbol::NotEqual},   {"<=", Symbol::LessEqual},
    {">=", Symbol::GreaterEqual}, {"<<", Symbol::Concat},     {"<", Symbol::Less},
    {">", Symbol::Greater},       {"=", Symbol::Assign},      {"(", Symbol::LeftParen},
    {")", Symbol::RightParen},    {"[", Symbol::LeftBracket}, {"]", Symbol::RightBracket},
    {",", Symbol::Comma},         {"+", Symbol::Plus},        {"-", Symbol::Minus},
    {"*", Symbol::Times},         {"/", Symbol::Slash},       {":", Symbol::Colon},
};

/// Control characters count as blanks, and so does &.
constexpr bool is_blank(char c) {
  return (c >= '\0' && c <= ' ') || c == '\x7F' || c == '&';
}

constexpr bool is_name_character(char c) {
  return is_letter(c) || is_digit(c) || c == '$';
}

}  // namespace

void Scanner::scan(syntax::ShortSpan block, std::vector<Token>& tokens) {
  tokens.clear();
  tokens_ = &tokens;
  at_ = block.begin;
  end_ = block.end;
  upper_.clear();
  upper_.reserve(end_ - at_);  // names stay where they are written first
  while (at_ < end_ && text_[at_] != ';') {
    const char c = text_[at_];
    if (is_blank(c)) {
      ++at_;
    } else {
      next(c);
    }
  }
  add(TokenKind::End, at_);
}

Token& Scanner::add(TokenKind kind, std::size_t begin) {
  Token& token = tokens_->emplace_back();
  token.kind = kind;
  token.where = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
  return token;
}

void Scanner::next(char c) {
  if (is_digit(c) || (c == '.' && is_digit(look(1)))) {
    number();
  } else if (c == '$' && (look(1) == '$' || (upper(look(1)) == 'R' && is_digit(look(2))))) {
    ++at_;  // $$AC_PARAM and $R1 in synchronised actions: as they count in the main run
  } else if (is_letter(c) || c == '$') {
    word(c);
  } else if (c == '"') {
    string();
  } else if (c == '\'') {
    coded_number();
  } else {
    symbol();
  }
}

void Scanner::number() {
  const std::size_t begin = at_;
  const Digits digits = digits_at(text_.substr(0, end_), begin);
  at_ = digits.end;
  double value = 0.0;
  bool right = digits.points <= 1;
  if (digits.are_exact(begin)) {
    value = digits.value();
  } else {
    const auto read = std::from_chars(text_.data() + begin, text_.data() + at_, value);
    right = right && read.ec == std::errc() && read.ptr == text_.data() + at_;
  }
  bool whole = digits.points == 0;
  if (upper(look(0)) == 'E' && upper(look(1)) == 'X') {
    at_ += 2;
    right = exponent(value) && right;
    whole = false;
  }
  const bool fits = !whole || value <= 2147483647.0;
  Token& token = add(!right          ? TokenKind::Unknown
                     : whole && fits ? TokenKind::Integer
                                     : TokenKind::Real,
                     begin);
  token.number = value;
  if (token.kind == TokenKind::Integer) {
    token.text = text_.substr(begin, at_ - begin);
  }
}

bool Scanner::exponent(double& value) {
  const bool negative = look(0) == '-';
  at_ += negative || look(0) == '+' ? 1U : 0U;
  int power = 0;
  const auto read = std::from_chars(text_.data() + at_, text_.data() + end_, power);
  at_ = static_cast<std::size_t>(read.ptr - text_.data());
  value *= std::pow(10.0, negative ? -power : power);
  return read.ec == std::errc() && std::isfinite(value);
}

void Scanner::word(char first) {
  const std::size_t begin = at_;
  const char second = look(1);
  const bool is_address = is_letter(first) && first != '_' && !is_letter(second) && second != '$';
  ++at_;
  while (!is_address && is_name_character(look(0))) {
    ++at_;
  }
  add(is_address ? TokenKind::Letter : TokenKind::Name, begin).text = in_upper_case(begin, at_);
}

/// A piece of the text: as it stands, when it has no small letters.
std::string_view Scanner::in_upper_case(std::size_t begin, std::size_t end) {
  const std::string_view written = text_.substr(begin, end - begin);
  if (std::ranges::all_of(written, [](char c) { return upper(c) == c; })) {
    return written;
  }
  const std::size_t first = upper_.size();
  for (const char c : written) {
    upper_.push_back(upper(c));
  }
  return std::string_view(upper_).substr(first);
}

void Scanner::string() {
  const std::size_t begin = at_;
  const std::size_t end = text_.substr(0, end_).find('"', begin + 1);
  at_ = end == text_.npos ? end_ : end + 1;
  Token& token = add(end == text_.npos ? TokenKind::Unknown : TokenKind::Text, begin);
  token.text = text_.substr(begin + 1, at_ - begin - (end == text_.npos ? 1 : 2));
}

/// 'HFF' and 'B101'
void Scanner::coded_number() {
  const std::size_t begin = at_;
  const std::size_t end = text_.substr(0, end_).find('\'', begin + 1);
  const char kind = upper(look(1));
  at_ = end == text_.npos ? end_ : end + 1;
  std::uint32_t bits = 0;
  bool right = end != text_.npos && (kind == 'H' || kind == 'B') && end > begin + 2;
  if (right) {
    const char* const last = text_.data() + end;
    const auto read = std::from_chars(text_.data() + begin + 2, last, bits, kind == 'H' ? 16 : 2);
    right = read.ec == std::errc() && read.ptr == last;
  }
  Token& token = add(right ? TokenKind::Integer : TokenKind::Unknown, begin);
  token.number = static_cast<double>(static_cast<std::int32_t>(bits));
}

void Scanner::symbol() {
  const std::size_t begin = at_;
  const std::string_view rest = text_.substr(at_, end_ - at_);
  for (const SymbolRow& row : kSymbols) {
    if (rest.front() == row.text.front() && rest.starts_with(row.text)) {
      at_ += row.text.size();
      add(TokenKind::Symbol, begin).symbol = row.symbol;
      return;
    }
  }
  const auto [length, is_character] = utf_8_piece(rest);
  at_ += is_character ? length : 1;
  add(TokenKind::Unknown, begin);
}

}  // namespace g31::sinumerik
