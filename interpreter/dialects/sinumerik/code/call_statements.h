#pragma once

#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/jump_statements.h"
#include "interpreter/dialects/sinumerik/code/word_compiler.h"

namespace g31::sinumerik {

/// Calls of programs and of procedures of the language, and the way back.
class CallStatements : private BlockPart {
 public:
  /// All outlive them.
  CallStatements(const BlockWork& work, Expressions& expressions, WordCompiler& words,
                 JumpStatements& jumps)
      : BlockPart(work),
        expressions_(expressions),
        operations_(expressions.operations()),
        words_(words),
        jumps_(jumps) {}

  void call_by_name(std::string name, ShortSpan where);
  void procedure(ProcedureId id, ShortSpan where);

  void call_statement();
  void pcall_statement();
  void mcall_statement();
  void extcall_statement();
  void ret_statement();
  void endproc_statement();

 private:
  std::vector<Argument> argument_list();
  /// To the caller, or where RET says.
  void return_to(const std::vector<Argument>& list);
  void call(CallSite site, ShortSpan where);

  Expressions& expressions_;
  Operations& operations_;
  WordCompiler& words_;
  JumpStatements& jumps_;
};

}  // namespace g31::sinumerik
