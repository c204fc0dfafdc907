#pragma once

#include <cstdint>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/block_part.h"
#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {

/// The variables that a program knows: its own, and of those that it names the global ones and
/// those of the main program.
class KnownVariables : private BlockPart {
 public:
  /// All outlive them.
  KnownVariables(const BlockWork& work, const Globals& globals)
      : BlockPart(work), globals_(globals) {}

  /// -1: there is none of this name.
  std::int32_t find(std::string_view name);
  /// A global one becomes known to the program.
  std::int32_t import(const Variable& variable);
  [[nodiscard]] bool is_imported(std::string_view name) const { return imported_.contains(name); }
  /// -1: the name is taken, which is what is wrong with the block.
  std::int32_t define_local(Variable variable);
  /// A name in data that this control does not know; each once.
  void note_unknown(const Token& name);

 private:
  const Globals& globals_;
  NameMap<std::int32_t> imported_;
};

}  // namespace g31::sinumerik
