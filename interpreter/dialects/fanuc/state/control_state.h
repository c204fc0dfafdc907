#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "interpreter/dialects/fanuc/state/calendar.h"
#include "interpreter/dialects/fanuc/state/code_calls.h"
#include "interpreter/dialects/fanuc/state/coordinates.h"
#include "interpreter/dialects/fanuc/state/offsets.h"
#include "interpreter/dialects/fanuc/state/plane_points.h"
#include "interpreter/dialects/fanuc/state/polar.h"
#include "interpreter/dialects/fanuc/state/roll_over.h"
#include "interpreter/dialects/fanuc/state/signals.h"
#include "interpreter/dialects/fanuc/state/variables.h"
#include "interpreter/dialects/fanuc/state/work_transform.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/canned_cycles.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/plane.h"
#include "interpreter/path/contour_corners.h"
#include "interpreter/path/cutter_compensation.h"
#include "interpreter/runtime/busy_wait.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/input_scripts.h"
#include "interpreter/runtime/touch_reports.h"
#include "interpreter/source/location.h"
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
  int length_offset = 0;  ///< H in force
  int length_axis = 2;    ///< its axis: Z of a vertical machining centre, else by parameter 5001
  int additional_system = 0;  ///< P of G54.1, 0 in G54..G59

  Modal();
  [[nodiscard]] bool inverse_time() const { return group[Group::FeedMode].whole == 93; }
  [[nodiscard]] bool per_revolution() const { return group[Group::FeedMode].whole == 95; }
  [[nodiscard]] bool cuts_thread() const { return group[Group::Motion].whole == 33; }
  [[nodiscard]] bool surface_speed() const { return group[Group::SpindleMode].whole == 96; }
  /// Whether the feed of a block depends on where it goes.
  [[nodiscard]] bool feed_depends_on_way() const {
    constexpr int kPerMinute = 94;
    return group[Group::FeedMode].whole != kPerMinute && (inverse_time() || surface_speed());
  }
  [[nodiscard]] bool incremental() const { return group[Group::Distance].whole == 91; }
  [[nodiscard]] Plane plane() const { return plane_of(group[Group::Plane]); }

  bool operator==(const Modal&) const = default;
};

/// What the blocks from G10 to G11 are (MB-260).
enum class DataInput {
  None,
  Parameters,  ///< G10 L50: N and R, or N P and R
  ToolLife     ///< G10 L3: groups of tools, which are recorded; lives are not counted
};

/// The group of tools that the blocks behind G10 L3 tell of.
struct ToolLifeGroup {
  int number = 0;        ///< P
  double life = 0.0;     ///< L: uses, or minutes
  bool deletes = false;  ///< G10 L3 P2

  bool operator==(const ToolLifeGroup&) const = default;
};

/// What a skip move found.
struct SkipPoint {
  AxisPositions q_M_from = AxisPositions::Zero();  ///< where it began
  AxisPositions q_M_latched = AxisPositions::Zero();

  bool operator==(const SkipPoint&) const = default;
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

  bool operator==(const CutterStage&) const = default;
};

/// What S says, and what G96 makes of it.
struct SpindleSpeeds {
  double turns = 0.0;           ///< rev/min: S of G97, or what G96 had come to when it ended
  double surface_mm_min = 0.0;  ///< S of G96
  int axis = 0;                 ///< of G96: the work coordinate of this axis is the radius
  double lowest = 0.0;          ///< rev/min, for G96
  double highest = std::numeric_limits<double>::infinity();  ///< rev/min, for G96: S of G92

  bool operator==(const SpindleSpeeds&) const = default;
};

/// What rapids and contours depend on.
struct RapidState {
  machine::RapidPath positioning = machine::RapidPath::Independent;  ///< without parameter 1401.1
  bool contour_control = false;                                      ///< G05.1 Q1
  bool looks_ahead = false;                                          ///< G08 P1

  bool operator==(const RapidState&) const = default;
};

/// What programs read and change of a control, as a plain value: copies are keyframes, and two runs
/// that are alike have equal ones.  Where the axes are and what time it is says the machine.
struct ControlState {
  Parameters parameters;
  Variables variables;
  runtime::TouchReports touches;  ///< of G31
  Modal modal;
  int main_program = 0;  ///< its number
  Coordinates coordinates;
  CutterStage cutter;
  OffsetTable offsets;
  WordScale scale;
  RollOver roll_over;  ///< as the parameters say
  std::set<int> block_skip;
  runtime::FeedSwitches feed_switches;
  CodeCalls code_calls;

  AxisPositions q_W_skip = AxisPositions::Zero();  ///< #5061.., tool offset included; mm, deg
  SkipPoint last_skip;
  std::optional<SkipPoint> marked_skip;  ///< what M75 of a Haas keeps
  bool printer_open = false;             ///< between POPEN and PCLOS
  /// Common variables beyond #999, by number; those that are not there are vacant.
  std::map<std::int32_t, Cell> further_commons;
  /// What the set-up sheet says of the machine, and outputs, by variable number; else 0.
  std::map<std::int32_t, double> data;
  PmcSignals signals;            ///< #1000.., #1100..
  runtime::InputScripts inputs;  ///< of those that the set-up sheet scripts
  std::string keys_left;         ///< that the operator will press at M109, in ASCII
  Calendar calendar;             ///< #3011, #3012
  runtime::BusyWait busy_wait;
  machine::Rotation rotation = machine::Rotation::Stopped;  ///< of the spindle
  bool builder_may_turn = false;  ///< an M code of the builder's came behind its last command
  SpindleSpeeds spindle;
  std::optional<int> tool;         ///< that M6 has brought
  std::optional<int> called_tool;  ///< the last T; none before the first
  double timer_offset_ms = 0.0;    ///< #3001 = simulated time + this
  double hours_offset = 0.0;       ///< #3002 likewise
  int single_block_control = 0;    ///< #3003
  int override_control = 0;        ///< #3004
  bool has_own_feed = false;       ///< F in the present block
  bool single_direction = false;   ///< G60 in the present block
  bool stops_exactly = false;      ///< G09 in the present block
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
  ToolLifeGroup life_group;
  /// The last skip move, if its signal ended it and the program has neither moved nor read a
  /// position since.
  std::optional<source::Location> stopped_skip;

  bool operator==(const ControlState&) const = default;
};

}  // namespace g31::fanuc
