#include "machine/sim/continuous_path.h"

#include <algorithm>
#include <utility>

#include "machine/base/contract.h"

namespace g31::machine {

[[gnu::hot]] void ContinuousPath::add(const Move& move) {
  last_ = move;
  planner_.add(move.length, move.limits, move.corner_speed);
}

[[gnu::hot]] ContinuousPath::Passed ContinuousPath::release() {
  Passed passed = all_of(planner_.release());
  if (keeps_few_ && ways_.size() >= next_look_) {
    give_out_beginning(passed);
    next_look_ = std::max(kManyWays, 2 * ways_.size());
  }
  return passed;
}

void ContinuousPath::give_out_beginning(Passed& passed) {
  const auto cruise = planner_.cruise();
  if (!cruise) {
    return;
  }
  double length = 0.0;
  auto way = ways_.begin();
  for (; way != ways_.end() && length + way->length <= cruise->until; ++way) {
    length += way->length;
  }
  double rest = 0.0;  // as the planner adds them up
  for (; way != ways_.end(); ++way) {
    rest += way->length;
  }
  if (length >= cruise->from && length > 0.0) {
    const SpanMotion beginning = planner_.give_out_beginning(length, rest);
    pass(beginning, beginning.duration_s(), passed);
  }
}

ContinuousPath::Passed ContinuousPath::finish() {
  return all_of(planner_.finish());
}

ContinuousPath::Passed ContinuousPath::finish_at(double distance) {
  G31_EXPECTS(!is_empty() && distance >= 0.0 && distance <= last_.length);
  const std::span<const SpanMotion> spans = planner_.finish();
  Passed passed = all_of(spans.first(spans.size() - 1));
  const SpanMotion& last = spans.back();
  const double before = std::max(0.0, last.length() - last_.length);
  pass(last, last.time_at(std::min(last.length(), before + distance)), passed);
  ways_.clear();
  return passed;
}

void ContinuousPath::drop() {
  planner_.finish();
  ways_.clear();
}

ContinuousPath::Passed ContinuousPath::all_of(std::span<const SpanMotion> spans) {
  Passed passed;
  for (const SpanMotion& span : spans) {
    pass(span, span.duration_s(), passed);
  }
  return passed;
}

[[gnu::hot]] void ContinuousPath::pass(const SpanMotion& span, double until_s, Passed& passed) {
  passed.seconds += until_s;
  if (!keeps_ways_) {
    return;
  }
  const MotionPhases phases = span.phases();
  double gone = 0.0;
  double from_s = 0.0;
  while (gone < span.length() && from_s <= until_s) {
    const Way way = std::move(ways_.front());
    ways_.pop_front();
    const bool is_first = gone == 0.0;
    gone += way.length;  // as the planner adds them up: the last one ends with the span
    const bool is_last = gone >= span.length();
    const double to_s = std::min(until_s, is_last ? span.duration_s() : phases.time_at(gone));
    const bool is_whole = is_first && is_last && to_s == span.duration_s();
    passed.ways.push_back(
        {way.path, is_whole ? phases : phases.between(from_s, to_s), to_s - from_s, way.passing});
    from_s = to_s;
  }
}

}  // namespace g31::machine
