#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/state/calendar.h"
#include "interpreter/dialects/fanuc/state/code_calls.h"
#include "interpreter/dialects/fanuc/state/coordinates.h"
#include "interpreter/dialects/fanuc/state/evaluate.h"
#include "interpreter/dialects/fanuc/state/failure.h"
#include "interpreter/dialects/fanuc/state/lookahead.h"
#include "interpreter/dialects/fanuc/state/offsets.h"
#include "interpreter/dialects/fanuc/state/plane_points.h"
#include "interpreter/dialects/fanuc/state/polar.h"
#include "interpreter/dialects/fanuc/state/signals.h"
#include "interpreter/dialects/fanuc/state/variables.h"
#include "interpreter/dialects/fanuc/state/work_transform.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/canned_cycles.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"
#include "interpreter/path/contour_corners.h"
#include "interpreter/path/cutter_compensation.h"
#include "interpreter/path/outlet.h"
#include "interpreter/runtime/block_watch.h"
#include "interpreter/runtime/busy_wait.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/input_scripts.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/printer_port.h"
#include "interpreter/runtime/touch_reports.h"
#include "interpreter/runtime/warnings.h"
#include "machine/port/machine_port.h"

namespace g31::fanuc {

/// What stays in force from block to block.
struct Modal {
  /// By group; the power-on state of MB 0.1: G00 G17 G90 G94 G21 G40 G49 G80 G98 G54 G64.
  GroupCodes group;
  double feed = 0.0;  ///< in the unit in force per minute; 0: none was ever given
  /// The last word of each letter, as #4102 to #4120 show it.
  std::array<double, 26> words{};  ///< by letter - A
  [[nodiscard]] double& word(char letter) { return words[static_cast<std::size_t>(letter - 'A')]; }
  /// The last value of each argument of specification I, by its local variable: #4101 to #4126 of a
  /// Haas.
  std::array<double, 27> arguments{};
  int length_offset = 0;      ///< H in force
  int additional_system = 0;  ///< P of G54.1, 0 in G54..G59

  Modal();
  [[nodiscard]] bool incremental() const { return group[Group::Distance].whole == 91; }
  [[nodiscard]] Plane plane() const { return plane_of(group[Group::Plane]); }
};

/// What the blocks from G10 to G11 are (MB-260).
enum class DataInput {
  None,
  Parameters,  ///< G10 L50: N and R, or N P and R
  ToolLife     ///< G10 L3: not simulated
};

/// What a skip move found.
struct SkipPoint {
  AxisPositions q_M_from = AxisPositions::Zero();  ///< where it began
  AxisPositions q_M_latched = AxisPositions::Zero();
};

/// How ,C and ,R are judged.  Source: B-63844EN, optional angle chamfering and corner rounding:
/// within 1 degree there is no corner, and none goes beyond its blocks.
inline constexpr path::CornerRules kCornerRules = {path::CornerRules::TooLarge::Refused,
                                                   path::CornerRules::ChamferAtArc::ByDistance,
                                                   std::numbers::pi / 180.0};

/// Corners and cutter compensation, and what the present block says to them.
struct CutterStage {
  path::ContourCorners corners{kCornerRules};
  path::CornerWish wish;                   ///< of the present block
  path::PathItems behind_corner;           ///< dwells that stand between its two blocks
  path::CompensationCommand held_command;  ///< of the block that waits for its corner
  path::CutterCompensation compensation;
  path::CompensationCommand command;
  bool fed = false;  ///< a motion or pause of the present block has come through
};

/// What rapids and contours depend on.
struct RapidState {
  machine::RapidPath positioning = machine::RapidPath::Independent;  ///< without parameter 1401.1
  bool contour_control = false;                                      ///< G05.1 Q1
  bool looks_ahead = false;                                          ///< G08 P1
};

/// The whole state of a running control.  One per run; nothing is global.
struct Control {
  Control(const Profile& chosen, machine::MachinePort& machine, runtime::Observer& listener,
          SystemVariables& system);

  const Profile& profile;
  Parameters parameters;
  machine::MachinePort& port;
  runtime::Observer& observer;
  path::Outlet outlet;
  source::Location block;  ///< of NC words, the one that runs

  Variables variables;
  runtime::TouchReports touches;  ///< of G31
  SystemVariableIndex system_variables;
  Evaluator evaluator;
  Modal modal;
  Coordinates coordinates;
  CutterStage cutter;
  OffsetTable offsets;
  WordScale scale;
  std::set<int> block_skip;
  runtime::FeedSwitches feed_switches;
  CodeCalls code_calls;
  std::set<int> expected_tools;    ///< numbers of the sheet's tool table; empty: anything goes
  std::set<int> expected_systems;  ///< likewise for work offsets, as Coordinates counts them

