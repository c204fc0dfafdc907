#include "probe/metrology/circle_expectation.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "probe/metrology/circle_rest.h"

namespace g31::metrology {
namespace {

/// Of a piece, at either end: its middle is half of it at least.
constexpr double kLongestShare = 0.25;
/// Times the scatter: normal numbers are hardly beyond.
constexpr double kWithin = 4.0;
/// Of the radius; less is no scatter.
constexpr double kLeastScatter = 1e-11;

/// The samples of a piece as the errors leave them.
struct Residuals {
  std::vector<double> way;         // from the first sample, rad
  std::vector<double> off;         // mm
  std::vector<bool> is_described;  // by the model
  std::size_t first = 0;           // of the middle
  std::size_t last = 0;
};

/// The first sample at such a way or beyond, and the last one before it or there.
std::size_t first_at(const std::vector<double>& way, double at) {
  const auto found = std::ranges::find_if(way, [&](double here) { return here >= at; });
  return std::min(static_cast<std::size_t>(found - way.begin()), way.size() - 1);
}
std::size_t last_at(const std::vector<double>& way, double at) {
  const auto found =
      std::find_if(way.rbegin(), way.rend(), [&](double here) { return here <= at; });
  return found == way.rend() ? 0 : static_cast<std::size_t>(way.rend() - found) - 1;
}

/// The middle of the way between two samples.
std::pair<std::size_t, std::size_t> middle_of(const std::vector<double>& way, double longest,
                                              std::size_t begin, std::size_t end) {
  const double from = way[begin];
  const double to = way[end - 1];
  const double margin = std::min(longest, kLongestShare * (to - from));
  const std::size_t first = first_at(way, from + margin);
  return {first, std::max(first, last_at(way, to - margin))};
}

/// @param known  a part of the piece, whose middle counts
Residuals residuals_of(const PlaneSamples& samples, const CircleTurn& turn, const CircleTurn& known,
                       const CircleErrors& errors, const ReversalWindows& windows) {
  Residuals all;
  const CircleResidual residual(errors, turn);
  double way = 0.0;
  double before = turn.from;
  for (std::size_t i = turn.begin; i < turn.end; ++i) {
    samples.look();
    const double angle = angle_about(errors.centre, samples.at(i));
    way += i > turn.begin ? shorter_way(turn.direction * (angle - before)) : 0.0;
    before = angle;
    const PlaceOnTurn place = place_on_turn(turn, way, angle);
    all.way.push_back(way);
    all.off.push_back(residual.at(samples.at(i)));
    all.is_described.push_back(metrology::is_described(place, windows));
  }
  std::tie(all.first, all.last) =
      middle_of(all.way, kLongestLead, known.begin - turn.begin, known.end - turn.begin);
  return all;
}

void widen(std::optional<ResidualBand>& band, double off) {
  band = band ? ResidualBand{std::min(band->least, off), std::max(band->greatest, off)}
              : ResidualBand{off, off};
}

double middle_size(std::vector<double>& values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Tells whether residuals are as expected.
class Judge {
 public:
  Judge(const Expectation& expectation, const Residuals& all)
      : expectation_(expectation), all_(all) {}

  [[nodiscard]] bool is_expected(std::size_t i, double more) const {
    const ResidualBand& band =
        all_.is_described[i] ? expectation_.described : expectation_.at_reversals;
    return all_.off[i] >= band.least - more && all_.off[i] <= band.greatest + more;
  }
  /// From where on the samples before the middle are, about as far as `least`; what comes back
  /// behind a reversal is a spike.
  [[nodiscard]] std::size_t begin_of(std::size_t least, double more) const {
    std::size_t begin = all_.first;
    while (begin > least) {
      std::size_t next = begin - 1;
      while (next > 0 && is_at_reversal(next, more)) {
        --next;
      }
      if (!is_expected(next, more)) {
        break;
      }
      begin = next;
    }
    const std::size_t tip = begin - 1;
    while (begin > least && begin < all_.first && !is_back(begin, tip)) {
      ++begin;
    }
    return begin;
  }
  /// The same behind the middle.
  [[nodiscard]] std::size_t last_of(std::size_t most, double more) const {
    std::size_t last = all_.last;
    while (last < most) {
      std::size_t next = last + 1;
      while (next + 1 < all_.off.size() && is_at_reversal(next, more)) {
        ++next;
      }
      if (!is_expected(next, more)) {
        break;
      }
      last = next;
    }
    const std::size_t tip = last + 1;
    while (last < most && last > all_.last && !is_back(last, tip)) {
      --last;
    }
    return last;
  }

 private:
  /// Whether the path is further off than expected, and may be back behind the reversal.
  [[nodiscard]] bool is_at_reversal(std::size_t i, double more) const {
    return !all_.is_described[i] && !is_expected(i, more);
  }
  /// Whether the path that is off at `tip` is back on the circle.
  [[nodiscard]] bool is_back(std::size_t i, std::size_t tip) const {
    return std::abs(all_.off[i]) <= expectation_.scatter || all_.off[i] * all_.off[tip] < 0.0;
  }

  const Expectation& expectation_;
  const Residuals& all_;
};

}  // namespace

CircleTurn core_of(const PlaneSamples& samples, const CircleTurn& turn, const Circle& circle,
                   double margin) {
  std::vector<double> way = {0.0};
  const auto angle_at = [&](std::size_t i) { return angle_about(circle.centre, samples.at(i)); };
  double before = angle_at(turn.begin);
  for (std::size_t i = turn.begin + 1; i < turn.end; ++i) {
    const double angle = angle_at(i);
    way.push_back(way.back() + shorter_way(turn.direction * (angle - before)));
    before = angle;
  }
  const auto [first, last] = middle_of(way, margin, 0, way.size());
  return part_of(samples, circle, turn, turn.begin + first, turn.begin + last + 1);
}

Expectation expectation_of(const PlaneSamples& samples, const std::vector<CircleTurn>& parts,
                           const CircleErrors& errors, const ReversalWindows& windows) {
  std::optional<ResidualBand> described;
  std::optional<ResidualBand> at_reversals;
  std::vector<double> sizes;
  for (const CircleTurn& part : parts) {
    const Residuals all = residuals_of(samples, part, part, errors, windows);
    for (std::size_t i = all.first; i <= all.last; ++i) {
      widen(all.is_described[i] ? described : at_reversals, all.off[i]);
      if (all.is_described[i]) {
        sizes.push_back(std::abs(all.off[i]));
      }
    }
  }
  constexpr double kDeviationByMedian = 1.4826;  // of the sizes of normal numbers
  Expectation expectation{
      errors,
      windows,
      described.value_or(ResidualBand()),
      {},
      std::max(kDeviationByMedian * middle_size(sizes), kLeastScatter * errors.radius)};
  const double more = kWithin * expectation.scatter;
  expectation.described.least -= more;
  expectation.described.greatest += more;
  const ResidualBand seen = at_reversals.value_or(expectation.described);
  const double width = seen.greatest - seen.least;
  expectation.at_reversals = {
      std::min(expectation.described.least, seen.least - 0.5 * width - more),
      std::max(expectation.described.greatest, seen.greatest + 0.5 * width + more)};
  return expectation;
}

std::optional<CircleTurn> expected_part(const PlaneSamples& samples, const CircleTurn& turn,
                                        const CircleTurn& known, const Expectation& expectation,
                                        const Growth& growth) {
  const Residuals all = residuals_of(samples, turn, known, expectation.errors, expectation.windows);
  const Judge judge(expectation, all);
  std::size_t off = 0;
  for (std::size_t i = all.first; i <= all.last; ++i) {
    off += judge.is_expected(i, growth.more) ? 0U : 1U;
  }
  if (2 * off > all.last + 1 - all.first) {
    return std::nullopt;
  }
  const Circle circle{expectation.errors.centre, expectation.errors.radius};
  const RestAllowances rest = rest_allowances(samples, turn, all.way, circle);
  const double from = all.way[known.begin - turn.begin] - growth.angle;
  const double to = all.way[known.end - 1 - turn.begin] + growth.angle;
  const std::size_t begin = judge.begin_of(first_at(all.way, from), growth.more + rest.start);
  const std::size_t last = judge.last_of(last_at(all.way, to), growth.more + rest.stop);
  return part_of(samples, circle, turn, turn.begin + begin, turn.begin + last + 1);
}

}  // namespace g31::metrology
