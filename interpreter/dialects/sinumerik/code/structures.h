#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code_writer.h"
#include "interpreter/dialects/sinumerik/code/expr.h"

namespace g31::sinumerik {

enum class StructureKind { If, Else, Loop, For, While, Repeat };

/// IF, LOOP, FOR, WHILE or REPEAT whose end has not come.
struct Structure {
  StructureKind kind = StructureKind::If;
  ShortSpan where;
  std::int32_t head = -1;  ///< step that a missing end turns into an alarm, and loops go back to
  std::int32_t exit = -1;  ///< jump out of it, to be given its target
  Expr counter;            ///< For
};

/// The control structures that are open, one within the other.
class Structures {
 public:
  /// @param program  outlives them: their bodies are written there
  explicit Structures(CompiledProgram& program) : program_(program) {}

  [[nodiscard]] bool are_closed() const { return open_.empty(); }
  /// Whether no further one may begin.
  [[nodiscard]] bool are_too_deep() const;
  /// Whether the innermost one is of a kind.
  [[nodiscard]] bool are_in(StructureKind kind) const;
  /// Whether an IF is open, whatever stands in it.
  [[nodiscard]] bool are_in_branch() const;

  /// @param step  that the block begins with
  void open(Structure structure, std::size_t step);
  /// The innermost one, if it is of the kind that ends here, which is open no longer.
  /// @param step  that the block begins with
  std::optional<Structure> close(StructureKind kind, std::size_t step);

  /// The end of the text: what is still open becomes an alarm where it begins.
  void end(CodeWriter& code);

 private:
  CompiledProgram& program_;
  std::vector<Structure> open_;
};

}  // namespace g31::sinumerik
