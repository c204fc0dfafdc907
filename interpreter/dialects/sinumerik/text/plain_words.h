#pragma once

#include <string_view>

#include "interpreter/syntax/tree.h"

namespace g31::sinumerik {

/// A letter and a number at once, G1.
struct PlainWord {
  char letter = ' ';     ///< in upper case
  bool is_code = false;  ///< digits only, nine at most
  double value = 0.0;
};

/// Reads a block that has nothing but such words, as nearly all of a long program have: no tokens
/// are made for it.
class PlainWords {
 public:
  enum class Read {
    Word,
    End,    ///< of the block, or its comment
    Other,  ///< something else; the Scanner knows
  };

  /// @param block  of `text`
  PlainWords(std::string_view text, syntax::ShortSpan block)
      : text_(text.substr(0, block.end)), at_(block.begin) {}

  Read next();
  /// What next() has read.
  [[nodiscard]] const PlainWord& word() const { return word_; }
  /// From the first word to the last one.
  [[nodiscard]] syntax::ShortSpan where() const { return where_; }

 private:
  void skip_blanks();

  std::string_view text_;
  std::size_t at_;
  PlainWord word_;
  syntax::ShortSpan where_;
};

}  // namespace g31::sinumerik
