#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/offset_numbers.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/statements.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"
#include "machine/port/machine_port.h"

namespace g31::fanuc {

/// What a literal with more decimals than the least increment becomes (MB-024).
enum class ExcessDecimals { Truncate, Round };

/// What F in a block of G31 does to later blocks (MB-267, MB-334).
enum class SkipFeed {
  Modal,    ///< it is the feed in force from now on
  OneBlock  ///< it counts for this block only
};

/// What P of G31 says (MB-278).
enum class SkipSelection {
  Parameters,  ///< 1 to 4: the signals of parameters 6202 to 6205
  Mask         ///< 1 to 255: one bit for each signal
};

/// What G53 does to the tool length offset of the axes that it moves (MB-291).
enum class MachineMoveLength {
  Cancels,  ///< as G28: it is off until the next G43, G44 or H
  Ignores   ///< only its own move goes without it
};

/// What G43, G44, G49 and H do to their axis (MB-295, MB-296).
enum class LengthChange {
  /// It moves by the change, also where the block names no axis; parameter 5006.6 shifts instead
  /// (30i connection manual B-63943EN-1, 12.5.2, has no axis move then, and only then).
  MovesAxis,
  ShiftsCoordinates  ///< only coordinates change: an axis that is not named stays
};

/// What G37 does (MB-282).
enum class ToolMeasurement {
  NearPosition,  ///< measures against the programmed position, within a zone; adds to the wear
  /// The same, with R, D and F in the place of parameters 6251, 6254 and 6241 (M700V programming
  /// manual, 15.1).
  NearPositionByWords,
  ToTravelEnd  ///< moves Z down to the signal wherever it comes; sets the length
};

/// Which alarm number `#3000=n` makes (MB-123, MB-339, MB-368, MB-372).
struct MacroAlarmRule {
  enum class Number { BasePlusValue, Base };
  Number number = Number::BasePlusValue;
  int base = 3000;
  int smallest = 0;                ///< n
  int largest = 200;               ///< n
  int text_length = 26;            ///< characters that its screen shows
  bool has_plain_numbers = false;  ///< parameter 6008.1 = 1 makes the number n itself
};

/// What AND, OR and XOR do to a number with a fraction (MB-069, MB-363).
enum class LogicOperands { Round, Truncate };

/// How deep calls nest (MB-201, MB-224, MB-336, MB-370).
struct CallLevels {
  int macros = 4;       ///< G65 and its like
  int subprograms = 4;  ///< M98
  int together = 8;
};

/// DO and END (MB-179, MB-181, MB-339, MB-371).
struct LoopRule {
  int largest_number = 3;
  int nesting = 3;
};

/// Which way rapids go.
struct RapidRule {
  /// G00, where neither sheet nor parameter 1401.1 says it.
  machine::RapidPath positioning = machine::RapidPath::Independent;
  /// G28 to its intermediate point, the second way of G29 and G53 are like G00; else each axis goes
  /// on its own there, as it does in any case to and from reference points.
  bool machine_moves_as_positioning = false;
};

/// Which group of the interpreter the control shows as #4000+n; 0: none.
using ModalLayout = std::array<std::uint8_t, kGroupCount>;

/// The interpreter's own groups are those of Fanuc (MB-134).
constexpr ModalLayout fanuc_modal_layout() {
  ModalLayout layout{};
  for (std::size_t n = 0; n < layout.size(); ++n) {
    layout[n] = static_cast<std::uint8_t>(n);
  }
  layout[static_cast<std::size_t>(Group::DynamicOffset)] = 0;  // of a Haas
  return layout;
}

/// Range of the results of expressions (MB-047); the 30i can be set to it (MB-046).
inline constexpr double kLargestOf16i = 1e47;
inline constexpr double kSmallestOf16i = 1e-29;

/// What an F without a decimal point counts, per minute: so many to a mm/min, to an inch/min.
struct FeedCounts {
  double per_mm = 1.0;
  double per_inch = 100.0;
};

/// F under G93.
struct InverseTime {
  /// What F of an arc counts: B-62764EN 5 and M700V 7.5 have the feed over the radius at its start,
  /// the Haas mill operator's manual the strokes in a minute, as on a line.
  enum class OfArc { Radius, Length } of_arc = OfArc::Radius;
  double counts = 1000.0;  ///< of an F without a point: so many to 1/min
  double most = 9999.999;  ///< 1/min
  /// G31, G37 and G96 are alarms beside it (M700V programming manual, 7.5).
  bool stands_alone = false;
};

/// G51 (MB-299).
struct ScaleRule {
  double counts = 1000.0;  ///< a whole P, I, J or K is so many times the factor
  bool takes_fractions =
      false;                   ///< one with a point, or a computed one, is the factor; else refused
  bool of_named_axes = false;  ///< of the centre alone, if there is one; I J K without a parameter
};

/// What G60 goes by.
struct SingleDirectionRule {
  ParameterId way = ParameterId::SingleDirection;
  std::optional<ParameterId> modal = ParameterId::ModalSingleDirection;
  int setting = 0;  ///< of a Haas, in the place of `way`: ends in the negative direction; 0: none
};

/// What SETVN may name (MB-104).
struct NameRule {
  int first = 500;
  int last = 519;
  int longest = 8;  ///< characters
};

/// A setting of a Haas that is a parameter of the others.
struct ParameterSetting {
  int setting;  ///< #20000 and so many
  ParameterId parameter;
  int index = 0;            ///< which of the row's numbers
  double counts = 1.0;      ///< the parameter is so many times the setting
  bool takes_zero = false;  ///< else 0 leaves the parameter as it is
};

/// A control of the family, as data: the interpreter asks for the property, never for the name.
/// What profile.cc does not say is as on the 16i.
struct Profile {
  std::string_view name;
  std::string_view text;
  AlarmNumbers alarm_numbers = AlarmNumbers::Series16i;
  std::string_view alarm_prefix;  ///< letters before the number on its screen

