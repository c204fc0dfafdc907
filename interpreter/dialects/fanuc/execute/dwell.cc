#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

/// G04: X or U in seconds, P in milliseconds; without any of them a block that takes no time.
MaybeFailure execute_dwell(Control& control, const NcBlock& block) {
  double seconds = 0.0;
  if (const EvaluatedWord* const p = block.words.find('P')) {
    const auto milliseconds = integer_of(*p);
    if (!milliseconds) {
      return milliseconds.error();
    }
    seconds = milliseconds.value() / 1000.0;
  }
  for (const char letter : {'X', 'U'}) {
    if (const EvaluatedWord* const word = block.words.find(letter)) {
      seconds = control.scale.seconds(*word);
    }
  }
  if (seconds < 0.0) {
    Failure failure;
    failure.id = AlarmId::IllegalMinus;
    failure.detail = "a dwell is not negative";
    return failure;
  }
  return pause(control, seconds);
}

}  // namespace g31::fanuc
