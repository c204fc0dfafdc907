#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/op_code.h"
#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/nested_steps.h"
#include "interpreter/syntax/tree.h"

namespace g31::sinumerik {

using syntax::ShortSpan;

/// Where an operand stands.  Numbers, texts and frames have the same four banks each, every one an
/// array: fetching an operand takes no decision.
enum class Bank : std::uint8_t {
  Constants,    ///< of the program
  Locals,       ///< of the call level: what DEF and PROC made
  Globals,      ///< R parameters and GUD
  Temporaries,  ///< results within one block
};

struct Operand {
  Bank bank = Bank::Constants;
  std::int32_t place = 0;
};

/// Which labels a jump looks at.
enum class Direction : std::uint8_t { Forward, Backward, Both, BothQuiet };

struct Op {
  OpCode code = OpCode::Move;
  std::uint8_t detail = 0;  ///< what op_codes.def says: detail_of() a row, or a small number
  std::uint16_t count = 0;
  Operand result;
  Operand a;
  Operand b;
};

/// `detail` of AxisMeasuring: b is the second trigger.
inline constexpr std::uint8_t kSecondTrigger = 2;

/// When a synchronised action acts.
enum class ActionKind : std::uint8_t {
  Once,   ///< WHEN: the first time that its condition holds
  While,  ///< WHENEVER: each time
  From,   ///< FROM: from the first time on
  Edge,   ///< EVERY: each time that it begins to hold
  Always  ///< DO without a condition
};
/// How long it is in force.
enum class ActionScope : std::uint8_t { NextBlock, Modal, Static };
inline constexpr int kActionScopes = 3;

/// What `detail` keeps; no table may have more rows than it can tell apart.
template <typename Id>
constexpr std::uint8_t detail_of(Id id) {
  static_assert(std::is_enum_v<Id> && sizeof(Id) <= sizeof(Op::detail));
  return static_cast<std::uint8_t>(id);
}

enum class Storage : std::uint8_t {
  Local,
  Global,
  Reference,  ///< a VAR parameter: stands in the level's references
  OfMain,     ///< PUD: a local variable of the main program, found there by its name
};

/// LLI and ULI of a DEF: what a variable takes.
struct Limits {
  std::optional<double> low;
  std::optional<double> high;
};

/// A variable as a program sees it.
struct Variable {
  std::string name;
  Type type = Type::Real;
  Storage storage = Storage::Local;
  std::int32_t place = 0;  ///< of its first element in its bank
  Shape shape;
  std::int32_t longest = 0;  ///< STRING[n]: n
  Limits limits;
  DatumUnit unit = DatumUnit::Plain;
  std::optional<double> fixed;  ///< a datum that is kept: the value that g31 goes on as with
  bool is_watched = false;      ///< a datum that counts once it is written
  bool is_by_axis = false;      ///< its last index is an axis: rotary axes count in degrees
};

/// Where variables have their values: numbers, texts and frames each in a row of their own.
struct Layout {
  std::vector<double> numbers;  ///< before the first write
  std::int32_t texts = 0;
  std::int32_t frames = 0;

  /// Makes room for one more.  @returns the place of its first element
  std::int32_t add(Type type, std::int32_t count) {
    if (type == Type::String) {
      return std::exchange(texts, texts + count);
    }
    if (type == Type::Frame) {
      return std::exchange(frames, frames + count);
    }
    const auto place = static_cast<std::int32_t>(numbers.size());
    numbers.resize(numbers.size() + static_cast<std::size_t>(count), initial_number(type));
    return place;
  }

  /// About as much memory as elements take, texts as long as they may be.
  static std::size_t bytes_of(Type type, std::int32_t count) {
    const int each = type == Type::String ? 240 : type == Type::Frame ? 480 : 8;
    return static_cast<std::size_t>(each) * static_cast<std::size_t>(count);
  }
  [[nodiscard]] std::size_t bytes() const {
    return bytes_of(Type::Real, static_cast<std::int32_t>(numbers.size())) +
           bytes_of(Type::String, texts) + bytes_of(Type::Frame, frames);
  }
};

/// An argument of a call, a function or a list.
struct Argument {
  enum class Form : std::uint8_t { Omitted, Value, Element, Whole };
  Form form = Form::Omitted;
  Type type = Type::None;
  Operand value;               ///< Value and Element: what it is worth now
  std::int32_t variable = -1;  ///< Element, Whole: of variables
  Operand element;             ///< Element: its number in the array
  ShortSpan where;
};

/// A call of a program by name, P times.
struct CallSite {
  std::string name;  ///< empty: the name is text
  Operand text;
  Operand passes;
  bool has_arguments = false;
  bool is_modal = false;  ///< MCALL
  bool is_part = false;   ///< CALL text BLOCK first TO last
  Operand first_label;    ///< texts
  Operand last_label;
  std::uint32_t first_argument = 0;
  std::uint32_t argument_count = 0;
};

/// What PROC says of one parameter.
struct Parameter {
  std::int32_t variable = 0;  ///< of variables
  bool by_reference = false;
  bool has_preset = false;
  double number = 0.0;  ///< the preset value
  std::string text;
};

/// REPEAT label, REPEAT start end, REPEATB label.
struct RepeatSite {
  std::int32_t first = -1;   ///< steps; -1: label missing
  std::int32_t end = -1;     ///< behind the last step of the part
  std::string missing = {};  ///< the label that there is not
};

struct CompiledProgram;

/// A word of an NC block whose value is known when compiling.
struct ConstantWord {
  double value = 0.0;
  Address address = Address::FirstAxis;
};

/// G codes (packed) and constant words of an NC block: where they stand in the program's lists.
struct NcBlock {
  std::uint32_t first_code = 0;
  std::uint32_t first_word = 0;
  std::uint16_t code_count = 0;
  std::uint16_t word_count = 0;

