#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "interpreter/analysis/fanuc_constants.h"
#include "interpreter/dialects/fanuc/code/word_limits.h"

namespace g31::analysis {

/// What is wrong with a block's words, and where; nullopt: nothing, or only a run knows.
using WrongWord = std::optional<WrongConstant>;

/// The words of an NC block, as far as their numbers stand in the text.
class KnownWords {
 public:
  KnownWords(std::span<const syntax::Word> words, const fanuc::Profile& profile);

  [[nodiscard]] const fanuc::BlockWords& words() const { return words_; }
  [[nodiscard]] bool stands(char letter) const { return words_.has(letter) || is_open(letter); }
  /// Whether a number is computed: its word may even disappear.
  [[nodiscard]] bool is_open(char letter) const { return is_any_open(syntax::letter_bit(letter)); }
  [[nodiscard]] bool is_any_open(std::uint32_t letters) const { return (open_ & letters) != 0; }
  /// nullptr: the block has no such word, or its number is computed.
  [[nodiscard]] const fanuc::EvaluatedWord* find(char letter) const {
    return is_open(letter) ? nullptr : words_.find(letter);
  }

  [[nodiscard]] static WrongWord at(fanuc::MaybeWrong wrong, const fanuc::EvaluatedWord& word);
  /// An integer that `limit` of word_limits.h judges.
  template <typename Limit>
  [[nodiscard]] WrongWord integer(char letter, Limit limit) const {
    const fanuc::EvaluatedWord* const word = find(letter);
    if (word == nullptr) {
      return std::nullopt;
    }
    return fanuc::is_integer(*word, profile_)
               ? at(limit(fanuc::nearest_integer(word->number)), *word)
               : at(fanuc::point_in(*word), *word);
  }

 private:
  const fanuc::Profile& profile_;
  fanuc::BlockWords words_;
  std::uint32_t open_ = 0;
};

/// What the code that takes a block's words for itself says of their numbers.
/// @param whole  the block
WrongWord wrong_for_code(const fanuc::GCode& code, const KnownWords& words, syntax::ShortSpan whole,
                         const fanuc::Profile& profile);

}  // namespace g31::analysis
