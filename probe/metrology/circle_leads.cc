#include "probe/metrology/circle_leads.h"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "probe/metrology/circle_expectation.h"
#include "probe/metrology/circle_ranges.h"

namespace g31::metrology {
namespace {

constexpr int kMostRounds = 30;
constexpr double kGrowth = 10.0 * kDegree;
/// So much of the radius the form of what is not fitted yet may be off, and that of ends at last.
constexpr double kUnknownForm = 2e-4;
constexpr double kFormOfEnds = 2e-5;
constexpr std::size_t kEnough = 50'000;

/// Every so many-th sample of a record.
class Thinned {
 public:
  explicit Thinned(const PlaneSamples& samples)
      : watch_(samples.watch), stride_(samples.size() / kEnough + 1) {
    for (std::size_t i = 0; i < samples.size(); i += stride_) {
      t_.push_back(samples.t[i]);
      x_.push_back(samples.x[i]);
      y_.push_back(samples.y[i]);
    }
  }

  [[nodiscard]] PlaneSamples samples() const { return {t_, x_, y_, watch_}; }
  /// A turn by the samples that are left of it.
  [[nodiscard]] CircleTurn thinned(CircleTurn turn) const {
    turn.begin = (turn.begin + stride_ - 1) / stride_;
    turn.end = (turn.end + stride_ - 1) / stride_;
    return turn;
  }
  /// The samples of a turn of which a part of those left is kept.
  [[nodiscard]] std::pair<std::size_t, std::size_t> range(const CircleTurn& turn,
                                                          const CircleTurn& kept) const {
    const CircleTurn all = thinned(turn);
    return {kept.begin == all.begin ? turn.begin : kept.begin * stride_,
            kept.end == all.end ? turn.end : (kept.end - 1) * stride_ + 1};
  }

 private:
  machine::WorkWatch* watch_;
  std::size_t stride_;
  std::vector<double> t_;
  std::vector<double> x_;
  std::vector<double> y_;
};

/// A piece of a record that tells what the circle is, and how much of it is known to lie on it.
struct Piece {
  std::size_t turn = 0;  ///< index into the turns
  CircleTurn whole;
  CircleTurn kept;
};

/// The piece of the reach that most of a turn lies in; nullptr: none.
const CircleTurn* piece_around(const std::vector<CircleTurn>& reach, const CircleTurn& turn) {
  const CircleTurn* around = nullptr;
  std::size_t most = 0;
  for (const CircleTurn& piece : reach) {
    const std::size_t begin = std::max(piece.begin, turn.begin);
    const std::size_t end = std::min(piece.end, turn.end);
    if (piece.direction == turn.direction && end > begin + most) {
      around = &piece;
      most = end - begin;
    }
  }
  return around;
}

/// How far a turn may reach.  Between two that reach each other half of the way is of either.
CircleTurn reach_of(const PlaneSamples& samples, const FoundCircle& found, std::size_t k) {
  const CircleTurn& turn = found.turns[k];
  const CircleTurn* const around = piece_around(found.reach, turn);
  if (around == nullptr) {
    return turn;
  }
  std::size_t begin = around->begin;
  std::size_t end = around->end;
  if (k > 0 && piece_around(found.reach, found.turns[k - 1]) == around) {
    begin = (found.turns[k - 1].end + turn.begin) / 2;
  }
  if (k + 1 < found.turns.size() && piece_around(found.reach, found.turns[k + 1]) == around) {
    end = (turn.end + found.turns[k + 1].begin) / 2;
  }
  return part_of(samples, found.circle, turn, begin, end);
}

/// Short pieces may be ways to the circle: they do not count if there are enough others.
std::vector<Piece> pieces_of(const Thinned& thinned, const std::vector<CircleTurn>& turns,
                             const std::vector<CircleTurn>& reaches) {
  constexpr double kShort = 60.0 * kDegree;
  constexpr std::size_t kFewestSamples = 12;
  double angle = 0.0;
  for (const CircleTurn& turn : turns) {
    angle += turn.angle >= kShort ? turn.angle : 0.0;
  }
  const double least = angle >= std::numbers::pi ? kShort : 0.0;
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const CircleTurn whole = thinned.thinned(reaches[k]);
    CircleTurn known = thinned.thinned(turns[k]);
    known.begin = std::max(known.begin, whole.begin);
    known.end = std::min(known.end, whole.end);
    if (known.angle >= least && known.end >= known.begin + kFewestSamples) {
      pieces.push_back({k, whole, known});
    }
  }
  return pieces;
}

/// Fits the errors of the machine to what is kept.
class Fitting {
 public:
  Fitting(const PlaneSamples& samples, const CircleTask& task)
      : samples_(samples), task_(task), windows_(first_windows(task.start.radius)) {
    task_.stride = 1;
  }

  /// What they lead to expect of cores of the pieces, as large as a fit needs them.
  std::optional<Expectation> first_expectation(std::vector<Piece>& pieces) {
    const std::vector<Piece> all = pieces;
    for (double margin = kLongestLead; margin > -kGrowth; margin -= kGrowth) {
      for (std::size_t k = 0; k < all.size(); ++k) {
        pieces[k].kept = core_of(samples_, all[k].kept, {task_.start.centre, task_.start.radius},
                                 std::max(margin, 0.0));
      }
      if (auto found = expectation(pieces)) {
        return found;
      }
    }
    return std::nullopt;
  }

