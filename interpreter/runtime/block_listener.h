#pragma once

#include <cstdint>
#include <string>

#include "interpreter/runtime/shown_value.h"
#include "interpreter/source/location.h"

namespace g31::runtime {

/// A block that is about to begin.
struct BlockPlace {
  source::Location where;    ///< its text
  std::uint16_t depth = 0;   ///< levels of calls above it; 0: the main program
  bool is_shown = true;      ///< false: its program hides its blocks (DISPLOF)
  bool is_skipped = false;   ///< block skip is on for it: it counts, and does nothing
  std::uint64_t number = 0;  ///< from 1, in the order of the run
};

/// A variable that a program has assigned to.
struct WriteEvent {
  std::string name;        ///< as programs write it: "#100", "R5", "_OVR[3]", "$TC_DP6[1,1]"
  ShownValue before;       ///< vacant where the control does not let it read
  ShownValue now;          ///< what the control has made of it
  source::Location where;  ///< the assignment
};

/// What becomes of a block.
enum class Verdict : std::uint8_t {
  Run,
  Pause,  ///< before it begins; the run can be advanced from here
  Stop,   ///< the run ends before it
};

/// Hears of each block before it begins.  A run is a function of its job and its seed: the same
/// blocks with the same numbers come in every run of it, whatever the listener does at pauses.
class BlockListener {
 public:
  BlockListener() = default;
  BlockListener(const BlockListener&) = delete;
  BlockListener& operator=(const BlockListener&) = delete;
  virtual ~BlockListener() = default;

  virtual Verdict on_block(const BlockPlace& place) = 0;
  /// A call or a return: the levels of calls from here on, and the program that they are in.
  virtual void on_level(std::uint16_t /*depth*/, const std::string& /*program*/) {}

  /// Whether on_write() and on_condition() are to be called; asked once, when a run begins.  What
  /// nobody hears costs nothing.
  [[nodiscard]] virtual bool hears_writes() const { return false; }
  /// An assignment was made, whatever the value was before; or a procedure has changed the variable
  /// for its result.  Arguments of calls are none, nor frames as a whole.
  virtual void on_write(const WriteEvent&) {}
  /// The condition of a block (IF, WHILE, UNTIL, one more pass of FOR, a row of CASE) was asked.
  virtual void on_condition(const source::Location& /*where*/, bool /*is_met*/) {}
};

}  // namespace g31::runtime
