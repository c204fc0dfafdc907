#pragma once

#include <cstdint>

#include "machine/units/units.h"

namespace g31 {

/// What a program's lengths count; the machine itself knows only millimetres.
enum class LengthUnit : std::uint8_t { Millimetre, Inch };

constexpr double mm_per(LengthUnit unit) {
  return unit == LengthUnit::Inch ? LengthKind::kMmPerInch : 1.0;
}

}  // namespace g31
