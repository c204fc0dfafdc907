#include "interpreter/dialects/sinumerik/state/block_words.h"

#include <algorithm>

namespace g31::sinumerik {

void BlockWords::set(std::size_t address, double value, Modification modification) {
  if (!words[address].present) {
    set_[set_count_++] = static_cast<std::uint8_t>(address);
  }
  // Part by part: a Word that is copied as a whole costs the wait for its parts.
  words[address].value = value;
  words[address].modification = modification;
  words[address].present = true;
  ++words[address].times;
}

void BlockWords::measure_axis(std::size_t axis, const AxisMeasuring& measuring) {
  axis_measuring[axis] = measuring;
  has_axis_measuring = true;
}

void BlockWords::position_axis(std::size_t axis, const Word& word) {
  positioning[axis] = word;
  has_positioning = true;
}

void BlockWords::clear() {
  for (std::size_t i = 0; i < set_count_; ++i) {
    words[set_[i]] = {};
  }
  set_count_ = 0;
  machine_code_count = 0;
  tool_name.reset();
  if (has_axis_measuring) {
    axis_measuring = {};
    has_axis_measuring = false;
  }
  if (has_positioning) {
    positioning = {};
    has_positioning = false;
  }
  axis_settings.clear();
  spindle_words.clear();
  computed_codes.clear();
}

bool BlockWords::has_axes() const {
  return std::any_of(words.begin(), words.begin() + kAxisCount,
                     [](const Word& word) { return word.present; });
}

}  // namespace g31::sinumerik
