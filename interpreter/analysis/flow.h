#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/source/diagnostic.h"
#include "interpreter/source/location.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/tree.h"

namespace g31::analysis {

/// A block of a Flow, by its place among them.
using BlockIndex = std::uint32_t;

/// Consecutive rows of one of the lists of a Flow.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  friend bool operator==(const Range&, const Range&) = default;
};

/// Why one block follows another.
enum class EdgeKind : std::uint8_t {
  Next,  ///< it stands behind it; the statement of a THEN stands behind its IF
  Jump,  ///< GOTO and its like, branches, and ends of loops
  Part,  ///< into a part that REPEAT runs, once more through it, and on behind REPEAT
};

struct Edge {
  BlockIndex to = 0;
  EdgeKind kind = EdgeKind::Next;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// How a program may be left at a block.  Several may hold: M30 behind a / may end it or not.
struct Leaves {
  bool by_end = false;          ///< M02, M30: the run ends; of a SINUMERIK subprogram its return
  bool by_return = false;       ///< M99, M17, RET, the end of a SINUMERIK text; a main program of a
                                ///< Fanuc goes on at its first block
  bool by_alarm = false;        ///< always: #3000, or a block that is wrong (its Fault)
  bool by_running_out = false;  ///< nothing stands behind the last block, which is an alarm (Fanuc)
  friend bool operator==(const Leaves&, const Leaves&) = default;
};

/// One NC block, as the control counts them: words, or one statement.  The statement of a Fanuc
/// THEN is a block of its own.  The last block of a SINUMERIK program is the end of its text.
struct Block {
  syntax::ShortSpan span;  ///< without the line end
  Range edges;             ///< of Flow::edges: blocks that may follow, rising, each once
  Range faults;
  Range calls;
  Range accesses;  ///< in the order of the text, or of evaluation
  Range moves;     ///< none or one
  Leaves leaves;
  bool to_any_label = false;  ///< the target of its jump is known when running: a block of `labels`
};

/// One text in the place of another, which mends a fault for certain.
struct Repair {
  std::string title;  ///< what it does: "write GOTOB"
  syntax::ShortSpan where;
  std::string text;
};

/// What is wrong with a block, as the control will say when it gets there.
struct Fault {
  enum class Kind : std::uint8_t {
    Block,         ///< cannot be understood, or the control has no such thing
    Target,        ///< the block or the label that it jumps to is not there
    End,           ///< nothing stands behind the last block, and nothing in it ended the program:
                   ///< what it calls may
    NotSimulated,  ///< g31 does not run this yet; a control does
    Comparison,    ///< no fault of the block: it compares otherwise than it looks
    LostPoint,     ///< the same: a number is read otherwise than it looks
    SurplusEnd,    ///< the same: it ends what has not begun, which the control passes over
  };
  Kind kind = Kind::Block;
  int alarm = 0;  ///< its number on the control; 0: none
  syntax::ShortSpan where;
  std::string message;  ///< text of the alarm and what it is about
  std::string remedy;
  std::optional<Repair> repair = {};
};

/// A call of another program, or its preparation.
struct Call {
  enum class Kind : std::uint8_t {
    Subprogram,  ///< M98, M198, L, the program's name, CALL: once or P times
    Macro,       ///< G65
    Modal,       ///< G66, MCALL: blocks behind this one make the calls
  };
  Kind kind = Kind::Subprogram;
  std::string target;    ///< "O9010", "CYCLE977"; empty: known when running
  bool by_text = false;  ///< CALL "NAME": the target is a text
  syntax::ShortSpan where;