  [[nodiscard]] std::span<const std::uint16_t> codes_of(const CompiledProgram& program) const;
  [[nodiscard]] std::span<const ConstantWord> words_of(const CompiledProgram& program) const;
};

/// Something wrong in a block that matters only when the program gets there.
struct BlockError {
  AlarmId id = AlarmId::SyntaxInText;
  std::string detail;
  bool follows = false;  ///< from a mistake in a block before, which is told there
};

/// A datum of an INI file that this control of g31 does not have.
struct UnknownDatum {
  std::string name;
  ShortSpan where;
};

/// N and its number.
struct BlockNumber {
  std::int32_t number = 0;
  std::int32_t step = 0;
};

/// Condition and actions of a synchronised action as steps, for those who look at programs: a run
/// compiles their texts when it takes the action.
struct ActionSteps {
  std::int32_t step = 0;  ///< SynchronisedAction
  std::vector<Op> ops;
  std::vector<ShortSpan> spans;  ///< one per op
};

/// One program, ready to run.
struct CompiledProgram {
  std::string name;    ///< "PART1"
  std::string folder;  ///< of $PATH; empty: not said
  std::string type;    ///< "MPF", "SPF"; empty: not said
  const source::SourceFile* file = nullptr;
  std::vector<Op> ops;
  std::vector<ShortSpan> spans;  ///< one per op
  std::vector<double> constants;
  std::vector<std::string> text_constants;
  std::vector<Variable> variables;
  std::vector<Argument> arguments;
  std::vector<CallSite> calls;
  std::vector<ActionSteps> actions;  ///< in the order of their steps
  std::vector<RepeatSite> repeats;
  std::vector<NcBlock> nc_blocks;
  std::vector<std::uint16_t> codes;
  std::vector<ConstantWord> words;
  std::vector<BlockError> errors;
  std::vector<UnknownDatum> unknown_data;     ///< each name once
  NameMap<std::vector<std::int32_t>> labels;  ///< their steps, rising
  std::vector<BlockNumber> block_numbers;     ///< rising, those of one number by their step
  syntax::NestedSteps bodies;                 ///< of loops and of the branches of IF
  NameMap<std::int32_t> locals;               ///< names of local variables
  Layout layout;                              ///< of a new level
  std::vector<Parameter> parameters;
  Argument result;  ///< of a program that is one expression
  /// A subprogram of a user: those of the main program are its variables, too.
  bool sees_main = false;
  bool leads = false;  ///< a main program, which subprograms see variables of
  bool has_proc = false;
  bool has_wrong_proc = false;      ///< whose alarm comes before any of its arguments
  bool reads_block_time = false;    ///< $AC_TIME
  bool saves_codes = false;         ///< SAVE
  bool hides_blocks = false;        ///< DISPLOF
  bool shows_actual_block = false;  ///< ACTBLOCNO
};

inline std::span<const std::uint16_t> NcBlock::codes_of(const CompiledProgram& program) const {
  return std::span(program.codes).subspan(first_code, code_count);
}
inline std::span<const ConstantWord> NcBlock::words_of(const CompiledProgram& program) const {
  return std::span(program.words).subspan(first_word, word_count);
}

/// Where a piece of a program stands.
inline source::Location location_in(const CompiledProgram& program, ShortSpan span) {
  return program.file->at(span.widened());
}

/// The step of a jump from `from` to a label or "N100"; nullopt: there is none that way.
std::optional<std::int32_t> find_label(const CompiledProgram& program, std::string_view name,
                                       std::int32_t from, Direction direction);

/// The blocks from one label to another behind it; nullopt: one of them is missing.
/// @param from  the step from which the first one is looked for
std::optional<RepeatSite> find_part(const CompiledProgram& program, std::string_view first,
                                    std::string_view last, std::int32_t from);

/// More results than a block can need at a time.
inline constexpr std::int32_t kTemporaryCount = 256;

}  // namespace g31::sinumerik