  AxisPositions q_W_skip = AxisPositions::Zero();  ///< #5061.., tool offset included; mm, deg
  SkipPoint last_skip;
  SkipPoint marked_skip;                    ///< what M75 of a Haas keeps
  runtime::PrinterPort* printer = nullptr;  ///< none: only the observer hears
  bool printer_open = false;                ///< between POPEN and PCLOS
  /// Common variables beyond #999, by number; those that are not there are vacant.
  std::map<std::int32_t, Cell> further_commons;
  /// What the set-up sheet says of the machine, and outputs, by variable number; else 0.
  std::map<std::int32_t, double> data;
  PmcSignals signals;  ///< #1000.., #1100..
  std::vector<runtime::SensorWord> sensor_words;
  runtime::InputScripts inputs;  ///< of those that the set-up sheet scripts
  Calendar calendar;             ///< #3011, #3012
  runtime::BusyWait busy_wait;
  machine::Rotation rotation = machine::Rotation::Stopped;  ///< of the spindle
  std::optional<int> tool;                                  ///< that M6 has brought
  std::optional<int> called_tool;                           ///< the last T; none before the first
  double timer_offset_ms = 0.0;                             ///< #3001 = simulated time + this
  double hours_offset = 0.0;                                ///< #3002 likewise
  int single_block_control = 0;                             ///< #3003
  int override_control = 0;                                 ///< #3004
  bool stops_exactly = false;                               ///< G09 in the present block
  RapidState rapids;
  int mirror_state = 0;                   ///< #3007
  int restart_state = 0;                  ///< #3008
  TransformStages transforms;             ///< G51.1, G51, G68
  PlanePoints plane_points;               ///< G68.2 P2 and P3, as far as they have come
  std::optional<PolarCoordinates> polar;  ///< G16
  CycleData cycle;                        ///< of the canned cycle in force
  /// Where the last G28 or G30 of each axis went through (L); none before the first.
  std::array<std::optional<double>, kAxisCount> q_L_intermediate;
  DataInput data_input = DataInput::None;
  runtime::BlockWatch watch{runtime::Budget{}};
  /// A value is looked at from outside the program: no report comes of it, and no time passes.
  [[nodiscard]] bool is_inspected() const { return touches.is_inspected(); }

  Lookahead lookahead;
  std::vector<source::Diagnostic> diagnostics;

  /// The last skip move, if its signal ended it and the program has neither moved nor read a
  /// position since.
  std::optional<source::Location> stopped_skip;

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

  /// Where the program is now, for reports from inside an expression.
  std::function<source::Location()> here;

  /// A system variable is read ahead of the motion: the report that it deserves.
  void report_read_ahead(const SystemVariable& row, std::int32_t number);

  /// Warns of what a block did.  When the block does it again, only the count of the warning grows:
  /// a loop may do it a million times.
  void warn(source::DiagnosticId id, source::Location where);
  /// Of a move that listens to a sensor so placed.
  void warn_of(const std::optional<machine::SensorState>& sensor, source::Location where);
  /// Says at each warning how often it happened; to be called once, at the end.
  void tell_repeats();

  /// Warns of something that g31 does not simulate, at its first place only.
  void warn_once(source::DiagnosticId id, source::Location where, std::string_view detail = {});

  /// How a move at feed ends: G09 and G61 stop exactly, unless #3004 bit 2 forbids it.
  [[nodiscard]] machine::BlockEnd feed_end() const;

  /// What look-ahead contour control does with moves at feed; with Q1 or P1 it drives the axes by
  /// the speed of their command, too.
  [[nodiscard]] machine::ContourControl contour_control() const;

  /// The way of G00: FANUC AI nano contour control A-78962EN/01, 4, for that in contour control.
  [[nodiscard]] machine::RapidPath rapid_path() const;
  /// Of a rapid between places of the machine: G28 to its intermediate point, G53.
  [[nodiscard]] machine::RapidPath machine_rapid_path() const {
    return profile.rapids.machine_moves_as_positioning ? rapid_path()
                                                       : machine::RapidPath::Independent;
  }

  /// What the machine is by the set-up sheet, as far as no parameter says otherwise.
  void take_kinematics(const machine::AxisChainSetup& sheet) { sheet_kinematics_ = sheet; }
  /// Takes over parameters and what they change.
  void apply(const Parameters& given);
  /// Tool offset memory A, B or C, and with it the numbers of the offset variables.
  void set_offset_memory(OffsetMemory memory);
  /// G20, G21
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
    return is_linear_axis(axis) ? from_mm(value) : value;
  }
  [[nodiscard]] double stored(int axis, double value) const {
    return is_linear_axis(axis) ? to_mm(value) : value;
  }

 private:
  void choose_system_variables();

  machine::AxisChainSetup sheet_kinematics_;

  runtime::Warnings warnings_;
  std::set<std::pair<source::DiagnosticId, std::string>> warned_;
};

}  // namespace g31::fanuc
