#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

void orient_spindle(Control& control, const BlockWords& words) {
  if (!words.has('M')) {
    return;
  }
  constexpr double kOrientation = 19.0;
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter != 'M' || word.number != kOrientation) {
      continue;
    }
    const EvaluatedWord* const angle = words.has('R') ? words.find('R') : words.find('P');
    control.port.turn_spindle(
        {machine::Rotation::Stopped, 0.0, angle != nullptr ? angle->number : 0.0});
  }
}

}  // namespace g31::fanuc
