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
  syntax::ShortSpan where;
  double number = 0.0;
  /// Names and letters in upper case; digits of an integer; of a string what stands in the quotes.
  std::string_view text;

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

/// Cuts one block after the other into tokens.
///
/// A letter before a digit is an address: `G1X10` is four tokens.  Names begin with two letters, _
/// or $.  `'HFF'` and `'B101'` are integers of 32 bits, 10EX3 is 10000.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  /// The tokens of one block, an End at the end.  What is malformed (a string without its end, a
  /// constant of too many digits) is an Unknown token; who parses says so.
  ///
  /// What tokens say lives as long as the text or, of names, until the next block is scanned.
  void scan(syntax::ShortSpan block, std::vector<Token>& tokens);

 private:
  [[nodiscard]] char look(std::size_t ahead) const {
    return at_ + ahead < end_ ? text_[at_ + ahead] : '\0';
  }
  void next(char c);
  Token& add(TokenKind kind, std::size_t begin);
  void number();
  bool exponent(double& value);
  void word(char first);
  void string();
  void coded_number();
  void symbol();
  std::string_view in_upper_case(std::size_t begin, std::size_t end);

  std::string_view text_;
  std::string upper_;  ///< the block in upper case, as far as it has names in lower case
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  std::vector<Token>* tokens_ = nullptr;
};

}  // namespace g31::sinumerik
