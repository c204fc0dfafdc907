#include "tools/report/run_chronicle.h"

#include <algorithm>
#include <utility>

namespace g31::report {
namespace {

// What an entry of a list of the document takes, about: within a factor of three (a test).
constexpr std::uint64_t kCallBytes = 160;
constexpr std::uint64_t kVariableBytes = 80;  // without its name and values
constexpr std::uint64_t kValueBytes = 48;     // without its text
constexpr std::uint64_t kBlockBytes = 24;

std::uint64_t size_of(const runtime::ShownValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  return kValueBytes + (text != nullptr ? runtime::size_in_document(*text) : 0);
}

/// Leaves every second value out.  @returns what these took
std::uint64_t thin(VariableHistory& history) {
  std::uint64_t left_out = 0;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < history.values.size(); ++i) {
    if (i % 2 != 0) {
      left_out += size_of(history.values[i].second);
    } else if (kept != i) {
      history.values[kept++] = std::move(history.values[i]);
    } else {
      ++kept;
    }
  }
  history.values.resize(kept);
  history.stride *= 2;
  return left_out;
}

}  // namespace

RunChronicle::RunChronicle(std::string main, const machine::MachinePort& clock,
                           runtime::OutputBudget& budget)
    : clock_(clock), budget_(budget) {
  // Nothing is charged before a program runs: who hears of a spent budget is not there yet.
  open_.push_back(0);
  calls_.push_back({std::move(main), 0, {}, clock.time_s(), clock.time_s(), 0, 0});
}

runtime::Verdict RunChronicle::on_block(const runtime::BlockPlace& place) {
  block_ = place.where;
  number_ = place.number;
  const std::size_t known = counts_.blocks().size();
  if (!place.is_skipped) {
    counts_.add(place.where);
  }
  if (counts_.blocks().size() > known) {
    budget_.charge(runtime::Output::Blocks, kBlockBytes);
  }
  return runtime::Verdict::Run;
}

void RunChronicle::on_level(std::uint16_t depth, const std::string& program) {
  if (depth < open_.size()) {
    close_to(std::size_t{depth} + 1);
  } else {
    open(depth, program);
  }
}

void RunChronicle::on_write(const runtime::WriteEvent& event) {
  const auto known = known_.find(event.name);
  const VariableHistory* const before =
      known == known_.end() ? nullptr : &histories_[known->second];
  // The last value is always there; the next write takes its place unless it is a stride's.
  const bool stays = before == nullptr || (before->writes - 1) % before->stride == 0;
  const std::uint64_t of_variable = before == nullptr ? kVariableBytes + event.name.size() : 0;
  if (stays && !budget_.charge(runtime::Output::History, of_variable + size_of(event.now))) {
    return;
  }
  const auto [found, is_new] = known_.try_emplace(event.name, histories_.size());
  if (is_new) {
    histories_.push_back({event.name, 0, {}, 1, {}, 0});
  }
  VariableHistory& history = histories_[found->second];
  if (!stays) {
    history.values.pop_back();
  }
  ++history.writes;
  history.last_write = event.where;
  history.last_block = number_;
  history.values.emplace_back(clock_.time_s(), event.now);
  if (history.values.size() > VariableHistory::kMostValues) {
    budget_.give_back(runtime::Output::History, thin(history));
  }
}

void RunChronicle::on_condition(const source::Location& where, bool is_met) {
  counts_.add_condition(where, is_met);
}

void RunChronicle::finish() {
  close_to(0);
}

void RunChronicle::open(std::uint16_t level, const std::string& program) {
  if (budget_.charge(runtime::Output::Calls, kCallBytes)) {
    const double now_s = clock_.time_s();
    // With no block between, it is the next pass of a call that repeats: called from where that
    // was.
    const auto before = std::find_if(calls_.rbegin(), calls_.rend(),
                                     [&](const CallSpan& call) { return call.level <= level; });
    const bool is_next_pass =
        before->level == level && before->program == program && before->last_block == number_;
    const source::Location from = is_next_pass ? before->call : block_;
    open_.push_back(calls_.size());
    calls_.push_back({program, level, from, now_s, now_s, number_, number_});
  }
}

void RunChronicle::close_to(std::size_t levels) {
  while (open_.size() > levels) {
    CallSpan& call = calls_[open_.back()];
    call.time_to_s = clock_.time_s();
    call.last_block = number_;
    open_.pop_back();
  }
}

}  // namespace g31::report
