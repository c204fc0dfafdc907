#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code_writer.h"
#include "interpreter/dialects/sinumerik/code/compile.h"
#include "interpreter/dialects/sinumerik/code/expr.h"
#include "interpreter/dialects/sinumerik/code/label_jumps.h"
#include "interpreter/dialects/sinumerik/code/nc_block_writer.h"
#include "interpreter/dialects/sinumerik/code/structures.h"
#include "interpreter/dialects/sinumerik/code/token_cursor.h"
#include "interpreter/dialects/sinumerik/text/plain_words.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {

/// Translates one program block by block, in one go.  A block that is wrong is taken back and a
/// Raise stands in its place.
class Compiler {
 public:
  enum class Purpose { Program, Definitions, Data };

  Compiler(const ProgramSource& source, const Globals& globals, Purpose purpose);

  /// The local variables of another program are there from the start.
  void know_locals_of(const CompiledProgram& home);
  /// Where DEF and DEFINE of a definition file go.
  void define_in(Globals& globals) { definitions_ = &globals; }

  std::unique_ptr<CompiledProgram> run();
  /// Blocks from `begin` on that say nothing of others.
  CompiledWindow run_window(std::uint32_t begin);
  /// The whole text is one expression.
  std::unique_ptr<CompiledProgram> run_expression();

 private:
  /// What an index list in brackets says.
  struct Element {
    Operand number;
    bool is_fixed = false;  ///< `number` is a constant, `offset` its value
    std::int32_t offset = 0;
    bool is_open = false;  ///< the brackets go on: a character or component of it follows
  };
  using Handler = void (Compiler::*)();

