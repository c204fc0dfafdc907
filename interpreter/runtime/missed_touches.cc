#include "interpreter/runtime/missed_touches.h"

#include <algorithm>
#include <cmath>

namespace g31::runtime {
namespace {

/// A variable of more moves than these is told all the same, through those that it knows.
constexpr std::size_t kMostMoves = 64;

/// Values this near to each other are the same place: the end of a way is compared with some play.
constexpr double kSamePlaceMm = 0.5;
/// What is less than any increment of a control, 0 apart, is no length: it tidies up the results of
/// sums.
constexpr double kLeastLength = 5e-7;

bool is_length(double value) {
  return value == 0.0 || std::abs(value) >= kLeastLength;
}

}  // namespace

void MissedTouches::Moves::add(source::Location where, std::uint64_t number) {
  if (places_.size() < kMostMoves) {
    places_.try_emplace(number, where);
  }
}

void MissedTouches::Moves::add(const Moves& others) {
  for (const auto& [number, where] : others.places_) {
    add(where, number);
  }
}

void MissedTouches::Moves::remove(const Moves& others) {
  for (const auto& [number, where] : others.places_) {
    places_.erase(number);
  }
}

bool MissedTouches::Moves::has_any_of(const Moves& others) const {
  return std::ranges::any_of(others.places_,
                             [this](const auto& one) { return contains(one.first); });
}

std::vector<source::Location> MissedTouches::Moves::in_order() const {
  std::vector<source::Location> places;
  for (const auto& [number, where] : places_) {
    if (std::ranges::find(places, where) == places.end()) {
      places.push_back(where);
    }
  }
  return places;
}

void MissedTouches::touched() {
  last_.reset();
  count();
}

void MissedTouches::Held::add(const Held& other) {
  results.add(other.results);
  looks.add(other.looks);
  signals.add(other.signals);
  measured.add(other.measured);
  made_of.insert(made_of.end(), other.made_of.begin(), other.made_of.end());
}

void MissedTouches::missed(source::Location where, const Miss& miss) {
  last_ = where;
  miss_ = miss;
  ++missed_count_;
  is_last_read_ = false;
  is_owed_ = true;
}

void MissedTouches::reads_result() {
  if (last_) {
    read_.results.add(*last_, missed_count_);
    read_.measured.add(*last_, missed_count_);
    is_last_read_ = true;
  }
}

void MissedTouches::looks() {
  if (last_) {
    read_.looks.add(*last_, missed_count_);
  }
}

void MissedTouches::looks_at_signal(int input) {
  if (last_ && listened_to(input)) {
    read_.signals.add(*last_, missed_count_);
  }
}

void MissedTouches::reads(Holder holder) {
  const auto found = holders_.find(holder);
  if (found == holders_.end()) {
    return;
  }
  const Held& held = found->second;
  read_.results.add(held.results);
  read_.looks.add(held.looks);
  read_.signals.add(held.signals);
  if (!held.is_way) {
    read_.measured.add(held.measured);
  }
  read_.made_of.push_back(holder);
}

MissedTouches::Reading MissedTouches::set_aside() {
  Reading reading = read_.is_of_none() ? nullptr : std::make_shared<const Held>(std::move(read_));
  end_statement();
  return reading;
}

void MissedTouches::reads(const Reading& reading) {
  if (reading != nullptr) {
    read_.add(*reading);
  }
}

void MissedTouches::compares(const Side& left, const Side& right) {
  reads(left.reading);
  reads(right.reading);
  const Held seen = std::move(read_);
  end_statement();
  settle(seen.signals);
  const auto is_measured = [](const Side& side) {
    return side.reading != nullptr && !side.reading->measured.empty();
  };
  const bool is_of_two = is_measured(left) && is_measured(right);
  if (is_of_two || !is_length(left.value) || !is_length(right.value)) {
    return;
  }
  // What is made of several results shows none of their ends: where all of them missed, it is as
  // they would have it.
  const bool is_near = std::abs(left.value - right.value) * miss_.mm_per_unit <= kSamePlaceMm &&
                       seen.measured.size() <= 1;
  const auto judge = [&](const Moves& moves, bool shows_end) {
    is_near&& shows_end ? settle(moves) : excuse(moves);
  };
  judge(seen.looks, true);
  judge(seen.results, miss_.result == Result::End);
}

void MissedTouches::decides() {
  const Held seen = std::move(read_);
  end_statement();
  settle(seen.signals);
  excuse(seen.looks);
  excuse(seen.results);
}

void MissedTouches::assigns(Holder holder) {
  Held held = std::move(read_);
  end_statement();
  if (held.is_of_none()) {
    holders_.erase(holder);
    count();
  } else {
    holders_.insert_or_assign(holder, std::move(held));
  }
}

void MissedTouches::serves_as_way() {
  for (const Holder holder : read_.made_of) {
    serves_as_way(holder, read_.results);
  }
  end_statement();
}

/// So do the variables that it was made of, as far as they still hold these moves.
void MissedTouches::serves_as_way(Holder holder, const Moves& moves) {
  const auto found = holders_.find(holder);
  if (found == holders_.end() || found->second.is_way || !found->second.results.has_any_of(moves)) {
    return;
  }
  found->second.is_way = true;
  for (const Holder source : found->second.made_of) {
    serves_as_way(source, moves);
  }
}

std::vector<source::Location> MissedTouches::uses() {
  const Moves used = read_.results;
  end_statement();
  return told(used);
}

void MissedTouches::asks() {
  if (last_) {
    Moves asked;
    asked.add(*last_, missed_count_);
    settle(asked);
  }
}

void MissedTouches::asks(int input) {
  if (listened_to(input)) {
    asks();
  }
}

void MissedTouches::forget(Holder first, Holder last) {
  holders_.erase(holders_.lower_bound(first), holders_.upper_bound(last));
  count();
}

std::vector<source::Location> MissedTouches::ends() {
  Moves left;
  for (const auto& [holder, held] : holders_) {
    if (!held.is_way) {
      Moves owed = held.results;
      owed.remove(held.excused);
      left.add(owed);
    }
  }
  add_unread(left);
  return told(left);
}

std::vector<source::Location> MissedTouches::breaks_off() {
  Moves left;
  add_unread(left);
  return told(left);
}

/// The last move, when nothing was made of it.
void MissedTouches::add_unread(Moves& moves) const {
  if (last_ && !is_last_read_) {
    moves.add(*last_, missed_count_);
  }
}

void MissedTouches::settle(const Moves& moves) {
  if (moves.empty()) {
    return;
  }
  for (auto& [holder, held] : holders_) {
    held.results.remove(moves);
    held.measured.remove(moves);
    held.looks.remove(moves);
    held.signals.remove(moves);
    held.excused.remove(moves);
  }
  std::erase_if(holders_, [](const auto& one) { return one.second.is_of_none(); });
  if (last_ && moves.contains(missed_count_)) {
    last_.reset();
  }
  count();
}

/// The variables that keep their results may go on to.
void MissedTouches::excuse(const Moves& moves) {
  for (auto& [holder, held] : holders_) {
    if (held.results.has_any_of(moves)) {
      held.excused.add(moves);
    }
  }
  is_last_read_ = is_last_read_ || (last_ && moves.contains(missed_count_));
}

std::vector<source::Location> MissedTouches::told(const Moves& moves) {
  settle(moves);
  return moves.in_order();
}

void MissedTouches::end_statement() {
  read_ = {};
}

void MissedTouches::count() {
  is_owed_ = last_.has_value() || !holders_.empty();
}

}  // namespace g31::runtime
