#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/syntax/tree.h"

namespace g31::sinumerik {

enum class TokenKind : std::uint8_t {
  End,      ///< of the block; a comment ends it as well
  Integer,  ///< without point and exponent
  Real,
  Text,    ///< "..."
  Letter,  ///< one letter that a number, = or ( follows: an address
  Name,    ///< two letters at least, or a leading _ or $
  Symbol,
  Unknown,  ///< a character of no use
};

enum class Symbol : std::uint8_t {
  None,
  LeftParen,
  RightParen,
  LeftBracket,
  RightBracket,
  Comma,
  Assign,
  Plus,
  Minus,
  Times,
  Slash,
  Colon,
  Equal,
  NotEqual,
  Less,
  Greater,
  LessEqual,
  GreaterEqual,
  Concat,
};

struct Token {
  TokenKind kind = TokenKind::End;
  Symbol symbol = Symbol::None;
  double number = 0.0;
  /// Names and letters in upper case; digits of an integer; of a string what stands in the quotes.
  std::string text;
  syntax::ShortSpan where;

  [[nodiscard]] bool is(Symbol wanted) const {
    return kind == TokenKind::Symbol && symbol == wanted;
  }
  [[nodiscard]] bool is_name(std::string_view wanted) const {
    return kind == TokenKind::Name && text == wanted;
  }
  [[nodiscard]] bool is_letter(char wanted) const {
    return kind == TokenKind::Letter && text.front() == wanted;
  }
};

/// The tokens of one block, an End at the end.  What is malformed (a string without its end, a
/// constant of too many digits) is an Unknown token; who parses says so.
///
/// A letter before a digit is an address: `G1X10` is four tokens.  Names begin with two letters, _
/// or $.  `'HFF'` and `'B101'` are integers of 32 bits, 10EX3 is 10000.
void scan_block(std::string_view text, syntax::ShortSpan block, std::vector<Token>& tokens);

}  // namespace g31::sinumerik
