#include "interpreter/analysis/fanuc_points.h"

#include <cmath>

#include <fmt/format.h>

namespace g31::analysis {
namespace {

using fanuc::EvaluatedWord;
using fanuc::GAction;

bool is_in(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

/// "0.01 (under G20 0.001)"
std::string reading_of(const EvaluatedWord& word, const fanuc::Profile& profile,
                       const fanuc::WordScale& scale) {
  const bool is_feed = word.letter == 'F';
  const double by_mm = is_feed ? profile.feed_counts.per_mm : scale.counts_per_mm;
  const double by_inch = is_feed ? profile.feed_counts.per_inch : scale.counts_per_inch;
  return is_in("ABC", word.letter)
             ? fmt::format("{}", word.number / scale.counts_per_degree)
             : fmt::format("{} (under G20 {})", word.number / by_mm, word.number / by_inch);
}

}  // namespace

std::string_view letters_with_point(const fanuc::GCode* acting, bool drills) {
  const GAction action = acting != nullptr ? acting->action : GAction::Motion;
  if (action == GAction::SetData || action == GAction::Scaling || action == GAction::TiltedPlane ||
      action == GAction::Unsimulated || action == GAction::Refused || action == GAction::Dwell) {
    return "F";
  }
  return drills ? "ABCFIJRUVWXYZ" : "ABCFIJKRUVWXYZ";
}

std::vector<LostPoint> lost_points(const fanuc::BlockWords& words, std::string_view letters,
                                   const fanuc::Profile& profile, const PointReading& reading) {
  constexpr double kFewest = 1000.0;  // 1 mm of IS-B
  constexpr double kSlowest = 10'000.0;
  std::vector<LostPoint> found;
  for (const EvaluatedWord& word : words.all()) {
    const bool is_feed = word.letter == 'F';
    const bool is_small = std::abs(word.number) < (is_feed ? kSlowest : kFewest);
    const bool counts = reading.counts_increments && (!is_feed || profile.feed_counts.per_mm > 1.0);
    if (word.form == syntax::ValueForm::Integer && word.number != 0.0 && is_small && counts &&
        is_in(letters, word.letter)) {
      const std::string written = fmt::format("{}{}", word.letter, word.number);
      found.push_back(
          {word.span,
           fmt::format("{} without a decimal point is {}", written,
                       reading_of(word, profile, reading.scale)),
           fmt::format("write {}. where that is meant; where the machine reads it so, its sheet "
                       "says it: [control.parameters] \"3401.0\" = 1",
                       written)});
    }
  }
  return found;
}

}  // namespace g31::analysis
