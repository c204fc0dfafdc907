#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/state/control_state.h"
#include "interpreter/dialects/fanuc/state/evaluate.h"
#include "interpreter/dialects/fanuc/state/failure.h"
#include "interpreter/dialects/fanuc/state/lookahead.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"
#include "interpreter/path/outlet.h"
#include "interpreter/runtime/block_watch.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/input_scripts.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/printer_port.h"
#include "interpreter/runtime/warnings.h"
#include "machine/port/machine_port.h"
#include "machine/units/rounded_length.h"

namespace g31::fanuc {

/// A running control: its state, and what it works with.  One per run; nothing is global.
struct Control : ControlState {
  Control(const Profile& chosen, machine::MachinePort& machine, runtime::Observer& listener,
          SystemVariables& system);

  const Profile& profile;
  machine::MachinePort& port;
  runtime::Observer& observer;
  path::Outlet outlet;
  source::Location block;  ///< of NC words, the one that runs
  BlockWords completed;    ///< its words, where it commands more than is written

  SystemVariableIndex system_variables;
  AllVariables all_variables;
  Evaluator evaluator;
  std::set<int> expected_tools;    ///< numbers of the sheet's tool table; empty: anything goes
  std::set<int> expected_systems;  ///< likewise for work offsets, as Coordinates counts them
  /// The program writes a work offset: it is as good as one of the sheet's.
  void work_offset_given(int system) {
    if (!expected_systems.empty()) {
      expected_systems.insert(system);
    }
  }

  runtime::PrinterPort* printer = nullptr;  ///< none: only the observer hears
  std::vector<runtime::SensorWord> sensor_words;
  std::string controlled_axes = kAxisLetters;  ///< #5001 is of the first, #5002 of the second
  runtime::BlockWatch watch{runtime::Budget{}};
  std::uint64_t main_restarts = 0;  ///< how often M99 without P has begun the main program again
  /// A value is looked at from outside the program: no report comes of it, and no time passes.
  [[nodiscard]] bool is_inspected() const { return touches.is_inspected(); }

  Lookahead lookahead;
  std::vector<source::Diagnostic> diagnostics;

  /// Another skip move follows: the one before was a protected positioning move, and if its
  /// signal ended it, it met something.
  void report_stopped_skip();
  /// The program looks where the axes are: what stopped them does not go unnoticed.
  void position_read();
  /// How far the program is, for what happens after a while.
  [[nodiscard]] runtime::InputScripts::Now now() const { return {port.time_s(), watch.blocks()}; }
  /// Machine time, as a program looks at it that may wait for it to pass.
  double time_looked_at() { return is_inspected() ? port.time_s() : busy_wait.look(port); }
  /// What the present statement has read counts as measured now: it is in an offset, or printed.
  void use_measured();
  /// The end of the program.
  void report_missed_touches();
  /// The program is broken off.
  void report_unread_miss();

  /// Where the program is now, for reports from inside an expression.
  std::function<source::Location()> here;

  /// A system variable is read ahead of the motion: the report that it deserves.
  void report_read_ahead(const SystemVariable& row, std::int32_t number);

  /// Warns of what a block did.  When the block does it again, only the count of the warning grows:
  /// a loop may do it a million times.
  [[gnu::cold]] void warn(source::DiagnosticId id, source::Location where);
  /// Of a move that listens to a sensor so placed.
  [[gnu::cold]] void warn_of(const std::optional<machine::SensorState>& sensor,
                             source::Location where);
  /// Says at each warning how often it happened; to be called once, at the end.
  void tell_repeats();

  /// Warns of something that g31 does not simulate, at its first place only.
  [[gnu::cold]] void warn_once(source::DiagnosticId id, source::Location where,
                               std::string_view detail = {});

  /// How a move at feed ends: G09 and G61 stop exactly, unless #3004 bit 2 forbids it.
  [[nodiscard]] machine::BlockEnd feed_end() const;
  [[nodiscard]] machine::BlockEnd rapid_end() const;

  /// What look-ahead contour control does with moves at feed; with Q1 or P1 it drives the axes by
  /// the speed of their command, too.
  [[nodiscard]] machine::ContourControl contour_control() const;

  /// The way of G00: FANUC AI nano contour control A-78962EN/01, 4, for that in contour control.
  [[nodiscard]] machine::RapidPath rapid_path() const;
  /// Whether the present block is positioned by G60.
  [[nodiscard]] bool positions_in_one_direction() const {
    constexpr int kSingleDirection = 60;
    return single_direction || modal.group[Group::Motion].whole == kSingleDirection;
  }
  /// Of a rapid between places of the machine: G28 to its intermediate point, G53.
  [[nodiscard]] machine::RapidPath machine_rapid_path() const {
    return profile.rapids.machine_moves_as_positioning ? rapid_path()
                                                       : machine::RapidPath::Independent;
  }

  /// What the machine is by the set-up sheet, as far as no parameter says otherwise.
  void take_kinematics(const machine::AxisChainSetup& sheet) { sheet_kinematics_ = sheet; }
  /// Takes over parameters and what they change.
  void apply(const Parameters& given);
  /// The machine compensates, and axes have arrived, as the parameters say now.  Fails where they
  /// contradict each other; the tables that were in force stay then.
  MaybeFailure tell_machine();
  /// Storage index of a controlled axis, counted from 0; nullopt: there is none of this number.
  [[nodiscard]] std::optional<int> controlled_axis(int number) const {
    return fanuc::controlled_axis(controlled_axes, number);
  }
  /// mm: a tool offset is smaller (MB-263).
  [[nodiscard]] double offset_limit_mm() const {
    constexpr double kInchLimit = 2.54;  // in inches offsets have one digit less before the point
    return profile.offset_limit_mm * (scale.unit == LengthUnit::Inch ? kInchLimit : 1.0);
  }
  /// Tool offset memory A, B or C, and with it the numbers of the offset variables.
  void set_offset_memory(OffsetMemory memory);
  /// G20, G21, and parameter 0.2, which says the same.
  void set_unit(LengthUnit unit);

  /// Where the axes stand, in machine coordinates; a block that waits in cutter compensation counts
  /// as done, its end beside the programmed one; one that waits for its corner too, at the corner.
  [[nodiscard]] AxisPositions position() const {
    if (!cutter.corners.holds() && !cutter.compensation.engaged()) {
      return port.position();
    }
    return coordinates
        .axes_at(cutter.corners.holds() ? cutter.corners.held_end()
                                        : cutter.compensation.position())
        .value_or(port.position());
  }
  /// Path coordinates where the axes stand.
  [[nodiscard]] AxisPositions path_position() const { return coordinates.path_at(port.position()); }

  /// mm of a value in the unit in force, and back.
  [[nodiscard]] double to_mm(double value) const { return value * scale.mm_per_unit(); }
  [[nodiscard]] double from_mm(double mm) const { return mm / scale.mm_per_unit(); }
  /// A coordinate of an axis as variables show it, and back: linear axes in the unit in force.
  [[nodiscard]] double shown(int axis, double value) const {
    return without_noise(is_linear_axis(axis) ? from_mm(value) : value);
  }
  [[nodiscard]] double stored(int axis, double value) const {
    return is_linear_axis(axis) ? to_mm(value) : value;
  }

 private:
  void choose_system_variables();

  machine::AxisChainSetup sheet_kinematics_;
  bool compensates_ = false;  // the machine has tables
  machine::AxisData of_machine_ = port.axis_data();

  runtime::Warnings warnings_;
  std::set<std::pair<source::DiagnosticId, std::string>> warned_;
};

}  // namespace g31::fanuc