  // Numbers
  ExcessDecimals excess_decimals = ExcessDecimals::Truncate;
  int digit_limit = 8;                      ///< digits of a number in an expression (MB-027)
  int word_digit_limit = 8;                 ///< digits of a number behind an address
  double largest_result = kLargestOf16i;    ///< magnitude beyond it is alarm 111 (MB-047)
  double smallest_result = kSmallestOf16i;  ///< magnitude below it, but not 0, is alarm 111
  LogicOperands logic_operands = LogicOperands::Round;
  bool has_signed_arc_sine = false;  ///< ASIN gives -90 to 90, whatever parameter 6004.0 says
  FeedCounts feed_counts;            ///< parameter 1403.0 of Fanuc: 1 mm/min beside 0.01 inch/min
  InverseTime inverse_time;
  FunctionLevel functions = FunctionLevel::Full;
  [[nodiscard]] constexpr bool has_series_30i_functions() const {
    return functions == FunctionLevel::Series30i;
  }

  // Statements
  int smallest_target = 1;       ///< of GOTO
  int largest_sequence = 99999;  ///< N and GOTO (MB-003, MB-172)
  LoopRule loops;
  bool has_then = true;                      ///< IF [...] THEN (MB-371)
  NameRule names;                            ///< of common variables
  bool has_bare_expressions = false;         ///< X#1+10 without brackets (MB-332)
  bool has_symbol_logic = false;             ///< && and || between comparisons (MB-350)
  bool has_bare_message = false;             ///< #3006=(TEXT) without a number
  std::span<const GNumber> missing_g_codes;  ///< of the family, those it has not, rising (MB-370)
  bool unit_is_setting = false;              ///< G20 and G21 check it, and do not change it
  CodeSet own_g_codes = CodeSet::Family;     ///< beside those of the family
  bool joins_conditions = false;        ///< AND, OR, XOR join comparisons without parameter 6006.0
  bool conditions_are_numbers = false;  ///< IF [#1]: what is not 0 is true
  /// IF [...] M98 P1, [...] M99 P1: any block, with no THEN; also behind words of a block, as GOTO
  /// is.
  bool conditions_rule_blocks = false;

  // Calls
  CallLevels calls;
  bool lone_cancel_is_alarm = false;  ///< G67 without G66 (MB-206)
  bool codes_before_call = false;     ///< G54 G65 P..: the codes before G65 take effect first
  bool keeps_all_words = false;       ///< #4101 to #4126 show the last word of every letter
  bool has_local_calls = false;  ///< M97 P: a subprogram in the same text; M96 P Q: a jump by input
  /// E and F of a call without a point are counted as F is; else they are as written (MB-196).
  bool counts_feed_arguments = true;
  bool has_program_names = false;  ///< M98 <NAME>, G65 <NAME> beside P and a number (MB-002)
  char start_letter = 'Q';         ///< of M98 P..: the sequence number to begin at (MB-216, MB-336)
  bool starts_in_called = true;    ///< with P it is a block of that program; else it goes without P
  /// P of M98 beyond it: how often, before the number of the program (MB-214); 0: a number alone.
  int count_factor = 10'000;

  bool dwell_point_is_seconds = false;  ///< G04 P1. is a second; else P takes no point (MB-285)
  bool dwell_is_fence = true;  ///< G04 waits until the axes stand before reading on (MB-162)

  bool asks_for_keys = false;  ///< M109 P: the key that the operator presses into a variable

  // #3000 and the system variables
  MacroAlarmRule macro_alarm;
  ModalLayout modal_layout = fanuc_modal_layout();
  VariableGroups variables = {VariableGroup::Basic,         VariableGroup::WordsByNumber,
                              VariableGroup::LegacyOffsets, VariableGroup::OffsetsAt7001,
                              VariableGroup::LongOffsets,   VariableGroup::OffsetsC,
                              VariableGroup::ExternalOffset};

