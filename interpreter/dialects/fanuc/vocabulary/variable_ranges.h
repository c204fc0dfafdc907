#pragma once

#include <cstdint>

namespace g31::fanuc {

inline constexpr std::int32_t kLocalCount = 33;    ///< #1..#33
inline constexpr std::int32_t kFirstCommon = 100;  ///< #100..#199, null after power on
inline constexpr std::int32_t kLastVolatile = 199;
inline constexpr std::int32_t kFirstPermanent = 500;  ///< #500..#999 kept over power off
inline constexpr std::int32_t kCommonEnd = 1000;

inline constexpr std::int32_t kFirstFurther = 98000;  ///< of the 30i: #98000..#98499, kept, too
inline constexpr std::int32_t kFurtherCommonCount = 500;

constexpr bool is_local(std::int32_t number) {
  return number >= 1 && number <= kLocalCount;
}

/// #100..#199 and #500..#999: what every control of the family has with its usual options.
constexpr bool is_common(std::int32_t number) {
  return (number >= kFirstCommon && number <= kLastVolatile) ||
         (number >= kFirstPermanent && number < kCommonEnd);
}

}  // namespace g31::fanuc
