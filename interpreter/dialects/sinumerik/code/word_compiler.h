#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/expressions.h"
#include "interpreter/dialects/sinumerik/code/nc_block_writer.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {

/// Words of NC blocks: G and M codes, addresses, words of axes and spindles.
class WordCompiler : private BlockPart {
 public:
  /// All outlive it.
  WordCompiler(const BlockWork& work, const Globals& globals, Purpose purpose,
               Expressions& expressions, NcBlockWriter& nc)
      : BlockPart(work),
        globals_(globals),
        purpose_(purpose),
        expressions_(expressions),
        operations_(expressions.operations()),
        accesses_(expressions.accesses()),
        nc_(nc) {}

  /// A word that begins with this letter, which has been read.
  void letter_word(const Token& letter);
  /// Words whose address is a name: G codes like SUPA, CR=, SPOS=, AX[..]=.  @returns whether the
  /// next token begins one
  bool named_word();

  // Words that are known at once
  void g_code(std::optional<FoundCode> code, ShortSpan where);
  /// M2, M17 and M30 end the program behind everything else in their block.
  void m_number(double number, ShortSpan where);
  /// A word that needs no step of its own: the block knows it.
  void constant_word(Address address, double value, ShortSpan where);

  [[nodiscard]] bool has_words() const { return nc_.has_words(); }
  /// The words of the block are all there: the step that executes them.
  void finish_block();

 private:
  [[nodiscard]] bool is_assigned(std::size_t ahead) const;
  bool word_of_another_spindle(const Token& letter, double extension);
  void code_of_group(ShortSpan where);
  void m_word(ShortSpan where);
  std::optional<double> number_at_once();
  Expr word_value(Modification& modification);
  void word(Address address, ShortSpan where);
  void emit_word(Address address, Modification modification, const Expr& value);
  Expr bracketed_axis(const AxisWordInfo& row);
  void axis_word(const AxisWordInfo& row);
  Expr measuring_number();
  void axis_measuring(const AxisWordInfo& row, const Expr& axis, ShortSpan where);
  Expr bracketed_spindle();
  [[nodiscard]] bool is_master_spindle(const Expr& spindle) const;
  [[nodiscard]] bool is_number(const Expr& spindle, double number) const;
  void spindle_word(Address address, const Expr& spindle, ShortSpan where);

  const Globals& globals_;
  Purpose purpose_;
  Expressions& expressions_;
  Operations& operations_;
  Accesses& accesses_;
  NcBlockWriter& nc_;
};

}  // namespace g31::sinumerik