  ScaleRule scale;
  /// R of G68 is modal: it counts for later ones without R, behind G69, too, and one under G91 is
  /// added to it.  Else parameters 5410 and 5400.0 say what these do.
  bool keeps_rotation_angle = false;
  /// Behind G68 an axis that a block does not name is where the program had it before the rotation,
  /// unless parameter 11600.5 is on; else it is where the tool is in the turned plane.
  bool omits_before_rotation = false;
  /// I, J and K of G68 are an axis in space that it turns about by R: an option of Fanuc and MELDAS
  /// (B-62764EN/01 p. 243; M700V programming manual, three-dimensional coordinate conversion).
  bool rotates_in_space = true;
  /// The manual wants G69 before G27 to G30, G52 to G59 and G92 (Fanuc B-63944EN, rotation).
  bool bars_origins_in_rotation = true;

  bool helix_counts_turns = false;  ///< P of G02 and G03 beside a third axis: whole turns

  std::string_view whole_with_point;  ///< letters whose whole numbers may have a point, where they
                                      ///< count something
  bool last_corner_word_counts = false;  ///< of several ,C and ,R in a block; else an alarm

  // Offsets and canned cycles
  /// G52 shifts the work system in force alone, each has a shift of its own, and under G91 its
  /// values are added.  Else it shifts them all, by its values as they stand (MB-290).
  bool shifts_each_system = false;
  /// G10 with axes and without P sets the work system in force, also without L; else L2 without P
  /// sets the external offset, and G10 without L a tool offset.
  bool sets_system_in_force = false;
  std::string_view additional_system = "G54.1 P";  ///< what calls one, its number behind it
  int additional_systems = kAdditionalSystems;     ///< P of G54.1 and G10 L20 goes up to it
  bool enters_diameters = false;      ///< R of G10 L12 and L13 is a diameter; else a radius
  double offset_limit_mm = 1000.0;    ///< G10 takes less than this (MB-263); in inches a tenth
  char cycle_repeats = 'K';           ///< repeats of a canned cycle (MB-312)
  bool pecks_shrink = false;          ///< G73 and G83 take I J K in the place of Q
  bool pecks_clear = false;           ///< G73 with Q and K returns to R whenever it is K deeper
  bool has_synchronous_taps = false;  ///< ,R1 beside G74 and G84: F is the lead, mm in a turn
  bool shifts_by_distances = false;   ///< G76 and G87 take I J in the place of Q

  ParameterId surface_axis = ParameterId::SurfaceAxis;  ///< of G96 without P
  char lowest_speed_word = '\0';  ///< beside S of G92, for G96 (M700V programming manual); \0: none

  SingleDirectionRule single_direction;

  bool replaces_tools = false;  ///< M06 is the cycle of G100: it moves the axes, too

  // Tool length and the machine's own positions
  MachineMoveLength machine_move_length = MachineMoveLength::Cancels;
  LengthChange length_change = LengthChange::MovesAxis;
  bool machine_moves_add = false;         ///< G53 under G91 moves by its values; else it is ignored
  bool machine_moves_by_mode = false;     ///< G53 behind G01 goes at feed; else at rapid, always
  bool bare_reference_moves_all = false;  ///< G28 without axes: all of them
  RapidRule rapids;
  /// Whether speed is planned ahead without contour control: acceleration before interpolation.
  bool plans_ahead = false;

  // G31
  bool checks_skip_signal = false;   ///< M78 and M79 beside G31: an alarm with and without a signal
  bool marks_latched_point = false;  ///< M75 keeps the point of its skip move for G35 and G136
  ToolMeasurement tool_measurement = ToolMeasurement::NearPosition;
  SkipSelection skip_selection = SkipSelection::Parameters;
  SkipFeed skip_feed = SkipFeed::Modal;
  bool skip_takes_r = false;  ///< R of G31: whether the move accelerates and brakes
  std::optional<ParameterId> skip_feed_parameter;  ///< feed of G31 without F (MB-334)

  std::span<const ParameterSetting> parameter_settings;

  int blocks_read = 3;  ///< in cutter compensation, where parameter 19625 says nothing

  // DPRNT and BPRNT
  OutputRule output;
};

/// The row of g_codes.def that the control has for a number, or nullptr: alarm 010.
const GCode* find_g_code(GNumber number, const Profile& profile);
const GCode* find_g_code(double value, const Profile& profile);
/// Whether the control has this row of g_codes.def.
bool has_g_code(const Profile& profile, const GCode& code);

/// What a program calls a work coordinate system by: "G54", "G54.1 P1", on a Haas "G154 P1".
/// @param system  from 1
std::string work_system_name(int system, const Profile& profile);

/// All profiles, in the order of the documentation.
std::span<const Profile> profiles();

/// The profile of this name, or nullptr.
const Profile* find_profile(std::string_view name);

/// The profile as one of the models that run so has it: 0i-F lacks codes that 30i has.
const Profile& profile_of_model(const Profile& profile, std::string_view model);

}  // namespace g31::fanuc
