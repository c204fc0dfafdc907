#pragma once

#include <map>

#include "interpreter/runtime/control_setup.h"

namespace g31::fanuc {

/// The tool offset table of the control (memory C: length and radius, geometry and wear); mm.
class OffsetTable {
 public:
  static constexpr int kLargest = 999;

  void set(int number, const runtime::ToolEntry& entry) { entries_[number] = entry; }
  /// All zero for a number that was never set.
  [[nodiscard]] runtime::ToolEntry get(int number) const {
    const auto found = entries_.find(number);
    return found != entries_.end() ? found->second : runtime::ToolEntry{};
  }
  [[nodiscard]] bool has(int number) const { return entries_.contains(number); }

 private:
  std::map<int, runtime::ToolEntry> entries_;
};

}  // namespace g31::fanuc
