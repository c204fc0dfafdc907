#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "machine/base/random.h"

namespace g31::fuzz {

/// A run of numbers that belongs to one text, the same on every computer.
class Draws {
 public:
  /// @param kind  of text: each has runs of its own
  explicit Draws(std::uint64_t number, std::uint64_t kind = 0)
      : stream_{kind, static_cast<std::uint32_t>(number)} {}

  /// 0 to count - 1; count > 0.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform(stream_, draws_++) * static_cast<double>(count));
  }

  bool once_in(std::size_t times) { return below(times) == 0; }

  std::string_view of(std::span<const std::string_view> all) { return all[below(all.size())]; }

 private:
  Stream stream_;
  std::uint64_t draws_ = 0;
};

}  // namespace g31::fuzz
