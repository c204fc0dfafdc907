#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/action_statements.h"
#include "interpreter/dialects/sinumerik/code/call_statements.h"
#include "interpreter/dialects/sinumerik/code/compile.h"
#include "interpreter/dialects/sinumerik/code/definitions.h"
#include "interpreter/dialects/sinumerik/code/structure_statements.h"
#include "interpreter/dialects/sinumerik/text/plain_words.h"

namespace g31::sinumerik {

/// What a compiler owns and its parts work with.
struct CompilerMemory {
  explicit CompilerMemory(const ProgramSource& source)
      : program(std::make_unique<CompiledProgram>()), reader(source.file->text()), code(*program) {}

  std::unique_ptr<CompiledProgram> program;
  BlockReader reader;
  CodeWriter code;
};

/// Translates one program block by block, in one go.  A block that is wrong is taken back and a
/// Raise stands in its place.
class Compiler final : private CompilerMemory, private BlockPart, private BlockItems {
 public:
  Compiler(const ProgramSource& source, const Globals& globals, Purpose purpose);

  /// The local variables of another program are there from the start.
  void know_locals_of(const CompiledProgram& home);
  /// Where DEF and DEFINE of a definition file go.
  void define_in(Globals& globals) { definitions_.define_in(globals, is_shipped_); }

  std::unique_ptr<CompiledProgram> run();
  /// What DEF defines before the first block that does something.
  std::vector<Variable> run_head();
  /// Blocks from `begin` on that say nothing of others.
  CompiledWindow run_window(std::uint32_t begin);
  /// The whole text is one expression.
  std::unique_ptr<CompiledProgram> run_expression();

 private:
  /// Of a word that begins a statement.
  struct Handler {
    void (*compile)(Compiler&);
    bool directs_flow;
  };

  // compiler.cc: blocks and what is wrong with them
  void read_block(ShortSpan span);
  void begin_block(ShortSpan block);
  void end_block();
  void block_head();
  void label_or_number();
  void statement();
  void item() override;
  void letter_item();
  void take_back(std::size_t first_step);
  void raise_from(std::size_t first_step);

  // compile_program.cc
  bool lone_block(ShortSpan line);
  [[nodiscard]] ShortSpan line_from(std::uint32_t begin) const;
  void reserve(std::size_t lines);
  void end_of_text();

  // compile_plain.cc
  bool plain_block(ShortSpan line);
  bool plain_word(const PlainWord& word);

  /// nullptr: no such word
  static const Handler* find_handler(std::string_view name);

  [[nodiscard]] BlockWork work() { return {reader_, program_, code_}; }

  bool is_shipped_;
  Purpose purpose_;
  std::string_view text_;
  Scanner scanner_;
  ShortSpan whole_;
  NcBlockWriter nc_;
  KnownVariables variables_;
  Expressions expressions_;
  Assignments assignments_;
  WordCompiler words_;

  // The parts that keywords.def names
  Definitions definitions_;
  JumpStatements jumps_;
  StructureStatements structures_;
  CallStatements calls_;
  ActionStatements actions_;
  std::vector<const Macros*> seen_macros_;  ///< those that come first at the front

  OpCode end_ = OpCode::EndProgram;  ///< of the text
};

}  // namespace g31::sinumerik
