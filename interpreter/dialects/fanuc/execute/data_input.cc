#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

constexpr int kEndOfInput = 11;  // G11

bool ends_input(const BlockWords& words) {
  const EvaluatedWord* const g = words.find('G');
  return g != nullptr && g->number == kEndOfInput;
}

/// R as the parameter's unit has it: lengths without a point count least increments (MB-262).
double entered_value(const Control& control, int number, const EvaluatedWord& r) {
  const ParameterInfo* const row = find_parameter(number);
  if (row != nullptr && row->unit == "mm") {
    return control.scale.length_mm(r);
  }
  return row != nullptr && row->unit == "deg" ? control.scale.angle_deg(r) : r.number;
}

/// N.. R.., or N.. P.. R.. with P the number of the axis (MB-260).
MaybeFailure set_parameter(Control& control, const BlockWords& words) {
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter != 'P' && word.letter != 'R') {
      return at_word(AlarmId::DataInputFormat, word,
                     fmt::format("{} is not allowed here", word.letter));
    }
  }
  const EvaluatedWord* const r = words.find('R');
  const EvaluatedWord* const p = words.find('P');
  if (words.sequence() < 0 || r == nullptr) {
    return block_failure(AlarmId::DataInputFormat,
                         r == nullptr ? "R is missing" : "N is missing: the parameter's number");
  }
  const double value = entered_value(control, words.sequence(), *r);
  Parameters parameters = control.parameters;
  if (p != nullptr) {
    const auto given = integer_of(*p, control.profile);
    const auto axis = given ? control.controlled_axis(given.value() - 1) : std::nullopt;
    if (!axis) {
      return at_word(AlarmId::DataInputFormat, *p, "P is the number of an axis");
    }
    parameters.set_axis_value(words.sequence(), *axis, value);
  } else if (!parameters.enter(words.sequence(), value)) {
    return at_word(AlarmId::DataInputFormat, *r, "R is eight digits 0 or 1, bit 7 first");
  }
  control.apply(parameters);
  if (!has_effect(fmt::format("{}.X", words.sequence()))) {
    control.warn_once(source::DiagnosticId::UnknownParameter, control.block,
                      std::to_string(words.sequence()));
  }
  return std::nullopt;
}

/// Of words without a point, as T and P are written.
double number_of(const BlockWords& words, char letter) {
  const EvaluatedWord* const word = words.find(letter);
  return word != nullptr ? word->number : 0.0;
}

/// P.. L.. begins a group, T.. H.. D.. is a tool of it; behind G10 L3 P2 the groups P go.
MaybeFailure record_tool_life(Control& control, const BlockWords& words) {
  ToolLifeGroup& group = control.life_group;
  if (const EvaluatedWord* const p = words.find('P')) {
    const auto number = integer_of(*p, control.profile);
    if (!number || number.value() < 1) {
      return at_word(AlarmId::DataInputFormat, *p, "P is the number of a group, from 1");
    }
    group = {number.value(), number_of(words, 'L'), group.deletes};
    if (group.deletes) {
      control.observer.on_event(
          {"tool_life_deleted", {{"group", p->number}}, control.block, control.port.time_s()});
    }
  }
  const EvaluatedWord* const tool = words.find('T');
  if (tool == nullptr || group.deletes) {
    return std::nullopt;
  }
  if (group.number == 0) {
    return at_word(AlarmId::DataInputFormat, *tool, "P is missing: the number of its group");
  }
  runtime::RecordedEvent event{
      "tool_life",
      {{"group", static_cast<double>(group.number)}, {"life", group.life}, {"tool", tool->number}},
      control.block,
      control.port.time_s()};
  for (const auto& [letter, name] : {std::pair('H', "h"), std::pair('D', "d")}) {
    if (words.has(letter)) {
      event.values.push_back({name, number_of(words, letter)});
    }
  }
  control.observer.on_event(event);
  return std::nullopt;
}

}  // namespace

MaybeFailure execute_data_block(Control& control, const BlockWords& words) {
  if (ends_input(words)) {
    control.data_input = DataInput::None;
    return control.tell_machine();
  }
  return control.data_input == DataInput::Parameters ? set_parameter(control, words)
                                                     : record_tool_life(control, words);
}

}  // namespace g31::fanuc
