#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "interpreter/path/path_block.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/observer.h"
#include "machine/base/result.h"
#include "machine/port/machine_port.h"

namespace g31::path {

/// The way out of an interpreter: blocks of motion and pauses, compensated where they are to be, go
/// to the machine here, and the observer hears of each with the place of its block.
class Outlet {
 public:
  /// Both outlive the outlet.
  Outlet(machine::MachinePort& port, runtime::Observer& observer);

  /// How the program sees places of the machine; without it nobody is told.
  using View = std::function<runtime::ProgramView(const AxisPositions& q_M,
                                                  const AxisPositions& q_M_commanded)>;
  void show_by(View view) { view_ = std::move(view); }

  /// The levels of calls of the present block, the innermost first.
  using Levels = std::function<std::vector<runtime::CallLevel>()>;
  void show_levels_by(Levels levels) { levels_ = std::move(levels); }

  /// What leads the axes from now on, looked at for each block.  @param transform  outlives this
  void lead_by(const machine::AxisTransformPtr& transform) { transform_ = &transform; }

  /// Moves the axes along a block: at rapid with g = 0, else at feed.
  /// @param plane  of an arc
  /// @returns the machine's fault; then the observer hears of no move
  machine::MaybeFault move(const PathBlock& block, const OffsetPlane& plane);

  /// @returns the fault of a move before it that passed on: then there is no pause; or what axes
  ///          that lag have met meanwhile
  machine::MaybeFault pause(const Pause& pause);

  /// Waits until the axes stand.  @returns the fault of a move that passed on
  machine::MaybeFault stand_still();
  /// The same at the end of a program, when axes that lag still arrive.
  machine::MaybeFault come_to_rest();

  /// A program level has begun or ended: blocks from now on have other calls behind them.
  void calls_changed() { calls_are_old_ = true; }
  /// For PathBlock::calls of a block that is programmed now: it may go to the machine, or be found
  /// to have met something, when the program is at another level.
  std::uint64_t calls_now() {
    if (calls_are_old_) {
      remember_levels();
    }
    return levels_number_;
  }

  /// Of the last fault: the levels of the block whose move it is, the innermost first; their first
  /// place is not that of the block.  nullopt: there was no fault, it is that of no block of
  /// motion, or they are not known any more.
  [[nodiscard]] const std::optional<std::vector<runtime::CallLevel>>& fault_levels() const {
    return fault_levels_;
  }

  /// The levels of a number of calls_now(); nullopt: it is 0, or they are not known any more.
  [[nodiscard]] std::optional<std::vector<runtime::CallLevel>> levels_of(
      std::uint64_t number) const;

  /// Of a fault that was found late: the block whose move it is; not known: the present one.
  static source::Location place_of(const machine::MachineFault& fault);

  /// A move that listens to a sensor.  What became of it in words of the program is touched().
  /// @param where  its block
  Result<machine::SkipOutcome, machine::MachineFault> move_until_skip(const machine::SkipMove& move,
                                                                      source::Location where);
  void touched(runtime::TouchEvent event);
  /// By the second of two sensors that the same move listened to.
  void touched_as_well(runtime::TouchEvent event);

  /// Machine time of all moves at feed and of those that listen, s.
  [[nodiscard]] double cutting_s() const {
    return cutting_s_ + (cuts_since_s_ ? port_.time_s() - *cuts_since_s_ : 0.0);
  }
  /// What passes until the next such move is none of it.
  void stop_cutting() { set_cutting_s(cutting_s()); }
  void set_cutting_s(double seconds) {
    cutting_s_ = seconds;
    cuts_since_s_.reset();
  }

 private:
  template <typename Move>
  machine::MaybeFault carry_out(const Move& move, const PathBlock& block);

  machine::MaybeFault told(machine::MaybeFault fault,
                           const std::optional<runtime::MoveEvent>& move = std::nullopt);
  [[nodiscard]] runtime::ProgramView view_of(const AxisPositions& q_M,
                                             const AxisPositions& q_M_commanded) const;
  void cut();
  void remember_levels();
  /// Moves from the next one on are of such a number of calls_now().
  void begin_calls(std::uint64_t number);
  void look_up_levels(std::uint64_t move);

  // The clock is looked at where cutting begins and ends, not at each move: what passes on has no
  // time of its own.
  double cutting_s_ = 0.0;
  std::optional<double> cuts_since_s_;
  std::uint64_t moves_ = 0;  // that the observer has heard of
  /// What calls_now() has given numbers to, the newest last: levels_number_ is its number.
  std::deque<std::vector<runtime::CallLevel>> remembered_;
  std::uint64_t levels_number_ = 0;
  /// From which move on blocks are of such a number.
  struct CallsFrom {
    std::uint64_t move = 0;
    std::uint64_t number = 0;
  };
  std::deque<CallsFrom> calls_;
  std::optional<std::vector<runtime::CallLevel>> fault_levels_;
  bool calls_are_old_ = true;
  Levels levels_;
  machine::MachinePort& port_;
  runtime::Observer& observer_;
  View view_;
  const machine::AxisTransformPtr* transform_;
};

}  // namespace g31::path