  /// The same of what is kept; nullopt: that is too little.
  std::optional<Expectation> expectation(std::vector<Piece>& pieces) {
    std::vector<CircleTurn> kept;
    std::ranges::transform(pieces, std::back_inserter(kept), &Piece::kept);
    const auto ranges =
        described_ranges(samples_, kept, task_.start.centre, windows_, Ends::Fitted);
    const auto fit = fit_circle(samples_, kept, ranges, task_);
    if (!fit) {
      return std::nullopt;
    }
    task_.start = fit->errors;
    refine_speeds(samples_, ranges, fit->errors, kept);
    for (std::size_t k = 0; k < kept.size(); ++k) {
      pieces[k].kept.omega = pieces[k].whole.omega = kept[k].omega;
    }
    windows_ = reversal_windows(samples_, kept, *fit);
    return expectation_of(samples_, kept, fit->errors, windows_);
  }

 private:
  const PlaneSamples& samples_;
  CircleTask task_;
  ReversalWindows windows_;
};

/// Takes as much of each piece as is expected; true: it is the same as before.
bool take_expected(const PlaneSamples& samples, const Expectation& expectation,
                   const Growth& growth, std::vector<Piece>& pieces) {
  bool is_same = true;
  std::vector<Piece> taken;
  for (const Piece& piece : pieces) {
    const auto part = expected_part(samples, piece.whole, piece.kept, expectation, growth);
    is_same = is_same && part && part->begin == piece.kept.begin && part->end == piece.kept.end;
    if (part) {
      taken.push_back({piece.turn, piece.whole, *part});
    }
  }
  pieces = std::move(taken);
  return is_same;
}

/// Whether the pieces are all as they let expect.
bool is_all_expected(const PlaneSamples& samples, const CircleTask& task, const Growth& growth,
                     std::vector<Piece> pieces) {
  for (Piece& piece : pieces) {
    piece.whole = piece.kept;
  }
  const auto expectation = Fitting(samples, task).expectation(pieces);
  return expectation && take_expected(samples, *expectation, growth, pieces);
}

/// Lets the pieces grow, at first as far as any form may be off, then less: from all of them where
/// they have no leads, else from their cores, which tell less.
std::optional<Expectation> grow(const PlaneSamples& samples, const CircleTask& task,
                                std::vector<Piece>& pieces) {
  Growth growth{kGrowth, kUnknownForm * task.start.radius};
  const double at_last = kFormOfEnds * task.start.radius;
  Fitting fitting(samples, task);
  auto expectation = is_all_expected(samples, task, growth, pieces)
                         ? fitting.expectation(pieces)
                         : fitting.first_expectation(pieces);
  auto last = expectation;
  for (int round = 0; round < kMostRounds && expectation; ++round) {
    last = expectation;
    if (take_expected(samples, *expectation, growth, pieces)) {
      if (growth.more == at_last) {
        break;
      }
      growth.more = at_last;
    }
    expectation = fitting.expectation(pieces);
  }
  return last;
}

/// Adds a part of a record, to the one before where that ends there.
void add_part(const PlaneSamples& samples, const Circle& circle, const CircleTurn& part,
              std::vector<CircleTurn>& parts) {
  if (!parts.empty() && parts.back().end == part.begin &&
      parts.back().direction == part.direction) {
    parts.back() = part_of(samples, circle, parts.back(), parts.back().begin, part.end);
  } else {
    parts.push_back(part);
  }
}

}  // namespace

std::vector<CircleTurn> without_leads(const PlaneSamples& samples, const FoundCircle& found,
                                      const CircleTask& task) {
  const Thinned thinned(samples);
  std::vector<CircleTurn> reaches;
  for (std::size_t k = 0; k < found.turns.size(); ++k) {
    reaches.push_back(reach_of(samples, found, k));
  }
  std::vector<Piece> pieces = pieces_of(thinned, found.turns, reaches);
  const std::vector<Piece> telling = pieces;
  const auto expectation = grow(thinned.samples(), task, pieces);
  if (!expectation) {
    return found.turns;
  }
  const Circle circle{expectation->errors.centre, expectation->errors.radius};
  std::vector<CircleTurn> kept;
  for (std::size_t k = 0; k < found.turns.size(); ++k) {
    if (const auto piece = std::ranges::find(pieces, k, &Piece::turn); piece != pieces.end()) {
      const auto [begin, end] = thinned.range(reaches[k], piece->kept);
      add_part(samples, circle, part_of(samples, circle, piece->kept, begin, end), kept);
    } else if (std::ranges::find(telling, k, &Piece::turn) == telling.end()) {
      const CircleTurn& turn = found.turns[k];
      if (const auto part = expected_part(samples, turn, turn, *expectation,
                                          {0.0, kFormOfEnds * circle.radius})) {
        kept.push_back(*part);
      }
    }
  }
  return kept;
}

}  // namespace g31::metrology
