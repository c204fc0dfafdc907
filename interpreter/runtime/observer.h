#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/runtime/alarm.h"
#include "interpreter/source/latin_1.h"
#include "interpreter/source/location.h"
#include "machine/port/machine_port.h"

namespace g31::runtime {

/// One executed motion or dwell, as the result document lists it.
struct MoveEvent {
  int g = 0;                    ///< 0, 1, 2, 3, 31, or 4 for a dwell
  AxisPositions q_M_to;         ///< where the axes ended, machine coordinates
  double feed_mm_min = 0.0;     ///< 0 for rapid
  double seconds = 0.0;         ///< only for g = 4
  source::Location where = {};  ///< the block that commands it
};

/// How the control shows a place of the machine, and where the move was to end.
struct ProgramView {
  /// Work coordinates of the tool's tip: of a Fanuc those that #5061 counts in, which G68 and G51
  /// do not turn; of SINUMERIK those of all frames.
  AxisPositions q_L = AxisPositions::Zero();
  AxisPositions q_L_commanded = AxisPositions::Zero();  ///< of the end
  std::optional<int> tool;      ///< in the spindle; nullopt: no program has said
  std::vector<CallSite> calls;  ///< of the block, innermost first
};

/// One skip move and what became of it.
struct TouchEvent {
  std::string_view block;  ///< the measuring word: "G31", "MEAS"
  source::Location where;
  bool triggered = false;
  AxisPositions q_M_from;  ///< where the move began
  AxisPositions q_M_commanded;
  AxisPositions q_M_latched;
  AxisPositions q_M_stopped;
  std::optional<machine::Contact> contact;
  double feed_mm_min = 0.0;
  int signals = 1;      ///< how often the signal came; the first was latched
  double time_s = 0.0;  ///< machine time at its end
  ProgramView view;     ///< of the latched position
};

/// A move that a fault has ended: a collision, or a soft limit.
struct FaultEvent {
  std::string what;  ///< one line: the bodies that met, or axis and limit
  AxisPositions q_M_at;
  /// The move: 0, 1, 2, 3 or 31, its end and its feed; nullopt where the fault of a move that had
  /// passed on is found later.
  std::optional<MoveEvent> move;
  source::Location where;  ///< its block
  std::optional<machine::Contact> contact;
  ProgramView view;  ///< of q_M_at
};

/// A programmed stop: #3006, M00, M01.
struct StopEvent {
  std::string kind;
  std::string text;
  source::Location where;
};

/// What a program tells the builder's part of the machine or the management of tools; no axis moves
/// for it.
struct RecordedEvent {
  struct Value {
    std::string_view name;  ///< as the document has it
    double number = 0.0;
  };
  std::string_view kind;  ///< "m_code", "tool_life", "tool_life_deleted"
  std::vector<Value> values;
  source::Location where;  ///< its block
  double time_s = 0.0;     ///< machine time
};

/// Text that leaves the program.
struct OutputEvent {
  std::string_view text;
  source::Location where;                     ///< the block that writes it
  source::AsUtf8 as_utf8 = &source::as_utf8;  ///< what brings it to people
};

/// Hears what a running program does, in order.  Whoever runs the program decides what becomes of
/// it: a document, a trace, a line on the terminal.  Every function may be left as it is.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  virtual void on_move(const MoveEvent&) {}
  /// The last moves did not take place: the one before them ended in a fault that came late.
  virtual void on_moves_undone(std::uint64_t /*count*/) {}
  virtual void on_touch(const TouchEvent&) {}
  /// The last thing that a run does: no move ends behind it.
  virtual void on_fault(const FaultEvent&) {}
  virtual void on_stop(const StopEvent&) {}
  virtual void on_event(const RecordedEvent&) {}
  /// The axes have come to rest where the program has them, and it waits for that (STOPRE).
  virtual void on_standstill(source::Location /*where*/) {}
  /// Bytes for the printer port (DPRNT).
  virtual void on_output(const OutputEvent&) {}
  /// A line for the operator (MSG), one byte a character; it stands among the printouts.
  virtual void on_message(const OutputEvent& event) { on_output(event); }
};

}  // namespace g31::runtime
