#include "interpreter/runtime/input_scripts.h"

#include "machine/port/passed_time.h"

namespace g31::runtime {

InputScripts::InputScripts(const std::vector<InputStep>& steps) {
  for (const InputStep& step : steps) {
    steps_.push_back({step, false});
    inputs_.try_emplace(step.number);
  }
}

std::optional<bool> InputScripts::look(int number, const Now& now) {
  const auto input = inputs_.find(number);
  if (input == inputs_.end()) {
    return std::nullopt;
  }
  ++input->second.looks;
  take_due(now);
  return input->second.value;
}

std::optional<bool> InputScripts::shown(int number) const {
  const auto input = inputs_.find(number);
  return input != inputs_.end() ? std::optional(input->second.value) : std::nullopt;
}

void InputScripts::hear(int code, const Now& now) {
  take_due(now);
  for (Step& step : steps_) {
    if (step.what.from == InputStep::From::Code && step.what.at == code) {
      take(step);
    }
  }
}

void InputScripts::take_due(const Now& now) {
  const auto is_due = [&](const InputStep& what) {
    switch (what.from) {
      case InputStep::From::Start:
        return true;
      case InputStep::From::Time:
        return machine::has_come(what.at, now.time_s);
      case InputStep::From::Block:
        return static_cast<double>(now.blocks) >= what.at;
      case InputStep::From::Reads:
        return static_cast<double>(inputs_.at(what.number).looks) >= what.at;
      case InputStep::From::Code:
        return false;
    }
    return false;
  };
  for (Step& step : steps_) {
    if (!step.is_taken && is_due(step.what)) {
      take(step);
    }
  }
}

void InputScripts::take(Step& step) {
  step.is_taken = true;
  inputs_.at(step.what.number).value = step.what.value;
}

}  // namespace g31::runtime
