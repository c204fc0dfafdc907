#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {

/// The words of one NC block.
struct BlockWords {
  struct Word {
    double value = 0.0;
    Modification modification = Modification::None;
    bool present = false;
    std::uint8_t times = 0;  ///< it stands in the block
  };
  /// MEASA[axis] and MEAWA[axis]
  struct AxisMeasuring {
    double mode = 0.0;
    double trigger = 0.0;         ///< probe 1 or 2, minus: falling edge
    bool goes_on = false;         ///< MEAWA
    double second_trigger = 0.0;  ///< 0: none
  };
  /// FA[axis], ACC[axis] and the like
  struct AxisSetting {
    AxisWordId word = AxisWordId::AxisFeed;
    int axis = 0;  ///< or kSpindleAxis
    double value = 0.0;
  };
  /// S2=, M3=4, SPOS[2]: what is of another spindle than the master
  struct SpindleWord {
    int spindle = 0;
    Address address = Address::Speed;
    double value = 0.0;
    Modification modification = Modification::None;
  };
  std::array<Word, index_of(Address::Count)> words;
  std::array<double, kMostMachineCodes> machine_codes = {};
  std::size_t machine_code_count = 0;
  std::optional<std::string> tool_name;
  std::array<std::optional<AxisMeasuring>, kAxisCount> axis_measuring;
  bool has_axis_measuring = false;
  std::array<Word, kAxisNumbers> positioning;  ///< POS[axis] and POSA[axis]
  bool has_positioning = false;
  std::vector<AxisSetting> axis_settings;
  std::vector<SpindleWord> spindle_words;
  std::vector<std::uint16_t> computed_codes;  ///< G[group]=number, packed

  void set(std::size_t address, double value, Modification modification);
  void measure_axis(std::size_t axis, const AxisMeasuring& measuring);
  void position_axis(std::size_t axis, const Word& word);
  /// As new.  Only what was set is touched: most blocks have few words.
  void clear();
  [[nodiscard]] const Word& operator[](Address address) const { return words[index_of(address)]; }
  [[nodiscard]] bool has(Address address) const { return words[index_of(address)].present; }
  [[nodiscard]] const Word& axis(int index) const { return words[static_cast<std::size_t>(index)]; }
  [[nodiscard]] bool has_axes() const;

 private:
  std::array<std::uint8_t, index_of(Address::Count)> set_ = {};  ///< addresses of `words`
  std::size_t set_count_ = 0;
};

}  // namespace g31::sinumerik
