#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/assignments.h"
#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/text/macros.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {

/// DEF, DEFINE, PROC and the like, and where in a program they may stand.
class Definitions : private BlockPart {
 public:
  /// All outlive them.
  Definitions(const BlockWork& work, const Globals& globals, Purpose purpose,
              KnownVariables& variables, Assignments& assignments)
      : BlockPart(work),
        globals_(globals),
        purpose_(purpose),
        variables_(variables),
        assignments_(assignments),
        expressions_(assignments.expressions()) {}

  /// Where DEF and DEFINE of a definition file go.
  void define_in(Globals& globals, bool is_shipped) {
    defined_ = &globals;
    is_shipped_ = is_shipped;
  }
  /// DEFINE of the program.
  [[nodiscard]] const Macros& macros() const { return macros_; }

  // Blocks
  void begin_block() { in_block_ = 0; }
  void end_block() { is_first_block_ = false; }
  [[nodiscard]] bool is_first_block() const { return is_first_block_; }
  /// Definitions of the present block, so far.
  [[nodiscard]] int count_in_block() const { return in_block_; }
  /// A statement that is no definition has stood there.
  void begin_program_part() { in_program_part_ = true; }
  [[nodiscard]] bool is_in_program_part() const { return in_program_part_; }
  /// A variable may be called I, say.
  [[nodiscard]] bool have_letter_names() const { return has_letter_names_; }
  void expect_letter_names() { has_letter_names_ = true; }

  /// DEF [NCK|CHAN] type name[sizes] = values, ...
  void def_statement();
  /// APR 7 APW 11 on a line of their own: rights of what follows in a definition file.
  void rights_statement();
  /// DEFINE name AS text
  void define_statement();
  /// PROC name(parameters) attributes
  void proc_statement();
  /// EXTERN says what the PROC of the called program says again; the PROC counts.
  void extern_statement();
  /// REDEF changes who may see and write data: here everybody may.
  void redef_statement();

 private:
  struct DeclaredType {
    Type type;
    std::int32_t longest = 0;  ///< characters of a STRING
  };
  bool begins_definition(std::string_view what);
  void proc_parameter();
  void proc_attributes();
  std::optional<DeclaredType> declared_type();
  [[nodiscard]] bool name_goes_on() const;
  std::optional<Variable> declared_variable(const DeclaredType& declared);
  std::optional<std::int32_t> string_length();
  std::optional<std::int32_t> whole_constant();
  Shape dimensions();
  void preset(Parameter& parameter);
  std::int32_t defined_alike(const Variable& variable);
  void limit_memory(const Layout& layout, const Variable& variable);
  std::int32_t define(const Variable& variable);
  void define_with_value(const Variable& variable);
  [[nodiscard]] bool is_of_user(const std::string& name) const;
  void pass_over_value();
  Macros& macros_behind();
  std::optional<double> signed_constant();
  Limits definition_attributes();

  const Globals& globals_;
  Globals* defined_ = nullptr;
  bool is_shipped_ = false;  ///< the definition file
  Purpose purpose_;
  KnownVariables& variables_;
  Assignments& assignments_;
  Expressions& expressions_;
  Macros macros_;
  int in_block_ = 0;
  bool is_first_block_ = true;
  bool in_program_part_ = false;
  bool has_letter_names_ = false;
};

}  // namespace g31::sinumerik
