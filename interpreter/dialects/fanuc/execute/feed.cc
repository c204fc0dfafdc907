#include "interpreter/dialects/fanuc/execute/feed.h"

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

Result<double, Failure> feed_in_force(const Control& control) {
  if (control.modal.feed <= 0.0) {
    return block_failure(AlarmId::NoFeed);
  }
  const double feed = control.to_mm(control.modal.feed);
  if (control.modal.group[Group::FeedMode].whole != 95) {
    return feed;
  }
  const double revolutions_per_minute = control.modal.words['S' - 'A'];
  if (revolutions_per_minute <= 0.0) {
    return block_failure(AlarmId::NoFeed, "G95 needs a spindle speed S");
  }
  return feed * revolutions_per_minute;
}

double switched_feed(const Control& control, double feed_mm_min) {
  constexpr int kOverrideOff = 1 << 1;  // of #3004
  const auto& modal = control.modal;
  const bool taps = modal.group[Group::CuttingMode].whole == 63 ||
                    modal.group[Group::CannedCycle].whole == 74 ||
                    modal.group[Group::CannedCycle].whole == 84;
  const runtime::FeedSwitches& switches = control.feed_switches;
  if (switches.dry_run_mm_min > 0.0 && !taps) {
    return switches.dry_run_mm_min;
  }
  const bool as_programmed = taps || (control.override_control & kOverrideOff) != 0;
  return as_programmed ? feed_mm_min : feed_mm_min * switches.override_percent / 100.0;
}

}  // namespace g31::fanuc
