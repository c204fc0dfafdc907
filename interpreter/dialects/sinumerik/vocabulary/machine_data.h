#pragma once

#include <span>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"

namespace g31::sinumerik {

/// One row of machine_data.def.
struct MachineDatum {
  int number;
  std::string_view name;
  Type type;
  int count;  ///< 0: no array
  double preset;
  DatumUnit unit;
  std::string_view text;
  /// Fixed: kept, but g31 goes on as with the preset.  Watched: counts once it is written.
  enum class Effect { Usual, Fixed, Watched };
  Effect effect;
};

std::span<const MachineDatum> machine_data();

/// One row of memory.def.
struct MemoryRow {
  std::string_view name;
  Type type;
  int count;  ///< 0: no array
  std::string_view text;
};

std::span<const MemoryRow> memory_rows();

}  // namespace g31::sinumerik
