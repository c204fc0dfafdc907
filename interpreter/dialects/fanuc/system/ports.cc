#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc::system {
namespace {

constexpr double kBitsOfWord = 65536.0;
constexpr int kFirstInputBit = 1000;
constexpr int kInputBits = 16;
constexpr int kFirstOutputBit = 1100;
constexpr int kOutputBits = 16;

Cell bit_of(std::uint16_t bits, int index) {
  return Cell((bits >> index & 1) != 0 ? 1.0 : 0.0);
}

/// A program looks at inputs, and may wait for them: that takes time.
void look_at_inputs(Control& control) {
  control.touches.looks_at_input();
  control.time_looked_at();
}

/// What the machine's own wiring says goes over what the sheet scripts, and that over what was
/// written.
std::optional<bool> live_input(Control& control, int number) {
  const auto scripted = control.is_inspected() ? control.inputs.shown(number)
                                               : control.inputs.look(number, control.now());
  const auto wired = control.port.digital_input(number);
  return wired ? wired : scripted;
}

bool input_bit(Control& control, int index) {
  const bool kept = (control.signals.input_bits >> index & 1) != 0;
  return live_input(control, kFirstInputBit + index).value_or(kept);
}

/// Anything but 0 sets the bit (MB-121).
void set_bit(std::uint16_t& bits, int index, double value) {
  const unsigned mask = 1U << index;
  bits = static_cast<std::uint16_t>(value != 0.0 ? bits | mask : bits & ~mask);
}

/// The low 16 bits of the integer nearest to a value, two's complement.
std::uint16_t low_bits(double value) {
  const double rest = std::fmod(std::round(value), kBitsOfWord);
  return static_cast<std::uint16_t>(rest < 0.0 ? rest + kBitsOfWord : rest);
}

WriteResult set_word(std::int32_t& word, double value) {
  const double whole = std::round(value);
  using Limits = std::numeric_limits<std::int32_t>;
  if (whole < Limits::min() || whole > Limits::max()) {
    return AlarmId::IntegerOverflow;
  }
  word = static_cast<std::int32_t>(whole);
  return std::nullopt;
}

/// What the displacement sensor shows whose word this is; nullopt: it is none's.
std::optional<Cell> counts_of_sensor(const Control& control, const Place& place) {
  const auto word =
      std::ranges::find(control.sensor_words, place.number, &runtime::SensorWord::number);
  if (word == control.sensor_words.end()) {
    return std::nullopt;
  }
  const auto reading = control.port.displacement(word->input);
  return reading ? std::optional(Cell(std::round(*reading / word->count_mm))) : std::nullopt;
}

std::size_t word_of(const Place& place) {
  return static_cast<std::size_t>(place.index());
}

Cell input_bits(Control& control) {
  std::uint16_t bits = 0;
  for (int i = 0; i < kInputBits; ++i) {
    set_bit(bits, i, input_bit(control, i) ? 1.0 : 0.0);
  }
  return Cell(bits);
}

/// What machine and macro tell each other in a word.
Cell signals_of(Control& control, const Place& place) {
  const PmcSignals& signals = control.signals;
  const Shows shows = place.row.shows;
  if (shows == Shows::InputBits) {
    return input_bits(control);
  }
  if (shows == Shows::OutputBits) {
    return Cell(signals.output_bits);
  }
  const auto& words = shows == Shows::InputWord ? signals.input_words : signals.output_words;
  return Cell(words.at(word_of(place)));
}

}  // namespace

ReadResult read_input_bit(Control& control, const Place& place) {
  look_at_inputs(control);
  return Cell(input_bit(control, place.index()) ? 1.0 : 0.0);
}

ReadResult read_further_input(Control& control, const Place& place) {
  look_at_inputs(control);
  const auto live = live_input(control, place.number);
  return live ? ReadResult(Cell(*live ? 1.0 : 0.0)) : read_datum(control, place);
}

WriteResult write_input_bit(Control& control, const Place& place, Cell value) {
  set_bit(control.signals.input_bits, place.index(), value.or_zero());
  return std::nullopt;
}

ReadResult read_word(Control& control, const Place& place) {
  if (place.row.shows == Shows::InputBits) {
    look_at_inputs(control);
  }
  const auto counts = counts_of_sensor(control, place);
  return counts ? *counts : signals_of(control, place);
}

WriteResult write_input_bits(Control& control, const Place&, Cell value) {
  control.signals.input_bits = low_bits(value.or_zero());
  return std::nullopt;
}

WriteResult write_input_word(Control& control, const Place& place, Cell value) {
  return set_word(control.signals.input_words.at(word_of(place)), value.or_zero());
}

ReadResult read_output_bit(Control& control, const Place& place) {
  return bit_of(control.signals.output_bits, place.index());
}

WriteResult write_output_bit(Control& control, const Place& place, Cell value) {
  set_bit(control.signals.output_bits, place.index(), value.or_zero());
  control.port.digital_output({kFirstOutputBit + place.index(), value.or_zero() != 0.0});
  return std::nullopt;
}

WriteResult write_output_bits(Control& control, const Place&, Cell value) {
  control.signals.output_bits = low_bits(value.or_zero());
  for (int i = 0; i < kOutputBits; ++i) {
    control.port.digital_output({kFirstOutputBit + i, (control.signals.output_bits >> i & 1) != 0});
  }
  return std::nullopt;
}

WriteResult write_output_word(Control& control, const Place& place, Cell value) {
  return set_word(control.signals.output_words.at(word_of(place)), value.or_zero());
}

}  // namespace g31::fanuc::system
