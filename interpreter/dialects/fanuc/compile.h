#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/alarms.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// One operation of an expression on a stack of cells.
enum class OpCode : std::uint8_t {
  Constant,  ///< push the number `constant`
  Vacant,    ///< push #0
  Local,     ///< push local variable `number`
  Common,    ///< push common variable `number`
  Numbered,  ///< push variable `number` of any other kind
  Indirect,  ///< replace the top by the variable of that number
  Negate,
  Binary,  ///< replace the two topmost by `op` of them
  Call,    ///< replace the top by `function` of it
  Call2,   ///< replace the two topmost by `function` of them
  End,     ///< the top is the result
};

struct Op {
  OpCode code = OpCode::End;
  syntax::Operator op = syntax::Operator::Add;
  std::uint8_t function = 0;
  std::int32_t number = 0;  ///< of a variable; Constant: how many digits were written
  double constant = 0.0;
};

/// The deepest stack that an expression within the bracket limit can need, with room to spare.
inline constexpr std::size_t kExpressionStack = 64;

/// One block, ready to run: expressions are code, jumps are step numbers.
struct Step {
  syntax::BlockKind kind = syntax::BlockKind::Empty;
  std::uint8_t skip_switch = 0;
  OpCode target_kind = OpCode::End;  ///< Assign: Local, Common, Numbered, or Indirect
  std::int32_t number = 0;           ///< Assign: variable; Bad: row of errors; Output: statement
  syntax::Index block = 0;           ///< of the tree
  syntax::Index target = syntax::kNone;     ///< code of #[...] on the left side
  syntax::Index value = syntax::kNone;      ///< code
  syntax::Index condition = syntax::kNone;  ///< code
  syntax::Index jump = syntax::kNone;  ///< step to go on with; kNone: to be searched, or missing
};

/// A sequence number and its step.
struct Label {
  std::int32_t sequence = 0;
  syntax::Index step = 0;
};

/// One O program, compiled.
struct CompiledProgram {
  std::int32_t number = 0;
  const source::SourceFile* file = nullptr;
  const syntax::Tree* tree = nullptr;
  std::vector<Step> steps;
  std::vector<Op> ops;
  std::vector<syntax::ShortSpan> op_spans;     ///< one per op, for messages
  std::vector<syntax::Index> word_code;        ///< per word of the program: code of its value
  syntax::Index first_word = 0;                ///< of the tree: word_code[0] belongs to it
  std::vector<Label> labels;                   ///< rising by sequence, then step
  std::vector<syntax::SyntaxError> errors;     ///< found while compiling; rows of alarms.def

  /// The step that GOTO `sequence` in step `from` goes to: the first behind it, else the first from
  /// the top (MB-171).
  [[nodiscard]] std::optional<syntax::Index> find_label(std::int32_t sequence,
                                                        syntax::Index from) const;
};

/// Compiles program `which` of the tree.  The file and the tree must outlive the result.
CompiledProgram compile(const source::SourceFile& file, const syntax::Tree& tree,
                        std::size_t which);

/// The errors of the blocks that the program can reach from its first one, in order of place.
/// Unreachable nonsense is none of the control's business, nor of ours.
std::vector<syntax::SyntaxError> reachable_errors(const CompiledProgram& program);

}  // namespace g31::fanuc
