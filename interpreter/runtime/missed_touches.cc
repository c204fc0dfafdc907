#include "interpreter/runtime/missed_touches.h"

#include <algorithm>

namespace g31::runtime {

void MissedTouches::missed(source::Location where) {
  const auto known = std::ranges::find(moves_, where);
  last_ = static_cast<std::size_t>(known - moves_.begin());
  if (known == moves_.end()) {
    moves_.push_back(where);
  }
  is_last_read_ = false;
  is_owed_ = true;
}

void MissedTouches::reads_result() {
  if (last_ != kSettled) {
    read_.results.insert(last_);
    is_last_read_ = true;
  }
}

void MissedTouches::looks() {
  if (last_ != kSettled) {
    read_.looks.insert(last_);
  }
}

void MissedTouches::reads(Holder holder) {
  const auto found = holders_.find(holder);
  if (found == holders_.end()) {
    return;
  }
  read_.results.insert(found->second.results.begin(), found->second.results.end());
  read_.looks.insert(found->second.looks.begin(), found->second.looks.end());
  read_from_.push_back(holder);
}

void MissedTouches::compares() {
  Moves seen = read_.results;
  seen.insert(read_.looks.begin(), read_.looks.end());
  end_statement();
  settle(seen);
}

void MissedTouches::assigns(Holder holder) {
  Held held = std::move(read_);
  end_statement();
  if (held.results.empty() && held.looks.empty()) {
    holders_.erase(holder);
    is_owed_ = last_ != kSettled || !holders_.empty();
  } else {
    holders_.insert_or_assign(holder, std::move(held));
  }
}

void MissedTouches::moves() {
  for (const Holder holder : read_from_) {
    holders_[holder].is_way = true;
  }
  end_statement();
}

std::vector<source::Location> MissedTouches::uses() {
  const Moves used = read_.results;
  end_statement();
  return told(used);
}

void MissedTouches::asks() {
  if (last_ != kSettled) {
    settle({last_});
  }
}

void MissedTouches::forget(Holder first, Holder last) {
  holders_.erase(holders_.lower_bound(first), holders_.upper_bound(last));
  is_owed_ = last_ != kSettled || !holders_.empty();
}

std::vector<source::Location> MissedTouches::ends() {
  Moves left;
  for (const auto& [holder, held] : holders_) {
    if (!held.is_way) {
      left.insert(held.results.begin(), held.results.end());
    }
  }
  if (last_ != kSettled && !is_last_read_) {
    left.insert(last_);
  }
  return told(left);
}

void MissedTouches::settle(const Moves& moves) {
  const auto drop = [&](Moves& from) {
    std::erase_if(from, [&](std::size_t move) { return moves.contains(move); });
  };
  for (auto& [holder, held] : holders_) {
    drop(held.results);
    drop(held.looks);
  }
  std::erase_if(holders_, [](const auto& one) {
    return one.second.results.empty() && one.second.looks.empty();
  });
  if (moves.contains(last_)) {
    last_ = kSettled;
  }
  is_owed_ = last_ != kSettled || !holders_.empty();
}

std::vector<source::Location> MissedTouches::told(const Moves& moves) {
  std::vector<source::Location> places;
  for (const std::size_t move : moves) {
    places.push_back(moves_[move]);
  }
  settle(moves);
  return places;
}

void MissedTouches::end_statement() {
  read_ = {};
  read_from_.clear();
}

}  // namespace g31::runtime
