#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/state/variables.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/source/location.h"

namespace g31::fanuc {

enum class CallKind {
  Main,
  Subprogram,  ///< M98: shares the caller's locals
  Macro,       ///< G65: locals of its own
};

/// What called a program; in one that a code called, such codes are ordinary (MB-208).
enum class CalledBy {
  Program,
  GCode,
  Address,  ///< M, T, S, B and the like
};

/// Where a called program comes from.
enum class Storage {
  Memory,
  External  ///< M198
};

/// G66 or G66.1 in force.
struct ModalCall {
  const CompiledProgram* program = nullptr;
  int repeats = 1;
  bool every_block = false;  ///< G66.1: each NC block becomes a call
  /// The arguments at first; after a call of G66 what its macro left in them (MB-204).
  Variables::Locals locals;
};

/// How a program is entered.
struct Entry {
  const CompiledProgram* program = nullptr;
  CallKind kind = CallKind::Macro;
  CalledBy by = CalledBy::Program;
  int repeats = 1;
  syntax::Index first_step = 0;
  Storage storage = Storage::Memory;
};

/// One level of the call stack.
struct Frame {
  const CompiledProgram* program = nullptr;
  syntax::Index step = 0;  ///< the next to execute
  syntax::Index current = 0;
  syntax::Index first_step = 0;  ///< where each repeat begins
  CallKind kind = CallKind::Main;
  CalledBy by = CalledBy::Program;
  Storage storage = Storage::Memory;
  int repeats_left = 0;
  std::uint64_t number = 0;  ///< as runtime::CallLevel has it
  /// Modal calls that motion in this program sets off, the last first; inside a modal call the
  /// outer ones are left (MB-204).
  std::vector<std::shared_ptr<ModalCall>> modal_calls;
  std::shared_ptr<ModalCall> of_modal_call;  ///< the one that called this program, if any
};

/// As reports name it.
std::string name_of(const CompiledProgram& program);

/// The levels of calls of a run, and where in them it stands.
class CallStack {
 public:
  /// Only the main program, at its first step.
  void start(const CompiledProgram& main);
  [[nodiscard]] bool has_begun() const { return !frames_.empty(); }

  /// The running level.
  [[nodiscard]] Frame& frame() { return frames_.back(); }
  [[nodiscard]] const Frame& frame() const { return frames_.back(); }
  /// All, the main program first.
  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }
  /// The one that has called the running one.  @pre depth() > 0
  [[nodiscard]] Frame& caller() { return frames_[frames_.size() - 2]; }
  [[nodiscard]] const Frame& caller() const { return frames_[frames_.size() - 2]; }
  [[nodiscard]] std::size_t depth() const { return frames_.size() - 1; }
  [[nodiscard]] int count(CallKind kind) const;
  /// A new level; those before it may have moved.
  Frame& push();
  void pop() { frames_.pop_back(); }

  /// Whether the program is through.
  [[nodiscard]] bool has_ended() const { return has_ended_; }
  void end() { has_ended_ = true; }

  // What reports show of it

  /// A place of the running program.
  [[nodiscard]] source::Location location(syntax::ShortSpan span) const;
  /// The running block, and the one in which a level waits.
  [[nodiscard]] source::Location here() const { return location_of(frames_.back()); }
  static source::Location location_of(const Frame& frame);
  /// All levels as they stand, the innermost first.
  [[nodiscard]] std::vector<runtime::CallLevel> levels() const;
  /// Which level of local variables a level of calls has; 0: the main program's.
  /// @param level  0: the innermost
  [[nodiscard]] std::size_t locals_of(std::size_t level) const;

 private:
  std::vector<Frame> frames_;
  std::uint64_t begun_ = 0;  // frames
  bool has_ended_ = false;
};

}  // namespace g31::fanuc
