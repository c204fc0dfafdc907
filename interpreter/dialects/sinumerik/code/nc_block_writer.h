#pragma once

#include <optional>

#include "interpreter/dialects/sinumerik/code/code_writer.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {

/// Writes the words of an NC block: codes and plain numbers into the lists of the program, and one
/// step that executes them behind the steps of words that are computed.
class NcBlockWriter {
 public:
  /// Both outlive the writer.
  NcBlockWriter(CompiledProgram& program, CodeWriter& code) : program_(program), code_(code) {}

  /// A G code.  @returns false: its group has one in the block
  bool add(FoundCode code);
  /// A word that is a number.  @returns false: it stands too often in the block
  bool add(Address address, double value);
  /// A step has written a word.
  void add_computed() { has_words_ = true; }
  /// M2, M17 and M30 end the program behind everything else in their block.
  void end_with(OpCode end) { ends_with_ = end; }

  [[nodiscard]] bool has_words() const { return has_words_; }
  /// The block is through: it executes its words.
  void execute(ShortSpan block);
  /// And then ends the program, if it says so.
  void end(ShortSpan block);

  /// What the block has left so far is worth nothing.
  void take_back();
  /// The same of its words alone.
  void take_back_words();

 private:
  CompiledProgram& program_;
  CodeWriter& code_;
  NcBlock nc_;  ///< where codes and words of the block begin
  bool has_words_ = false;
  OpCode ends_with_ = OpCode::Move;  ///< Return or EndProgram behind the words of the block
};

}  // namespace g31::sinumerik
