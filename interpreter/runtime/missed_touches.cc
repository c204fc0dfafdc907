#include "interpreter/runtime/missed_touches.h"

#include <algorithm>

namespace g31::runtime {
namespace {

/// A variable of more moves than these is told all the same, through those that it knows.
constexpr std::size_t kMostMoves = 64;

}  // namespace

void MissedTouches::Moves::add(source::Location where, std::uint64_t number) {
  if (places_.size() < kMostMoves) {
    places_.try_emplace(place_of(where), Move{where, number});
  }
}

void MissedTouches::Moves::add(const Moves& others) {
  for (const auto& [place, move] : others.places_) {
    add(move.where, move.number);
  }
}

void MissedTouches::Moves::remove(const Moves& others) {
  for (const auto& [place, move] : others.places_) {
    places_.erase(place);
  }
}

bool MissedTouches::Moves::has_any_of(const Moves& others) const {
  return std::ranges::any_of(others.places_,
                             [this](const auto& one) { return places_.contains(one.first); });
}

bool MissedTouches::Moves::contains(source::Location where) const {
  return places_.contains(place_of(where));
}

std::vector<source::Location> MissedTouches::Moves::in_order() const {
  std::vector<Move> moves;
  for (const auto& [place, move] : places_) {
    moves.push_back(move);
  }
  std::ranges::sort(moves, {}, &Move::number);
  std::vector<source::Location> places(moves.size());
  std::ranges::transform(moves, places.begin(), &Move::where);
  return places;
}

void MissedTouches::touched() {
  last_.reset();
  count();
}

void MissedTouches::missed(source::Location where) {
  last_ = where;
  ++missed_count_;
  is_last_read_ = false;
  is_owed_ = true;
}

void MissedTouches::reads_result() {
  if (last_) {
    read_.results.add(*last_, missed_count_);
    is_last_read_ = true;
  }
}

void MissedTouches::looks() {
  if (last_) {
    read_.looks.add(*last_, missed_count_);
  }
}

void MissedTouches::reads(Holder holder) {
  const auto found = holders_.find(holder);
  if (found == holders_.end()) {
    return;
  }
  read_.results.add(found->second.results);
  read_.looks.add(found->second.looks);
  read_.made_of.push_back(holder);
}

MissedTouches::Reading MissedTouches::set_aside() {
  const bool is_empty = read_.results.empty() && read_.looks.empty();
  Reading reading = is_empty ? nullptr : std::make_shared<const Held>(std::move(read_));
  end_statement();
  return reading;
}

void MissedTouches::reads(const Reading& reading) {
  read_.results.add(reading->results);
  read_.looks.add(reading->looks);
  read_.made_of.insert(read_.made_of.end(), reading->made_of.begin(), reading->made_of.end());
}

void MissedTouches::compares() {
  Moves seen = read_.results;
  seen.add(read_.looks);
  end_statement();
  settle(seen);
}

void MissedTouches::assigns(Holder holder) {
  Held held = std::move(read_);
  end_statement();
  if (held.results.empty() && held.looks.empty()) {
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

void MissedTouches::forget(Holder first, Holder last) {
  holders_.erase(holders_.lower_bound(first), holders_.upper_bound(last));
  count();
}

std::vector<source::Location> MissedTouches::ends() {
  Moves left;
  for (const auto& [holder, held] : holders_) {
    if (!held.is_way) {
      left.add(held.results);
    }
  }
  if (last_ && !is_last_read_) {
    left.add(*last_, missed_count_);
  }
  return told(left);
}

void MissedTouches::settle(const Moves& moves) {
  for (auto& [holder, held] : holders_) {
    held.results.remove(moves);
    held.looks.remove(moves);
  }
  std::erase_if(holders_, [](const auto& one) {
    return one.second.results.empty() && one.second.looks.empty();
  });
  if (last_ && moves.contains(*last_)) {
    last_.reset();
  }
  count();
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
