#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/spindle.h"

namespace g31::fanuc {
namespace {

bool counts_turns(const Control& control) {
  return control.modal.per_revolution() && control.parameters.is_on(ParameterId::DwellInTurns);
}

/// An axis other than X beside G04, which does not move and says no time.
void tell_idle_axes(Control& control, const NcBlock& block) {
  for (const char letter : std::string_view(kAxisLetters, kAxisCount)) {
    if (letter != 'X' && block.words.has(letter)) {
      control.warn_once(source::DiagnosticId::WordWithoutEffect, block.where,
                        fmt::format("{} beside G04, whose time is X, U or P", letter));
    }
  }
}

}  // namespace

Result<double, Failure> dwell_seconds(const Control& control, const EvaluatedWord& p) {
  if (is_dwell_in_seconds(p, control.profile)) {
    return p.number;
  }
  return is_dwell_in_milliseconds(p) ? Result<double, Failure>(nearest_integer(p.number) / 1000.0)
                                     : at_word(point_in(p), p);
}

/// G04: X or U in seconds, P in milliseconds, or as many turns of the spindle; without any of them
/// a block that takes no time (MB-285).
MaybeFailure execute_dwell(Control& control, const NcBlock& block) {
  tell_idle_axes(control, block);
  double seconds = 0.0;
  if (const EvaluatedWord* const p = block.words.find('P')) {
    const auto by_p = dwell_seconds(control, *p);
    if (!by_p) {
      return by_p.error();
    }
    seconds = by_p.value();
  }
  for (const char letter : {'X', 'U'}) {
    if (const EvaluatedWord* const word = block.words.find(letter)) {
      seconds = control.scale.seconds(*word);
    }
  }
  if (auto wrong = wrong_dwell(seconds)) {
    return block_failure(wrong->id, std::move(wrong->detail));
  }
  if (counts_turns(control)) {
    const double turns_per_minute = spindle_speed(control);
    if (turns_per_minute <= 0.0) {
      return block_failure(AlarmId::NoFeed, "a dwell of spindle turns needs a speed S");
    }
    seconds *= 60.0 / turns_per_minute;
  }
  return pause(control, seconds);
}

}  // namespace g31::fanuc