  // compiler.cc: blocks and what is wrong with them
  void block(ShortSpan span);
  void begin_block(ShortSpan block);
  void end_block();
  void block_head();
  void label_or_number();
  void statement();
  void item();
  void finish_words();
  void take_back(std::size_t first_step);
  void raise_from(std::size_t first_step);
  void expect(Symbol symbol);
  void expect_end();
  void fail(AlarmId id, ShortSpan where, std::string_view detail = {});
  void fail(AlarmId id, std::string_view detail = {}) { fail(id, cursor_.peek().where, detail); }
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] std::string text_of(ShortSpan where) const;
  /// @pre a number that is constant
  [[nodiscard]] double number_of(const Expr& constant) const {
    return program_->constants[static_cast<std::size_t>(constant.value.place)];
  }
  Operand temporary(Type type);
  void set_target(std::int32_t jump, std::int32_t target);

  // compile_program.cc
  bool lone_block(ShortSpan line);
  [[nodiscard]] ShortSpan line_from(std::uint32_t begin) const;
  void reserve(std::size_t lines);
  void end_of_text();

  // compile_plain.cc
  bool plain_block(ShortSpan line);
  bool plain_word(const PlainWord& word);

  // compile_expression.cc
  Expr expression(int level = 0);
  Expr unary();
  Expr inverted(const Token& token, Expr operand);
  Expr text_literal(const Token& token);
  Expr primary();
  Expr name_in_expression();
  Expr letter_in_expression();
  Expr combine(int row, Expr left, Expr right);
  Expr compare(OpCode code, Expr left, Expr right, ShortSpan where);
  Expr concatenate(Expr left, Expr right, ShortSpan where);
  Expr arithmetic(OpCode code, Expr left, Expr right, ShortSpan where);
  /// A whole array is an argument and nothing else: its alarm where a value is wanted.
  void expect_value(const Expr& expr);
  Expr convert(Expr from, Type to, AlarmId mismatch = AlarmId::WrongType);
  void narrow(Expr& value, Type from);
  Expr as_text(Expr from);
  Expr boolean(Expr from) { return convert(std::move(from), Type::Bool); }
  Expr constant(Type type, double value, ShortSpan where);

  // compile_function.cc
  Expr call_function(FunctionId id, ShortSpan where);
  Expr plain_mathematics(FunctionId id, ShortSpan where);
  void function_argument(char kind, std::vector<Argument>& list);

  // compile_variable.cc
  std::int32_t find_variable(std::string_view name);
  std::int32_t import(const Variable& variable);
  Expr variable_access(std::int32_t variable, ShortSpan where);
  Element element_or_part(std::int32_t variable);
  Expr loaded(const Expr& target);
  void place(Expr& target, const Element& element) const;
  void add_index(Element& element, std::int32_t variable, const Expr& index, int dimension);
  Element element_of(std::int32_t variable);
  Expr component_access(Expr frame);
  Expr system_access(const SystemName& name, ShortSpan where);
  std::vector<Argument> system_indices(const SystemName& name);
  Expr axis_operand();
  Expr component_operand();
  void store(const Expr& target, Expr value);
  void check_limits(const Expr& target, Operand value);
  [[nodiscard]] Expr target_of(std::int32_t variable, ShortSpan where) const;
  void assign_variable(std::int32_t variable, ShortSpan where);
  void assign_element(const Expr& target);
  void assign_component(const Expr& frame);
  void assign_system(const SystemName& name, ShortSpan where);
  void assign_list(const Expr& target);
  void note_unknown(const Token& name);
  Expr axis_of_data(const Token& name);
  void pass_over(const Token& datum);
  bool looks_like_list() const;
  void repeat_value(const Expr& target);
  std::uint32_t keep_arguments(const std::vector<Argument>& list);
  Argument argument_of(const Expr& expr);

  // compile_character.cc
  Expr character_access(const Expr& string);
  void assign_character(const Expr& target);
  Expr part_of(const Expr& string, const Expr& first, const Expr* length);

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

  // compile_definition.cc
  bool begins_definition(std::string_view what);
  void def_statement();
  void rights_statement();
  void define_statement();
  void proc_statement();
  void extern_statement();
  void redef_statement();
  void proc_parameter();
  void proc_attributes();
  struct DeclaredType {
    Type type;
    std::int32_t longest = 0;  ///< characters of a STRING
  };
  std::optional<DeclaredType> declared_type();
  std::optional<Variable> declared_variable(const DeclaredType& declared);
  std::int32_t define_local(Variable variable);
  std::optional<std::int32_t> string_length();
  std::optional<std::int32_t> whole_constant();
  Shape dimensions();
  void preset(Parameter& parameter);
  std::int32_t defined_alike(const Variable& variable);
  std::int32_t define(const Variable& variable);
  std::optional<double> signed_constant();
  Limits definition_attributes();

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
  void refused_statement();
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

  // compile_words.cc
  void letter_item();
  void letter_word(const Token& letter);
  void code_of_group(ShortSpan where);
  void g_code(std::optional<FoundCode> code, ShortSpan where);
  void m_word(ShortSpan where);
  void m_number(double number, ShortSpan where);
  std::optional<double> number_at_once();
  void constant_word(Address address, double value, ShortSpan where);
  Expr bracketed_axis(const AxisWordInfo& row);
  void axis_word(const AxisWordInfo& row);
  void axis_measuring(const AxisWordInfo& row, const Expr& axis, ShortSpan where);
  bool named_word();
  bool word_of_another_spindle(const Token& letter, double extension);
  Expr bracketed_spindle();
  [[nodiscard]] bool is_tool_spindle(const Expr& spindle) const;
  void spindle_word(Address address, const Expr& spindle, ShortSpan where);
  void word(Address address, ShortSpan where);
  void emit_word(Address address, Modification modification, const Expr& value);
  Expr word_value(Modification& modification);
  [[nodiscard]] bool is_assigned(std::size_t ahead) const;

  static Handler find_keyword(std::string_view name);

  const Globals& globals_;
  Globals* definitions_ = nullptr;
  Purpose purpose_;
  std::string_view text_;
  Scanner scanner_;
  ShortSpan whole_;
  std::unique_ptr<CompiledProgram> program_;
  CodeWriter code_;  ///< of program_
  NcBlockWriter nc_;
  Structures structures_;
  LabelJumps jumps_;
  TokenCursor cursor_;
  NameMap<std::int32_t> imported_;
  Macros macros_;
  int depth_ = 0;
  ShortSpan block_;
  ShortSpan error_where_;
  std::optional<BlockError> error_;
  OpCode end_ = OpCode::EndProgram;  ///< of the text
  bool is_first_block_ = true;
  int definitions_in_block_ = 0;   ///< so far
  bool in_program_part_ = false;   ///< a statement that is no definition stood before
  bool has_letter_names_ = false;  ///< a variable is called I, say
};

/// Whether an argument is the variable that its parameter wants; see functions.def and
/// procedures.def.
bool is_taken_by(char kind, const Argument& argument);

}  // namespace g31::sinumerik
