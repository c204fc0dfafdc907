#include "interpreter/analysis/fanuc_points.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/vocabulary/argument_letters.h"
#include "interpreter/dialects/fanuc/vocabulary/fine_feed.h"

namespace g31::analysis {
namespace {

using fanuc::EvaluatedWord;
using fanuc::GAction;

constexpr std::string_view kLengths = "IJKRUVWXYZ";
constexpr std::string_view kDirections = "IJK";

bool is_in(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

/// What a whole number counts: so many to a unit, metric and under G20, and below how many units it
/// is hardly meant.
struct Counts {
  double per_unit;
  double per_inch_unit;
  double least = 1.0;
};

std::optional<Counts> counts_of_feed(const fanuc::Profile& profile, const PointReading& reading) {
  constexpr double kSlowest = 10.0;
  const fanuc::FeedCounts& counts =
      reading.has_fine_feed ? fanuc::kFineFeedCounts : profile.feed_counts;
  return counts.per_mm > 1.0 ? std::optional(Counts{counts.per_mm, counts.per_inch, kSlowest})
                             : std::nullopt;
}

class Reader {
 public:
  Reader(const PointedBlock& block, const fanuc::Profile& profile, const PointReading& reading)
      : block_(block),
        action_(block.acting != nullptr ? block.acting->action : GAction::Motion),
        profile_(profile),
        reading_(reading) {}

  /// nullopt: the letter's whole numbers are what they are.
  [[nodiscard]] std::optional<Counts> counts(char letter) const {
    const bool is_feed = letter == 'F' || (letter == 'E' && block_.calls);
    if (is_feed) {
      const bool is_counted = !block_.calls || profile_.counts_feed_arguments;
      return is_counted ? counts_of_feed(profile_, reading_) : std::nullopt;
    }
    const fanuc::WordScale& scale = reading_.scale;
    const Counts length{scale.counts_per_mm, scale.counts_per_inch};
    const Counts angle{scale.counts_per_degree, scale.counts_per_degree};
    if (block_.calls) {
      return is_in(fanuc::kIncrementArguments, letter) ? std::optional(length) : std::nullopt;
    }
    if (is_in("ABC", letter)) {
      return takes_lengths() ? std::optional(angle) : std::nullopt;
    }
    if (action_ == GAction::Dwell) {
      return is_in("UX", letter) ? std::optional(Counts{1000.0, 1000.0, 0.1}) : std::nullopt;
    }
    const bool is_plane = action_ == GAction::TiltedPlane;
    if ((letter == 'R' && (is_plane || action_ == GAction::Rotation)) ||
        (is_plane && is_in(kDirections, letter))) {
      return angle;
    }
    if (letter == 'R' && action_ == GAction::Skip && profile_.skip_takes_r) {
      return std::nullopt;
    }
    if (letter == 'Q' && block_.drills) {
      constexpr double kLeastPeck = 0.1;  // without a point by custom
      return Counts{scale.counts_per_mm, scale.counts_per_inch, kLeastPeck};
    }
    // Beside a tapping cycle ,R is no length either.
    const bool is_corner =
        !block_.drills && (letter == syntax::kChamferWord || letter == syntax::kRoundingWord);
    const bool is_length = is_corner || is_in(kLengths, letter);
    // In a cycle I, J and K are counts and multiples, too.
    const bool is_of_cycle = block_.drills && is_in("IJK", letter);
    const bool is_of_data = action_ == GAction::SetData && is_in("IJK", letter);
    return is_length && takes_lengths() && !is_of_cycle && !is_of_data ? std::optional(length)
                                                                       : std::nullopt;
  }

 private:
  [[nodiscard]] bool takes_lengths() const {
    return action_ != GAction::Scaling && action_ != GAction::Unsimulated &&
           action_ != GAction::Refused && action_ != GAction::Dwell;
  }

  const PointedBlock& block_;
  GAction action_;
  const fanuc::Profile& profile_;
  const PointReading& reading_;
};

/// Whether K may be how often a canned cycle in force drills: nothing else in the block is of an
/// arc.
bool may_repeat(const fanuc::BlockWords& words) {
  const auto is_arc = [](const EvaluatedWord& word) {
    return word.letter == 'G' && (word.number == 2.0 || word.number == 3.0);
  };
  return !words.has_any(fanuc::letters_of("IJ")) && std::ranges::none_of(words.all(), is_arc);
}

/// Whether I, J and K are a direction, and written alike: what they count makes no difference.
bool are_one_direction(const fanuc::BlockWords& words, const fanuc::GCode* acting) {
  constexpr double kVectors = 3.0;
  const EvaluatedWord* const p = words.find('P');
  const bool is_direction =
      acting != nullptr &&
      (acting->action == GAction::Rotation ||
       (acting->action == GAction::TiltedPlane && p != nullptr && p->number == kVectors));
  return is_direction && std::ranges::none_of(words.all(), [](const EvaluatedWord& word) {
           return is_in(kDirections, word.letter) && word.form != syntax::ValueForm::Integer;
         });
}

bool has_inches(const fanuc::Profile& profile) {
  return fanuc::find_g_code(20.0, profile) != nullptr;
}

/// "0.01 (under G20 0.001)"
std::string reading_of(double number, const Counts& counts, const fanuc::Profile& profile) {
  const double value = number / counts.per_unit;
  const double in_inches = number / counts.per_inch_unit;
  return value == in_inches || !has_inches(profile)
             ? fmt::format("{}", value)
             : fmt::format("{} (under G20 {})", value, in_inches);
}

}  // namespace

std::vector<LostPoint> lost_points(const fanuc::BlockWords& words, const PointedBlock& block,
                                   const fanuc::Profile& profile, const PointReading& reading) {
  std::vector<LostPoint> found;
  if (!reading.counts_increments) {
    return found;
  }
  const Reader reader(block, profile, reading);
  const bool is_direction = are_one_direction(words, block.acting);
  for (const EvaluatedWord& word : words.all()) {
    const bool is_whole = word.form == syntax::ValueForm::Integer && word.number != 0.0;
    const bool is_count = word.letter == 'K' && !block.calls && may_repeat(words);
    const bool is_of_direction = is_direction && is_in(kDirections, word.letter);
    const auto counts =
        is_whole && !is_count && !is_of_direction ? reader.counts(word.letter) : std::nullopt;
    if (counts && std::abs(word.number) / counts->per_unit < counts->least) {
      const std::string written =
          fmt::format("{}{}", syntax::letter_text(word.letter), word.number);
      found.push_back(
          {word.span,
           fmt::format("{} without a decimal point is {}", written,
                       reading_of(word.number, *counts, profile)),
           fmt::format("write {}. where that is meant; where the machine reads it so, its sheet "
                       "says it: [parameters] \"3401.0\" = 1",
                       written)});
    }
  }
  return found;
}

bool is_in_increments(const syntax::Tree& tree, const PointReading& reading) {
  bool has_long_ones = false;
  for (const syntax::Word& word : tree.words) {
    if (is_in(kLengths, word.letter)) {
      if (word.form == syntax::ValueForm::Decimal) {
        return false;
      }
      has_long_ones |= word.form == syntax::ValueForm::Integer &&
                       std::abs(word.number) >= reading.scale.counts_per_mm;
    }
  }
  return has_long_ones;
}

}  // namespace g31::analysis
