#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/block_reader.h"
#include "interpreter/dialects/sinumerik/code/code_writer.h"
#include "interpreter/dialects/sinumerik/code/expr.h"

namespace g31::sinumerik {

/// What a text is that is compiled.
enum class Purpose { Program, Definitions, Data };

/// What all parts of a compiler share: the block that they read and the program that they write.
struct BlockWork {
  BlockReader& reader;
  CompiledProgram& program;
  CodeWriter& code;
};

/// Of a part of the compiler: the block that it reads and the program that it writes.
class BlockPart {
 protected:
  /// What is in `work` outlives the part.
  explicit BlockPart(const BlockWork& work)
      : reader_(work.reader),
        cursor_(work.reader.cursor),
        program_(work.program),
        code_(work.code) {}

  // The block
  [[nodiscard]] ShortSpan block() const { return reader_.block(); }
  void fail(AlarmId id, ShortSpan where, std::string_view detail = {}) {
    reader_.fail(id, where, detail);
  }
  void fail(AlarmId id, std::string_view detail = {}) { reader_.fail(id, detail); }
  [[nodiscard]] bool failed() const { return reader_.failed(); }
  void expect(Symbol symbol) { reader_.expect(symbol); }
  void expect_end() { reader_.expect_end(); }
  [[nodiscard]] std::string text_of(ShortSpan where) const { return reader_.text_of(where); }

  // The program
  /// A place for a result; fails where there is none left.
  Operand temporary(Type type);
  /// @pre a number that is constant
  [[nodiscard]] double number_of(const Expr& constant) const {
    return program_.constants[static_cast<std::size_t>(constant.value.place)];
  }
  std::uint32_t keep_arguments(const std::vector<Argument>& list);
  /// @param jump  step of a jump; below 0: there is none
  void set_target(std::int32_t jump, std::int32_t target);

  BlockReader& reader_;
  TokenCursor& cursor_;
  CompiledProgram& program_;
  CodeWriter& code_;
};

/// What a call gives of an expression.
Argument argument_of(const Expr& expr);

}  // namespace g31::sinumerik
