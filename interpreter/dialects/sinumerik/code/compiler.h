#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/compile.h"
#include "interpreter/dialects/sinumerik/code/definitions.h"
#include "interpreter/dialects/sinumerik/code/label_jumps.h"
#include "interpreter/dialects/sinumerik/code/structures.h"
#include "interpreter/dialects/sinumerik/code/word_compiler.h"
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
class Compiler : private CompilerMemory, private BlockPart {
 public:
  Compiler(const ProgramSource& source, const Globals& globals, Purpose purpose);

  /// The local variables of another program are there from the start.
  void know_locals_of(const CompiledProgram& home);
  /// Where DEF and DEFINE of a definition file go.
  void define_in(Globals& globals) { definitions_.define_in(globals); }

  std::unique_ptr<CompiledProgram> run();
  /// Blocks from `begin` on that say nothing of others.
  CompiledWindow run_window(std::uint32_t begin);
  /// The whole text is one expression.
  std::unique_ptr<CompiledProgram> run_expression();

 private:
  using Handler = void (Compiler::*)();

  // compiler.cc: blocks and what is wrong with them
  void read_block(ShortSpan span);
  void begin_block(ShortSpan block);
  void end_block();
  void block_head();
  void label_or_number();
  void statement();
  void item();
  void letter_item();
  void finish_words();
  void take_back(std::size_t first_step);
  void raise_from(std::size_t first_step);
  void set_target(std::int32_t jump, std::int32_t target);

  // compile_program.cc
  bool lone_block(ShortSpan line);
  [[nodiscard]] ShortSpan line_from(std::uint32_t begin) const;
  void reserve(std::size_t lines);
  void end_of_text();

  // compile_plain.cc
  bool plain_block(ShortSpan line);
  bool plain_word(const PlainWord& word);

  // compile_structure.cc
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
  void case_statement();
  void goto_statement();
  void gotof_statement();
  void gotob_statement();
  void gotoc_statement();
  void gotos_statement();
  void repeatb_statement();
  void jump(Direction direction);
  [[nodiscard]] bool jumps_behind() const;
  void jump_to(Direction direction);
  bool jump_statement();
  void repeat_part(bool one_block);
  void emit_part(LabelJumps::Part part, Operand passes);
  void call_block();
  std::optional<std::string> label_name();
  void open(StructureKind kind, std::int32_t head, std::int32_t exit, const Expr& counter = {});
  std::optional<Structure> close(StructureKind kind);
  std::optional<Structure> close_loop(StructureKind kind);
  void back_to(const Structure& loop);
  void keep_element(Expr& counter);

  // Handlers that a part has.
  void def_statement() { definitions_.def_statement(); }
  void rights_statement() { definitions_.rights_statement(); }
  void define_statement() { definitions_.define_statement(); }
  void proc_statement() { definitions_.proc_statement(); }
  void extern_statement() { definitions_.extern_statement(); }
  void redef_statement() { definitions_.redef_statement(); }
  void refused_statement() { refuse(reader_); }

  // compile_call.cc
  void call_by_name(std::string name, ShortSpan where);
  void call_statement();
  void pcall_statement();
  void mcall_statement();
  void extcall_statement();
  void ret_statement();
  void procedure(ProcedureId id, ShortSpan where);
  std::vector<Argument> argument_list();
  void call(CallSite site, ShortSpan where);
  void idle_statement();
  void when_statement();

  // compile_actions.cc
  struct ActionText {
    std::string text;  ///< a block
    bool deletes_distance = false;
  };
  void numbered_action();
  void action_statement();
  void synchronised_action(std::string_view word, ActionScope scope, const Expr& number);
  bool judge_condition(std::size_t from);
  bool may_act(const Token& action);
  bool accept_unit();
  ActionText action_list(ActionKind kind, bool is_timed);
  void judge_action(std::size_t from, ActionKind kind, bool is_timed);

  static Handler find_keyword(std::string_view name);

  [[nodiscard]] BlockWork work() { return {reader_, program_, code_}; }

  const Globals& globals_;
  Purpose purpose_;
  std::string_view text_;
  Scanner scanner_;
  ShortSpan whole_;
  NcBlockWriter nc_;
  Structures structures_;
  LabelJumps jumps_;
  KnownVariables variables_;
  Expressions expressions_;
  Operations& operations_;
  Assignments assignments_;
  WordCompiler words_;
  Definitions definitions_;
  OpCode end_ = OpCode::EndProgram;  ///< of the text
};

}  // namespace g31::sinumerik