  /// The block at which the program is to begin.
  struct Start {
    std::int32_t sequence = 0;
    syntax::ShortSpan where;
  };
  std::optional<Start> start;  ///< nullopt: its first, or known when running
};

/// A variable as a program names it.
struct Variable {
  enum class Scope : std::uint8_t {
    Local,     ///< of a call of the program
    Global,    ///< of all programs: common variables, R parameters, GUD
    System,    ///< what the control keeps: #5061, $AA_MW
    Computed,  ///< known when running: #[...] as "#[]", [#NAME] by what is written
  };
  Scope scope = Scope::Local;
  std::string name;  ///< "#100", "R", "_OVR", "$AA_MW"
  friend auto operator<=>(const Variable&, const Variable&) = default;
};

/// In the place of an element's number: there is but one, or only a run knows which.
inline constexpr std::int32_t kWholeVariable = -1;

/// What a block does with a variable.
struct Access {
  enum class Kind : std::uint8_t {
    Read,
    Write,
    HandOver,  ///< to a call: the program called reads it, and writes it if its parameter is VAR
  };
  Kind kind = Kind::Read;
  std::uint32_t variable = 0;             ///< of Flow::variables
  std::int32_t element = kWholeVariable;  ///< of an array, counted from 0: R5, _OVR[5]
  syntax::ShortSpan where;
};

/// An axis of a move and where it goes, as the program writes it: absolute or not, in the units and
/// coordinates in force.
struct AxisTarget {
  char letter = '?';         ///< '?': an axis that only a run knows
  bool is_computed = false;  ///< only a run knows the value
  double value = 0.0;
  syntax::ShortSpan where;
};

/// The motion that the words of a block command.
struct Move {
  enum class Kind : std::uint8_t {
    AsBefore,   ///< by the code that is in force: G0, G1, G2, G3, a canned cycle
    Rapid,      ///< G0
    Line,       ///< G1
    Arc,        ///< G2, G3, CIP, CT
    Measuring,  ///< G31, G37, MEAS, MEASA: a signal may end it
    Reference,  ///< G27 to G30, G74, G75
    Cycle,      ///< a canned cycle, a thread
  };
  Kind kind = Kind::AsBefore;
  Range axes;  ///< of Flow::axes; none: polar coordinates
};

/// A block that jumps can name: its sequence number or label.
struct Label {
  std::string name;  ///< "N100", "REPEAT_IT"
  BlockIndex block = 0;
};

/// Files that a program writes, and may call then.
struct WrittenFiles {
  bool has_unknown = false;        ///< a name that a run works out
  std::vector<std::string> names;  ///< of programs: "LOG"
};

/// One picture of a program, the same for every dialect: what check, coverage and planning look
/// at.  Plain values; spans are offsets in `file`.
///
/// Blocks stand in the order of the text, and a run begins at the first.  Every block that a run
/// executes behind another one, in the same call of the program, is at the end of one of its edges,
/// or a label where it is `to_any_label`, with these exceptions: blocks that belong to the call of
/// another program stand in that program's flow; a repeated call starts again at the first block,
/// or at its label (M97 P L); a called program may send its caller to a label or behind it (M99 P,
/// RET with a target); the head of a SINUMERIK loop is asked again without being executed again; a
/// text that EXECSTRING runs has blocks of its own, and may end the program.  Not every edge can be
/// taken: conditions are followed both ways unless they are constants.
struct Flow {
  std::string program;                       ///< "O9010", "CYCLE977"; empty: a Fanuc text without O
  const source::SourceFile* file = nullptr;  ///< outlives the flow
  std::vector<Block> blocks;
  std::vector<Edge> edges;
  std::vector<Fault> faults;
  std::vector<Call> calls;
  std::vector<Variable> variables;  ///< each once, in the order of their first accesses
  std::vector<Access> accesses;
  std::vector<Move> moves;
  std::vector<AxisTarget> axes;
  std::vector<Label> labels;  ///< in the order of their blocks
  WrittenFiles written;

  [[nodiscard]] std::span<const Edge> edges_of(const Block& block) const {
    return std::span(edges).subspan(block.edges.first, block.edges.count);
  }
  [[nodiscard]] std::span<const Fault> faults_of(const Block& block) const {
    return std::span(faults).subspan(block.faults.first, block.faults.count);
  }
  [[nodiscard]] std::span<const Call> calls_of(const Block& block) const {
    return std::span(calls).subspan(block.calls.first, block.calls.count);
  }
  [[nodiscard]] std::span<const Access> accesses_of(const Block& block) const {
    return std::span(accesses).subspan(block.accesses.first, block.accesses.count);
  }
  [[nodiscard]] std::span<const Move> moves_of(const Block& block) const {
    return std::span(moves).subspan(block.moves.first, block.moves.count);
  }
  [[nodiscard]] std::span<const AxisTarget> axes_of(const Move& move) const {
    return std::span(axes).subspan(move.axes.first, move.axes.count);
  }
};

/// For each block, whether a way of edges and labels leads to it from the first one.  Behind a
/// block that is wrong it goes on with the next one, as it will when the block is mended.
std::vector<bool> reached_blocks(const Flow& flow);

}  // namespace g31::analysis
