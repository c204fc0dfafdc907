#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/syntax/tree.h"
#include "machine/base/rounding.h"
#include "machine/units/length_unit.h"

namespace g31::fanuc {

/// A word with its value worked out, which `number` is whatever its form; vacant ones are not among
/// them (MB-083).
using EvaluatedWord = syntax::Word;

/// Whether the code of a word calls a program, which a name behind it may say.
constexpr bool calls_program(const syntax::Word& word) {
  const bool is_written =
      word.form == syntax::ValueForm::Integer || word.form == syntax::ValueForm::Decimal;
  return is_written && ((word.letter == 'G' &&
                         (word.number == 65.0 || word.number == 66.0 || word.number == 66.1)) ||
                        (word.letter == 'M' && (word.number == 98.0 || word.number == 198.0)));
}

/// Of a Haas: M96 P Q goes on at a block of the program itself where an input is off, M97 P calls
/// one.
inline constexpr int kJumpByInput = 96;
inline constexpr int kLocalCall = 97;

/// A bit for each of some addresses.
constexpr std::uint32_t letters_of(std::string_view letters) {
  std::uint32_t bits = 0;
  for (const char letter : letters) {
    bits |= syntax::letter_bit(letter);
  }
  return bits;
}

/// The words of one block: all in order, and the last of each letter (MB-014).
class BlockWords {
 public:
  void clear() {
    words_.clear();
    shown_ = {};
    present_ = 0;
    sequence_ = -1;
  }
  /// N of the block; -1: it has none.
  void set_sequence(int number) { sequence_ = number; }
  [[nodiscard]] int sequence() const { return sequence_; }
  void add(const EvaluatedWord& word) { add(word, word.number); }
  /// These words and no others, which stay where they are: they must outlive the block.
  /// @param letters  a bit for each of their addresses
  void show(std::span<const EvaluatedWord> words, std::uint32_t letters) {
    present_ = letters;
    shown_ = words;
    for (std::size_t place = 0; place < words.size(); ++place) {
      note(words[place].letter, place);
    }
  }
  /// A word as the program has it, with the value worked out.
  void add(const syntax::Word& word, double number) {
    note(word.letter, words_.size());
    present_ |= syntax::letter_bit(word.letter);
    words_.push_back(word);
    words_.back().number = number;
  }
  /// Those that `keeps` says yes to, without N.
  template <typename Keeps>
  [[nodiscard]] BlockWords only(Keeps keeps) const {
    BlockWords kept;
    for (const EvaluatedWord& word : all()) {
      if (keeps(word)) {
        kept.add(word);
      }
    }
    return kept;
  }
  [[nodiscard]] bool has(char letter) const { return (present_ >> (letter - 'A') & 1U) != 0; }
  [[nodiscard]] bool has_any(std::uint32_t letters) const { return (present_ & letters) != 0; }
  [[nodiscard]] const EvaluatedWord* find(char letter) const {
    return has(letter) ? &all()[last_[static_cast<std::size_t>(letter - 'A')]] : nullptr;
  }
  [[nodiscard]] std::span<const EvaluatedWord> all() const {
    return shown_.empty() ? std::span(words_) : shown_;
  }

 private:
  void note(char letter, std::size_t place) {
    last_[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint16_t>(place);
  }

  std::vector<EvaluatedWord> words_;
  std::span<const EvaluatedWord> shown_;  // in the place of words_
  std::array<std::uint16_t, syntax::kLetterCount> last_{};
  std::uint32_t present_ = 0;
  int sequence_ = -1;
};

namespace detail {

inline constexpr double kPlainPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5};

/// Whether a number of so many decimals is on the grid of 1/counts, a power of ten.
inline bool is_on_grid(std::size_t decimals, double counts) {
  return decimals < std::size(kPlainPowers) && kPlainPowers[decimals] <= counts;
}

/// How far a decimal fraction may stand off its count: a few ulp of the scaled number.
inline double guard(double scaled) {
  return std::max(1.0, std::abs(scaled)) * 8.0 * std::numeric_limits<double>::epsilon();
}

/// A little farther from zero, by the guard.
inline double guarded(double scaled) {
  return scaled + std::copysign(guard(scaled), scaled);
}

}  // namespace detail

/// How the control reads the number of a word: least increment, decimal point, unit in force.
struct WordScale {
  double counts_per_mm = 1000.0;  ///< least increments in a millimetre (IS-B)
  double counts_per_inch = 10000.0;
  double counts_per_degree = 1000.0;
  bool calculator_point = false;  ///< 3401.0: a number without point counts mm
  ExcessDecimals excess_decimals = ExcessDecimals::Truncate;
  LengthUnit unit = LengthUnit::Millimetre;

  /// "IS-A" (0.01 mm), "IS-B" (0.001 mm) or "IS-C" (0.0001 mm).
  void set_increment_system(std::string_view name);

  [[nodiscard]] double mm_per_unit() const { return mm_per(unit); }
  [[nodiscard]] double length_counts() const {
    return unit == LengthUnit::Inch ? counts_per_inch : counts_per_mm;
  }

  /// A length word in the unit in force.
  [[nodiscard]] double length(const EvaluatedWord& word) const {
    return scaled(word, length_counts());
  }
  /// A length word in mm.
  [[nodiscard]] double length_mm(const EvaluatedWord& word) const {
    return length(word) * mm_per_unit();
  }
  /// A rotary axis word in degrees.
  [[nodiscard]] double angle_deg(const EvaluatedWord& word) const {
    return scaled(word, counts_per_degree);
  }
  /// Seconds of X or U in G04.
  [[nodiscard]] double seconds(const EvaluatedWord& word) const { return scaled(word, 1000.0); }

  bool operator==(const WordScale&) const = default;

 private:
  [[nodiscard]] double scaled(const EvaluatedWord& word, double counts) const {
    // Of plain words nearly all: the rest need not be where these are read.
    return word.form == syntax::ValueForm::Decimal ? scaled_decimal(word, counts)
                                                   : scaled_other(word, counts);
  }
  [[nodiscard]] double scaled_decimal(const EvaluatedWord& word, double counts) const {
    if (detail::is_on_grid(word.decimals, counts)) {
      return word.number;
    }
    const double far = detail::guarded(word.number * counts);
    return (excess_decimals == ExcessDecimals::Round ? rounded(far) : truncated(far)) / counts;
  }
  [[nodiscard]] double scaled_other(const EvaluatedWord& word, double counts) const;
};

/// Rounds to a multiple of 1/counts, halves away from zero.  The scaled value is judged with a
/// small guard, so that 1.2345 at 1000 counts is 1.235 though its double lies below (MB-023).
double round_to_counts(double value, double counts);

/// Nearest integer of a computed integer word; halves away from zero (MB-026).
int nearest_integer(double value);

}  // namespace g31::fanuc
