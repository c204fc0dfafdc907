#pragma once

#include <map>

#include "interpreter/dialects/fanuc/vocabulary/offset_numbers.h"
#include "interpreter/runtime/control_setup.h"

namespace g31::fanuc {

using runtime::OffsetMemory;

/// The tool offset table of the control; mm.
///
/// Memory C keeps length and radius, geometry and wear apart.  Memory B has one geometry and one
/// wear for both, memory A one value for all: writing one there writes the others of its number,
/// too.
class OffsetTable {
 public:
  static constexpr int kLargest = kToolOffsets;
  using Field = double runtime::ToolEntry::*;

  void set_memory(OffsetMemory memory) { memory_ = memory; }
  [[nodiscard]] OffsetMemory memory() const { return memory_; }

  void set(int number, const runtime::ToolEntry& entry) { entries_[number] = entry; }
  void set_field(int number, Field field, double value_mm);
  /// All zero for a number that was never set.
  [[nodiscard]] runtime::ToolEntry get(int number) const {
    const auto found = entries_.find(number);
    return found != entries_.end() ? found->second : runtime::ToolEntry{};
  }
  [[nodiscard]] bool has(int number) const { return entries_.contains(number); }

  bool operator==(const OffsetTable&) const = default;

 private:
  std::map<int, runtime::ToolEntry> entries_;
  OffsetMemory memory_ = OffsetMemory::C;
};

}  // namespace g31::fanuc
