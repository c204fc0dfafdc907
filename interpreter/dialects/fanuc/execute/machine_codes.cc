#include <algorithm>
#include <array>
#include <cmath>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/spindle.h"
#include "interpreter/runtime/machine_code.h"
#include "interpreter/runtime/probe_inside.h"

namespace g31::fanuc {
namespace {

constexpr int kClockwise = 3;
constexpr int kCounterclockwise = 4;
constexpr int kStop = 5;
constexpr int kOrientation = 19;
constexpr std::int32_t kToolInSpindle = 3026;  // the variable that shows it on a Haas

/// The codes of the control; all others are the builder's.
constexpr auto kCodesOfControl = std::to_array<int>({
#define LANGUAGE_WORD(name, form, text)
#define PROGRAM_M_CODE(number, form, text) number,
#include "interpreter/dialects/fanuc/vocabulary/words.def"
#undef PROGRAM_M_CODE
#undef LANGUAGE_WORD
});

/// What a code of the builder's sets off is recorded: a probe, air, an arm; the spindle, perhaps.
void record_code(Control& control, int code) {
  if (std::ranges::find(kCodesOfControl, code) != kCodesOfControl.end()) {
    return;
  }
  control.builder_may_turn = control.builder_may_turn || runtime::may_turn_spindle(code);
  runtime::RecordedEvent event{
      "m_code", {{"m", static_cast<double>(code)}}, control.block, control.port.time_s()};
  if (control.tool) {
    event.values.push_back({"tool", static_cast<double>(*control.tool)});
  }
  control.observer.on_event(event);
}

void turn(Control& control, machine::Rotation rotation) {
  control.rotation = rotation;
  control.builder_may_turn = false;
  const bool stops = rotation == machine::Rotation::Stopped;
  const double speed = stops ? 0.0 : spindle_speed(control);
  // At the centre of G96 without a limit the machine has the last word, which nothing here knows.
  control.port.turn_spindle({rotation, std::isfinite(speed) ? speed : 0.0, {}});
}

/// M19 Rn, or Pn for those controls that write it so.
void orient(Control& control, const BlockWords& words) {
  control.rotation = machine::Rotation::Stopped;
  control.builder_may_turn = false;
  const EvaluatedWord* const angle = words.has('R') ? words.find('R') : words.find('P');
  control.port.turn_spindle(
      {machine::Rotation::Stopped, 0.0, angle != nullptr ? angle->number : 0.0});
}

void command(Control& control, const BlockWords& words, int code) {
  switch (code) {
    case kClockwise:
      turn(control, machine::Rotation::Clockwise);
      break;
    case kCounterclockwise:
      turn(control, machine::Rotation::Counterclockwise);
      break;
    case kStop:
      turn(control, machine::Rotation::Stopped);
      break;
    case kToolChange:
      if (!control.profile.replaces_tools) {
        change_tool(control);
      }
      break;
    case kOrientation:
      orient(control, words);
      break;
    default:
      break;
  }
  record_code(control, code);
  control.port.auxiliary_code({code});
  control.inputs.hear(code, control.now());
}

}  // namespace

void change_tool(Control& control) {
  if (!control.called_tool) {
    control.warn_once(source::DiagnosticId::ChangeWithoutTool, control.block);
    return;
  }
  const int number = *control.called_tool;
  control.tool = number;
  control.data[kToolInSpindle] = number;
  const runtime::ToolEntry entry = control.offsets.get(number);
  control.port.change_tool(
      {{number, entry.length_mm + entry.length_wear_mm, entry.radius_mm + entry.radius_wear_mm}});
  if (const auto inside = runtime::comes_inside(control.port)) {
    control.warn_once(source::DiagnosticId::StartInside, control.block, *inside);
  }
}

void command_machine(Control& control, const BlockWords& words) {
  if (const EvaluatedWord* const tool = words.find('T')) {
    control.called_tool = nearest_integer(tool->number);
  }
  if (words.has('S') && control.rotation != machine::Rotation::Stopped) {
    turn(control, control.rotation);
  }
  if (!words.has('M')) {
    return;
  }
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter == 'M') {
      command(control, words, nearest_integer(word.number));
    }
  }
}

}  // namespace g31::fanuc
