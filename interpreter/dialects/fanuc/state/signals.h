#pragma once

#include <array>
#include <cstdint>

namespace g31::fanuc {

/// What macro and the machine's PMC tell each other: #1000.. in, #1100.. out (MB-121).
struct PmcSignals {
  static constexpr int kWords = 3;

  std::uint16_t input_bits = 0;
  std::array<std::int32_t, kWords> input_words{};
  std::uint16_t output_bits = 0;
  std::array<std::int32_t, kWords> output_words{};

  bool operator==(const PmcSignals&) const = default;
};

}  // namespace g31::fanuc
