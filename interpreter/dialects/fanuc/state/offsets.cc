#include "interpreter/dialects/fanuc/state/offsets.h"

namespace g31::fanuc {

void OffsetTable::set_field(int number, Field field, double value_mm) {
  using runtime::ToolEntry;
  ToolEntry& entry = entries_[number];
  const bool is_wear = field == &ToolEntry::length_wear_mm || field == &ToolEntry::radius_wear_mm;
  switch (memory_) {
    case OffsetMemory::A:
      entry = {value_mm, 0.0, value_mm, 0.0};
      return;
    case OffsetMemory::B:
      entry.*(is_wear ? &ToolEntry::length_wear_mm : &ToolEntry::length_mm) = value_mm;
      entry.*(is_wear ? &ToolEntry::radius_wear_mm : &ToolEntry::radius_mm) = value_mm;
      return;
    case OffsetMemory::C:
      entry.*field = value_mm;
      return;
  }
}

}  // namespace g31::fanuc
