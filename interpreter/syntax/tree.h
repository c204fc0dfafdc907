#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/source/source_file.h"

namespace g31::syntax {

/// The tree of one file, flat: nodes of a kind stand in one vector and know each other by index.
/// Parsing a million blocks is then a few appends per block, and freeing them is free.
using Index = std::uint32_t;
inline constexpr Index kNone = ~Index{0};

/// 32-bit offsets: half the size of source::Span where millions are kept.
struct ShortSpan {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  [[nodiscard]] source::Span widened() const { return {begin, end}; }
};

enum class Operator : std::uint8_t {
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
};

enum class ExprKind : std::uint8_t {
  Number,    ///< `number`
  Variable,  ///< #`a`, where a is the expression of the number
  Name,      ///< the variable that the text of `span` names; `a` its index or kNone
  Logic,     ///< conditions `a` and `b` joined by the symbol of `op`
  Negate,    ///< -`a`
  Binary,    ///< `a` op `b`
  Call,      ///< function `function` of `a`, or of `a` and `b`; `c` the axis of PRM
};

struct Expr {
  ExprKind kind = ExprKind::Number;
  Operator op = Operator::Add;  ///< of a Call: Divide where `b` stands behind a slash
  std::uint8_t function = 0;    ///< row of the dialect's function table
  std::uint8_t digits = 0;      ///< Number: digits written, leading and trailing zeros too
  Index a = kNone;
  Index b = kNone;
  Index c = kNone;
  double number = 0.0;
  ShortSpan span;
};

/// How a word's value was written; decides what a number without a point means.
enum class ValueForm : std::uint8_t {
  None,
  Integer,
  Decimal,
  Computed,
  Name,  ///< `<BORE>` in the place of P and the number of a program; `span` is all of it
};

/// The addresses ,C and ,R have the two places behind Z.
inline constexpr char kChamferWord = 'Z' + 1;
inline constexpr char kRoundingWord = 'Z' + 2;
inline constexpr int kLetterCount = kRoundingWord - 'A' + 1;

/// The bit that stands for an address among several.
constexpr std::uint32_t letter_bit(char letter) {
  return std::uint32_t{1} << (letter - 'A');
}

/// How an address is written.
inline std::string letter_text(char letter) {
  return letter == kChamferWord ? ",C" : letter == kRoundingWord ? ",R" : std::string(1, letter);
}

/// An address letter and its value; letter `/` is a block skip in the middle of a block, the number
/// its switch.
struct Word {
  char letter = 0;
  ValueForm form = ValueForm::None;
  std::uint8_t digits = 0;    ///< digits written, leading and trailing zeros too
  std::uint8_t decimals = 0;  ///< those behind the point
  double number = 0.0;        ///< Integer and Decimal
  Index expr = kNone;         ///< Computed
  bool is_bare = false;       ///< Computed: X#1+10, an expression without brackets
  ShortSpan span;
};

enum class BlockKind : std::uint8_t {
  Empty,     ///< only N, comments or nothing
  Nc,        ///< words
  Assign,    ///< `target` = `value`
  Goto,      ///< GOTO `value`
  IfGoto,    ///< IF `condition` GOTO `value`
  IfThen,    ///< IF `condition` THEN: the next block of the vector is the statement
  While,     ///< WHILE `condition` DO `number`
  Do,        ///< DO `number`
  End,       ///< END `number`
  Output,    ///< POPEN, PCLOS, DPRNT, BPRNT; `number` is the row, `text` the format
  SetNames,  ///< SETVN
  Bad,       ///< not to be understood; `number` is the row of the error
};

struct Block {
  BlockKind kind = BlockKind::Empty;
  std::uint8_t skip_switch = 0;  ///< 0: none; n for /n
  bool is_bare = false;        ///< IfThen without THEN, or without IF, too; Assign without a value
  bool goes_on = false;        ///< Nc: what the next one holds stands behind its words
  bool is_plain = false;       ///< Nc: its words are letters and written numbers, without `/`
  std::uint8_t digits = 0;     ///< of plain words: a bound, no number has more of them
  bool begins_loop = false;    ///< Bad: it was to be While or Do
  std::uint32_t letters = 0;   ///< of plain words: a bit for each address, A is the lowest
  std::int32_t sequence = -1;  ///< N number, -1: none
  std::int32_t number = 0;
  Index first_word = 0;
  Index word_count = 0;
  Index target = kNone;
  Index value = kNone;
  Index condition = kNone;
  ShortSpan text;  ///< format of an output statement, or the comment behind an assignment
  ShortSpan span;  ///< without the line end
};

/// A program of the file: a run of blocks.
struct Program {
  std::int32_t number = 0;  ///< 0: the file begins without O
  Index first_block = 0;
  Index block_count = 0;
  ShortSpan name;  ///< `O9010`, `<BORE>`
};

/// Why a block could not be understood: the dialect's error row, place, and words for people.
struct SyntaxError {
  int error = 0;
  ShortSpan where;
  std::string message;
};

/// Everything that the parser found in one file.
struct Tree {
  std::vector<Program> programs;
  std::vector<Block> blocks;
  std::vector<Word> words;
  std::vector<Expr> exprs;
  std::vector<SyntaxError> errors;
  std::uint32_t end = 0;  ///< where reading ended: the end of the text, or a `%` before it
};

}  // namespace g31::syntax
