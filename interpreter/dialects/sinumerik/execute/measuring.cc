#include "interpreter/dialects/sinumerik/execute/measuring.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

/// @param trigger  1 to 8, minus: falling edge
Result<Measuring, Failure> of_trigger(double trigger, machine::AfterSignal after,
                                      std::string_view word) {
  if (auto wrong = wrong_trigger(word, trigger)) {
    return failure(*std::move(wrong));
  }
  return Measuring{static_cast<int>(std::abs(trigger)),
                   trigger > 0.0 ? machine::SignalEdge::Rising : machine::SignalEdge::Falling,
                   after, false, 0};
}

/// With the second trigger of MEASA.
Result<Measuring, Failure> with_second(Measuring first, const BlockWords::AxisMeasuring& axis) {
  if (auto wrong = wrong_second_trigger(axis.trigger, axis.second_trigger)) {
    return failure(*std::move(wrong));
  }
  first.further = static_cast<int>(std::abs(axis.second_trigger));
  return first;
}

/// Whether a word of an axis measures: it may break off, or stand for another axis.
bool measures_axis(const std::optional<BlockWords::AxisMeasuring>& axis) {
  return axis && measures(axis->mode);
}

bool has_measuring_word(const BlockWords& words) {
  return words.has(Address::Measure) || words.has(Address::MeasureOn) ||
         (words.has_axis_measuring && std::ranges::any_of(words.axis_measuring, measures_axis));
}

/// MEASA and MEAWA of all axes together; nullopt: none.
Result<std::optional<Measuring>, Failure> of_axes(const BlockWords& words) {
  const BlockWords::AxisMeasuring* first = nullptr;
  for (const auto& axis : words.axis_measuring) {
    if (!measures_axis(axis)) {
      continue;
    }
    if (auto wrong = wrong_measuring_mode(axis->mode)) {
      return failure(*std::move(wrong));
    }
    if (first != nullptr && (first->trigger != axis->trigger || first->goes_on != axis->goes_on ||
                             first->second_trigger != axis->second_trigger ||
                             measuring_mode(first->mode) != measuring_mode(axis->mode))) {
      return failure(measured_twice());
    }
    first = &*axis;
  }
  if (first == nullptr) {
    return std::optional<Measuring>();
  }
  auto found =
      of_trigger(first->trigger,
                 first->goes_on ? machine::AfterSignal::GoOn : machine::AfterSignal::Stop, "MEASA");
  if (found && first->second_trigger != 0.0) {
    found = with_second(found.value(), *first);
  }
  if (!found) {
    return found.error();
  }
  Measuring measuring = found.value();
  measuring.mode = measuring_mode(first->mode);
  return std::optional(measuring);
}

}  // namespace

Result<Measuring, Failure> measuring_of(const Channel& channel, const BlockWords& words) {
  auto found = of_axes(words);
  if (!found) {
    return found.error();
  }
  for (const Address address : {Address::Measure, Address::MeasureOn}) {
    if (!words.has(address)) {
      continue;
    }
    if (found.value()) {
      return failure(measured_twice());
    }
    const auto of_word = of_trigger(
        words[address].value,
        address == Address::Measure ? machine::AfterSignal::Stop : machine::AfterSignal::GoOn,
        "MEAS");
    if (!of_word) {
      return of_word.error();
    }
    found = std::optional(of_word.value());
  }
  if (found.value()) {
    return *found.value();
  }
  G31_EXPECTS(channel.skip_action.has_value());
  return Measuring{channel.skip_action->probe, channel.skip_action->edge,
                   machine::AfterSignal::Stop, true};
}

bool measures_positioning(const Block& block) {
  const BlockWords& words = block.words;
  if (!words.has_positioning || !has_measuring_word(words)) {
    return false;
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (measures_axis(words.axis_measuring[axis])) {
      return words.positioning[axis].present;
    }
  }
  return !commands_motion(block);
}

MaybeFailure cannot_measure_positioning(const Block& block) {
  const auto& places = block.words.positioning;
  const auto count = std::ranges::count_if(places, &BlockWords::Word::present);
  const bool carries = std::any_of(places.begin(), places.begin() + kAxisCount,
                                   [](const BlockWords::Word& word) { return word.present; });
  const bool is_alone = count == 1 && carries && !commands_motion(block);
  bool is_its_own = true;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    is_its_own = is_its_own && (!measures_axis(block.words.axis_measuring[axis]) ||
                                block.words.positioning[axis].present);
  }
  return is_alone && is_its_own
             ? std::nullopt
             : MaybeFailure(failure(
                   AlarmId::NotImplemented,
                   "measuring with POS: one of X, Y, Z, A, B, C, and no other axis in its block"));
}

bool listens_to_probe(const Channel& channel, const Block& block) {
  return (has_measuring_word(block.words) && !measures_positioning(block)) ||
         (channel.skip_action && commands_motion(block));
}

}  // namespace g31::sinumerik
