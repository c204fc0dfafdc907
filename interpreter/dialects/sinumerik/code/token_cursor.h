#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/text/scanner.h"

namespace g31::sinumerik {

/// The tokens of a block, read one after the other.  The last one is the end of the block, and
/// stays the next one for ever.
class TokenCursor {
 public:
  /// To be filled and changed before the block is read; never left empty.
  std::vector<Token>& tokens() { return tokens_; }
  /// Before the first token.
  void rewind() { at_ = 0; }
  /// Before a token that place() told.
  void go_back_to(std::size_t place) { at_ = place; }

  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  const Token& next() {
    const Token& token = peek();
    at_ = std::min(at_ + 1, tokens_.size() - 1);
    return token;
  }
  /// @returns whether the next token was this one; then it has been read
  bool accept(Symbol symbol) { return skip_if(peek().is(symbol), 1); }
  bool accept_name(std::string_view name) { return skip_if(peek().is_name(name), 1); }
  bool skip_if(bool condition, std::size_t count) {
    at_ += condition ? count : 0;
    return condition;
  }

  /// How many have been read, and the one that was read as number `place`, from 0.
  [[nodiscard]] std::size_t place() const { return at_; }
  [[nodiscard]] const Token& at(std::size_t place) const { return tokens_[place]; }
  /// The last one that was read.
  [[nodiscard]] const Token& previous() const { return tokens_[at_ - 1]; }
  /// From the one at a place to the last one that was read.
  [[nodiscard]] syntax::ShortSpan span_from(std::size_t place) const {
    return {tokens_[place].where.begin, previous().where.end};
  }

 private:
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

}  // namespace g31::sinumerik
