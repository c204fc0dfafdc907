#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/expressions.h"
#include "interpreter/dialects/sinumerik/code/label_jumps.h"

namespace g31::sinumerik {

/// GOTO and its like, CASE, and parts of a program between labels that run again.
class JumpStatements : private BlockPart {
 public:
  /// All outlive them.
  JumpStatements(const BlockWork& work, KnownVariables& variables, Expressions& expressions)
      : BlockPart(work),
        variables_(variables),
        expressions_(expressions),
        operations_(expressions.operations()) {}

  void goto_statement();
  void gotof_statement();
  void gotob_statement();
  void gotoc_statement();
  void gotos_statement();
  void case_statement();
  void repeatb_statement();

  // Of other statements
  std::optional<std::string> label_name();
  [[nodiscard]] bool jumps_behind() const;
  bool jump_statement();
  void repeat_part(bool one_block);
  void call_block();
  /// What BLOCK first TO last says of another program.
  void part_of(CallSite& site);

  /// The steps from this one on are taken back.
  void take_back(std::size_t first_step) { jumps_.take_back(first_step); }
  /// The end of the text: all labels are there.
  void resolve() { jumps_.resolve(program_, code_); }

 private:
  void jump(Direction direction);
  void jump_to(Direction direction);
  void emit_part(LabelJumps::Part part, Operand passes);
  /// A label by itself, or a text that names it.
  struct Label {
    std::string name;  ///< empty: by text
    Operand text;
  };
  Label label();
  std::pair<Label, Label> labels_of_part();
  [[nodiscard]] Operand text_of_label(const Label& label);

  KnownVariables& variables_;
  Expressions& expressions_;
  Operations& operations_;
  LabelJumps jumps_;
};

}  // namespace g31::sinumerik
