#pragma once

#include <cstdint>
#include <optional>

#include "interpreter/dialects/sinumerik/code/assignments.h"
#include "interpreter/dialects/sinumerik/code/jump_statements.h"
#include "interpreter/dialects/sinumerik/code/structures.h"

namespace g31::sinumerik {

/// IF, LOOP, FOR, WHILE and REPEAT, and what ends them.
class StructureStatements : private BlockPart {
 public:
  /// All outlive them.
  StructureStatements(const BlockWork& work, KnownVariables& variables, Assignments& assignments,
                      JumpStatements& jumps)
      : BlockPart(work),
        variables_(variables),
        assignments_(assignments),
        expressions_(assignments.expressions()),
        operations_(expressions_.operations()),
        jumps_(jumps),
        open_(program_) {}

  void if_statement();
  void else_statement();
  void endif_statement();
  void loop_statement();
  void endloop_statement();
  void for_statement();
  void endfor_statement();
  void while_statement();
  void endwhile_statement();
  void repeat_statement();
  void until_statement();

  [[nodiscard]] bool are_closed() const { return open_.are_closed(); }
  /// The end of the text: what is still open becomes an alarm where it begins.
  void end() { open_.end(code_); }

 private:
  void open(StructureKind kind, std::int32_t head, std::int32_t exit, const Expr& counter = {});
  std::optional<Structure> close(StructureKind kind);
  std::optional<Structure> close_loop(StructureKind kind);
  void back_to(const Structure& loop);
  void keep_element(Expr& counter);

  KnownVariables& variables_;
  Assignments& assignments_;
  Expressions& expressions_;
  Operations& operations_;
  JumpStatements& jumps_;
  Structures open_;
};

}  // namespace g31::sinumerik
