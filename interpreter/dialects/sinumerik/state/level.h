#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/state/frame.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {

/// A variable of a caller behind a VAR parameter: where it is, not its memory.
struct Reference {
  Type type = Type::None;
  bool is_global = false;
  std::size_t level = 0;   ///< whose local variable it is, unless it is global; 0: the main program
  std::int32_t place = 0;  ///< among the numbers, texts or frames, by its type
  Shape shape;
  std::int32_t longest = 0;
  DatumUnit unit = DatumUnit::Plain;
  bool is_by_axis = false;
  std::size_t first = 0;  ///< which element of the variable it begins with

  /// The axis of an element; nullopt: it is of none.
  [[nodiscard]] std::optional<int> axis(std::size_t element) const {
    return is_by_axis ? std::optional(static_cast<int>((first + element) % kAxisCount))
                      : std::nullopt;
  }

  friend bool operator==(const Reference&, const Reference&) = default;
};

/// What a call gives for one parameter.
struct BoundValue {
  Argument::Form form = Argument::Form::Omitted;
  Type type = Type::None;
  double number = 0.0;
  std::string text;
  std::shared_ptr<const Frame> frame;  ///< a copy: passes and modal calls take it later
  Reference reference;
};

/// One running part of REPEAT, or of a program that runs for it alone.
struct RunningPart {
  static constexpr std::int32_t kWholeLevel = -1;  ///< behind it the level is left
  static constexpr std::int32_t kByText = -2;      ///< of CALL BLOCK with texts, once
  std::int32_t site = 0;
  std::int32_t end = 0;      ///< behind its last step
  std::int32_t back_to = 0;  ///< the step behind REPEAT
  std::int32_t passes_left = 0;
};

/// A program that waits for the text of EXECSTRING on its own level.
struct WaitingProgram {
  const CompiledProgram* program = nullptr;
  std::int32_t step = 0;
  std::vector<RunningPart> parts;
};

/// One program level.
struct Level {
  /// Local variables as DEF and PROC leave them.
  void make_locals() {
    const Layout& layout = program->layout;
    numbers.assign(layout.numbers.begin(), layout.numbers.end());
    texts.assign(static_cast<std::size_t>(layout.texts), std::string());
    frames.assign(static_cast<std::size_t>(layout.frames), Frame());
  }

  const CompiledProgram* program = nullptr;
  std::int32_t step = 0;
  std::uint64_t number = 0;  ///< as runtime::CallLevel has it
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::vector<Frame> frames;
  std::vector<Reference> references;
  std::vector<bool> given;  ///< $P_SUBPAR
  std::vector<RunningPart> parts;
  std::vector<WaitingProgram> waiting;
  std::vector<BoundValue> arguments;  ///< kept for further passes
  std::int32_t passes_left = 0;
  bool is_modal_call = false;
  GroupNumbers saved_group;  ///< SAVE
  Frame saved_frame;
  std::optional<Frame> saved_settable;  ///< MD10617 bit 0

  /// Whether its parameters stand for something: a wrong PROC takes no arguments, and behind the
  /// VAR parameters of a main program there is nothing.
  [[nodiscard]] bool has_arguments() const {
    const CompiledProgram& own = *own_place().first;
    const auto wanted = std::ranges::count_if(own.parameters, &Parameter::by_reference);
    return !own.has_wrong_proc && references.size() == static_cast<std::size_t>(wanted);
  }

  /// Where it stands in its own program, which may wait for a text.
  [[nodiscard]] std::pair<const CompiledProgram*, std::int32_t> own_place() const {
    return waiting.empty() ? std::pair(program, step)
                           : std::pair(waiting.front().program, waiting.front().step);
  }

  /// Back to the program that waits for its EXECSTRING, wherever the text stands.
  void leave_texts() {
    if (!waiting.empty()) {
      WaitingProgram own = std::move(waiting.front());
      waiting.clear();
      program = own.program;
      step = own.step;
      parts = std::move(own.parts);
    }
  }
};

}  // namespace g31::sinumerik
