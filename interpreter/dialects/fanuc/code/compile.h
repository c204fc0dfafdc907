#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/dialects/fanuc/vocabulary/program_key.h"
#include "interpreter/runtime/cell.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/nested_steps.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

using runtime::Cell;

/// Where an operand of an operation stands.  Every bank is an array of cells, so that fetching an
/// operand takes no decision.
enum class Bank : std::uint8_t {
  Constants,    ///< CompiledProgram::constants
  Locals,       ///< of the call level, by variable number
  Commons,      ///< by variable number
  Temporaries,  ///< results within one expression
};

struct Operand {
  Bank bank = Bank::Constants;
  std::int32_t place = 0;
};

/// What an operation does with its operands a and b; the result is a temporary.  In the order of
/// syntax::Operator, which evaluate() relies on, too.
enum class OpCode : std::uint8_t {
  Add,
  Subtract,
  Multiply,
  Divide,
  Modulo,
  And,
  Or,
  Xor,
  Equal,
  NotEqual,
  Greater,
  Less,
  GreaterEqual,
  LessEqual,
  End,            ///< a is the value of the expression
  Negate,         ///< -a
  Read,           ///< the variable whose number is a, as a program wrote or computed it
  Call,           ///< `function` of a
  CallOfTwo,      ///< `function` of a and b
  NumberOfName,   ///< number of the variable that name b of CompiledProgram::names means, index a
  AxisParameter,  ///< parameter a of axis b
  LogicSwitch,    ///< conditions are joined here; parameter 6006.0 allows it
  DigitLimit,     ///< a constant of `function` digits stands here; not every control takes it
};

/// What an operator of the tree is as a step.
constexpr OpCode operation_of(syntax::Operator op) {
  switch (op) {
    case syntax::Operator::Add:
      return OpCode::Add;
    case syntax::Operator::Subtract:
      return OpCode::Subtract;
    case syntax::Operator::Multiply:
      return OpCode::Multiply;
    case syntax::Operator::Divide:
      return OpCode::Divide;
    case syntax::Operator::Modulo:
      return OpCode::Modulo;
    case syntax::Operator::And:
      return OpCode::And;
    case syntax::Operator::Or:
      return OpCode::Or;
    case syntax::Operator::Xor:
      return OpCode::Xor;
    case syntax::Operator::Equal:
      return OpCode::Equal;
    case syntax::Operator::NotEqual:
      return OpCode::NotEqual;
    case syntax::Operator::Greater:
      return OpCode::Greater;
    case syntax::Operator::Less:
      return OpCode::Less;
    case syntax::Operator::GreaterEqual:
      return OpCode::GreaterEqual;
    case syntax::Operator::LessEqual:
      return OpCode::LessEqual;
  }
  return OpCode::End;
}

constexpr bool is_comparison(OpCode code) {
  return code == OpCode::Equal || code == OpCode::NotEqual || code == OpCode::Greater ||
         code == OpCode::Less || code == OpCode::GreaterEqual || code == OpCode::LessEqual;
}

struct Op {
  OpCode code = OpCode::End;
  std::uint8_t function = 0;  ///< row of functions.def; DigitLimit: how many digits
  std::uint8_t result = 0;    ///< place among the temporaries
  bool is_missing = false;    ///< the control lacks it: an alarm where a run gets there
  Operand a;
  Operand b;
};

/// More results than an expression within the bracket limit can need at a time.
inline constexpr std::size_t kTemporaryCount = 64;

/// What the left side of an assignment is.
enum class TargetKind : std::uint8_t { Local, Common, Numbered, Computed };

/// One block, ready to run: expressions are code, jumps are step numbers.
struct Step {
  syntax::BlockKind kind = syntax::BlockKind::Empty;
  std::uint8_t skip_switch = 0;
  bool enters_loop = false;                       ///< Goto, IfGoto: from outside
  TargetKind target_kind = TargetKind::Numbered;  ///< Assign
  std::int32_t number = 0;  ///< Assign: variable; Bad: row of errors; Output: statement
  syntax::Index block = 0;  ///< of the tree
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

/// A window is a run of blocks of a program too long to be kept whole.  Its jumps are not linked:
/// only the whole program knows where they lead.
enum class Extent : std::uint8_t { Whole, Window };

/// One O program, compiled.
struct CompiledProgram {
  Extent extent = Extent::Whole;
  ProgramKey key;
  const source::SourceFile* file = nullptr;
  const syntax::Tree* tree = nullptr;
  std::vector<Step> steps;
  std::vector<Op> ops;
  std::vector<Cell> constants;              ///< the first is vacant: #0
  std::vector<std::string> names;           ///< of variables, upper case
  std::vector<syntax::ShortSpan> op_spans;  ///< one per op, for messages
  /// Per word of the program, up to the last one that is computed: code of its value.
  std::vector<syntax::Index> word_code;
  syntax::Index first_word = 0;             ///< of the tree: word_code[0] belongs to it
  std::vector<Label> labels;                ///< rising by sequence, then step
  syntax::NestedSteps loops;                ///< WHILE and DO with their END
  std::vector<syntax::SyntaxError> errors;  ///< found while compiling; rows of alarms.def

  /// The step that GOTO `sequence` in step `from` goes to: the first behind it, else the first from
  /// the top (MB-171).
  [[nodiscard]] std::optional<syntax::Index> find_label(std::int32_t sequence,
                                                        syntax::Index from) const;
  /// Whether a jump goes into a loop that it is not in; to its WHILE it may go.
  [[nodiscard]] bool enters_loop(syntax::Index from, syntax::Index to) const;
  /// The sequence number that a GOTO names, if a constant of every control's range names it.
  [[nodiscard]] std::optional<std::int32_t> constant_target(const Step& jump) const;
};

/// Where a piece of a program stands.
inline source::Location location_in(const CompiledProgram& program, syntax::ShortSpan span) {
  return program.file->at(span.widened());
}

/// What a program says that it is called by.
ProgramKey key_in(std::string_view text, const syntax::Program& program);

/// Compiles program `which` of the tree for a control; what that control lacks becomes an error.
/// The file and the tree must outlive the result.
CompiledProgram compile(const source::SourceFile& file, const syntax::Tree& tree, std::size_t which,
                        const Profile& profile, Extent extent = Extent::Whole);

/// The errors of the blocks that the program can reach from its first one, in order of place.
/// Unreachable nonsense is none of the control's business, nor of ours.
std::vector<syntax::SyntaxError> reachable_errors(const CompiledProgram& program);

}  // namespace g31::fanuc
