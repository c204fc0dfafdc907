#include "interpreter/dialects/fanuc/vocabulary/profile.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

// Every difference between the controls of the Fanuc dialect stands here, and only here.  The
// members' comments in profile.h name the sources.

namespace g31::fanuc {
namespace {

using enum VariableGroup;

constexpr GNumber kMissingOf16i[] = {{38, 0}};
constexpr GNumber kMissingOf0i[] = {{38, 0}, {43, 4}, {43, 5}, {53, 1}, {53, 6},
                                    {54, 2}, {54, 4}, {68, 2}, {68, 3}, {68, 4}};
constexpr GNumber kMissingOfBrother[] = {
    {20, 0}, {21, 0}, {31, 8}, {38, 0}, {39, 0}, {40, 1}, {41, 1}, {42, 1},  {43, 4},  {43, 5},
    {45, 0}, {46, 0}, {47, 0}, {48, 0}, {50, 2}, {51, 2}, {53, 1}, {53, 6},  {54, 2},  {54, 4},
    {68, 2}, {68, 3}, {68, 4}, {72, 1}, {72, 2}, {84, 2}, {84, 3}, {107, 0}, {112, 0}, {113, 0}};
/// Mill operator's manual (NGC) 2017, lists of G codes.  It names G66 and G67 elsewhere.
constexpr GNumber kMissingOfHaas[] = {
    {5, 0},  {5, 1},  {7, 1},  {8, 0},  {11, 0}, {12, 1}, {13, 1}, {15, 0}, {16, 0},
    {22, 0}, {23, 0}, {25, 0}, {26, 0}, {27, 0}, {30, 0}, {31, 8}, {33, 0}, {38, 0},
    {39, 0}, {40, 1}, {41, 1}, {42, 1}, {43, 4}, {43, 5}, {45, 0}, {46, 0}, {47, 0},
    {48, 0}, {50, 1}, {50, 2}, {51, 1}, {51, 2}, {53, 1}, {53, 6}, {54, 1}, {54, 2},
    {54, 4}, {62, 0}, {63, 0}, {68, 2}, {68, 3}, {68, 4}, {72, 1}, {72, 2}, {84, 2},
    {84, 3}, {87, 0}, {88, 0}, {92, 1}, {96, 0}, {97, 0}};
/// Mill operator's manual 96-8000, G51, G68 and settings 71 to 73; 255 to 257 are the centre of
/// rotation X Y Z of the table (MRZP).
constexpr ParameterSetting kSettingsOfHaas[] = {{71, ParameterId::UsualScale, 0, 1000.0},
                                                {72, ParameterId::UsualRotation},
                                                {73, ParameterId::IncrementalAngle},
                                                {255, ParameterId::TablePosition, 0, 1.0, true},
                                                {256, ParameterId::TablePosition, 1, 1.0, true},
                                                {257, ParameterId::TablePosition, 2, 1.0, true}};
/// The tilted plane is an option there, tool centre point control is not to be had.
constexpr GNumber kMissingOf0iF[] = {{43, 4}, {43, 5}, {53, 6}, {54, 2}, {54, 4}, {68, 3}, {68, 4}};

/// Groups that MELDAS numbers otherwise: G54 12, G61 13, G66 14, G96 17, G15 18, G50.1 19 (MB-335).
constexpr ModalLayout meldas_modal_layout() {
  ModalLayout layout = fanuc_modal_layout();
  constexpr std::uint8_t kShownAndOwn[][2] = {{12, 14}, {13, 15}, {14, 12}, {15, 18},
                                              {17, 13}, {18, 17}, {19, 22}, {22, 0}};
  for (const auto& pair : kShownAndOwn) {
    layout[pair[0]] = pair[1];
  }
  return layout;
}

constexpr Profile fanuc_16i() {
  Profile profile;
  profile.name = "fanuc-16i";
  profile.text = "Fanuc 16i, 18i, 21i";
  profile.missing_g_codes = kMissingOf16i;
  return profile;
}

constexpr Profile fanuc_0i() {
  Profile profile = fanuc_16i();
  profile.name = "fanuc-0i";
  profile.text = "Fanuc 0i-A to 0i-C; for 0i-D and 0i-F take fanuc-30i";
  profile.missing_g_codes = kMissingOf0i;
  return profile;
}

constexpr Profile fanuc_30i() {
  Profile profile = fanuc_16i();
  profile.name = "fanuc-30i";
  profile.text = "Fanuc 30i, 31i, 32i, 0i-D, 0i-F";
  profile.missing_g_codes = {};
  profile.alarm_numbers = AlarmNumbers::Series30i;
  profile.alarm_prefix = "PS";
  profile.excess_decimals = ExcessDecimals::Round;
  profile.digit_limit = 12;
  profile.word_digit_limit = 9;
  profile.largest_result = std::numeric_limits<double>::max();
  profile.smallest_result = 0.0;
  profile.functions = FunctionLevel::Series30i;
  profile.scale.takes_fractions = true;
  profile.omits_before_rotation = true;  // parameter 11600.5, by general knowledge
  profile.names = {100, 999, 31};
  profile.largest_sequence = 99999999;
  profile.offset_limit_mm = 10000.0;
  profile.calls = {5, 10, 15};
  profile.has_program_names = true;
  profile.lone_cancel_is_alarm = true;
  profile.dwell_is_fence = false;
  profile.macro_alarm.largest = 4095;
  profile.macro_alarm.text_length = 31;
  profile.macro_alarm.has_plain_numbers = true;
  profile.variables = profile.variables.with(Series30i).with(ExecutingModal);
  profile.output.most_digits = 9;
  return profile;
}

constexpr Profile fanuc_0i_f() {
  Profile profile = fanuc_30i();
  profile.missing_g_codes = kMissingOf0iF;
  return profile;
}

/// Its programs have numbers only.
constexpr Profile fanuc_0i_d() {
  Profile profile = fanuc_0i_f();
  profile.has_program_names = false;
  return profile;
}

/// What MELDAS has otherwise of coordinates and rapids, by the M700V programming manual.
constexpr void take_meldas_coordinates(Profile& profile) {
  profile.scale = {1e6, true, true};    // M700V programming manual, scaling
  profile.keeps_rotation_angle = true;  // the same manual, 13.21 (1) and (5), page 448
  profile.shifts_each_system = true;    // the same manual, 14.11, page 531
  profile.sets_system_in_force = true;  // the same manual, page 237 (9) to (11)
  profile.bars_origins_in_rotation = false;
  // M700V programming manual, 12.2 (4); 14.4 (4) and (5), page 508: G53 cancels no compensation
  profile.machine_move_length = MachineMoveLength::Ignores;
  profile.machine_moves_add = true;
  profile.machine_moves_by_mode = true;  // 14.4 (7)
  // The same manual, G00: straight or not by a parameter; G28, G29: the other way; G53: as modal
  profile.rapids = {machine::RapidPath::Straight, true};
}

constexpr Profile meldas() {
  Profile profile = fanuc_16i();
  profile.name = "meldas";
  profile.text = "Mitsubishi MELDAS M60, M70, M700";
  take_meldas_coordinates(profile);
  profile.helix_counts_turns = true;  // M700V programming manual, helical interpolation
  profile.alarm_numbers = AlarmNumbers::Meldas;
  profile.alarm_prefix = "P";
  profile.digit_limit = 12;
  profile.word_digit_limit = 12;
  profile.largest_result = std::numeric_limits<double>::max();
  profile.smallest_result = 0.0;
  profile.loops = {127, 27};
  profile.feed_counts = {1.0, 1.0};
  profile.inverse_time = {InverseTime::OfArc::Radius, 1.0, 999999.999, true};
  profile.codes_before_call = true;
  profile.has_bare_expressions = true;
  profile.joins_conditions = true;
  // M700V programming manual, 13.5: ASIN[-.5] is -30; its parameter 1273 can set 0 to 360 (MB-339)
  profile.has_signed_arc_sine = true;
  profile.own_g_codes = CodeSet::Meldas;
  profile.missing_g_codes = {};
  profile.calls = {4, 8, 8};
  profile.lone_cancel_is_alarm = true;
  profile.start_letter = 'H';
  profile.count_factor = 0;  // M98 P H L: P has the program, L says how often (MB-336)
  profile.cycle_repeats = 'L';
  // M700V programming manual, fixed cycles G74 and G84, G76 and G87
  profile.has_synchronous_taps = true;
  profile.shifts_by_distances = true;
  profile.skip_takes_r = true;  // M700V programming manual, skip function
  // M700V programming manual, page 28 (7): what stands behind the point of these is ignored.  That
  // more than a zero there is an alarm all the same is ours, and so is one behind M and N.
  profile.whole_with_point = "STDHKLP";
  profile.last_corner_word_counts = true;  // M700V programming manual, corner chamfering
  profile.macro_alarm.number = MacroAlarmRule::Number::Base;
  profile.macro_alarm.base = 277;
  profile.macro_alarm.smallest = 1;
  profile.macro_alarm.largest = 9999;
  profile.blocks_read = 5;
  profile.modal_layout = meldas_modal_layout();
  profile.variables = {Basic,          WordsByNumber,  OffsetsAt7001, OffsetsMeldas,
                       ExternalOffset, ExecutingModal, MeldasCommons};
  profile.surface_axis = ParameterId::MeldasSurfaceAxis;
  profile.lowest_speed_word = 'Q';
  profile.single_direction = {ParameterId::MeldasSingleDirection,
                              ParameterId::MeldasModalSingleDirection};
  profile.skip_selection = SkipSelection::Mask;
  profile.skip_feed = SkipFeed::OneBlock;
  profile.skip_feed_parameter = ParameterId::SkipFeed;
  profile.tool_measurement = ToolMeasurement::NearPositionByWords;
  return profile;
}

constexpr Profile mazatrol_iso() {
  Profile profile = meldas();
  profile.name = "mazatrol-iso";
  profile.text = "Mazak EIA/ISO";
  profile.alarm_prefix = "";
  profile.has_symbol_logic = true;
  profile.start_letter = 'Q';
  profile.own_g_codes = CodeSet::Mazak;
  return profile;
}

/// What a Haas has otherwise of macros: expressions, calls, variables, printing.
constexpr void take_haas_macros(Profile& profile) {
  profile.largest_result = std::numeric_limits<double>::max();
  profile.smallest_result = 0.0;
  profile.logic_operands = LogicOperands::Truncate;
  profile.macro_alarm.base = 1000;
  profile.macro_alarm.largest = 999;
  profile.variables = {Basic, OffsetsHaas, ShiftAt5201, HaasTables};
  profile.functions = FunctionLevel::Basic;
  profile.joins_conditions = true;
  profile.conditions_are_numbers = true;
  profile.conditions_rule_blocks = true;
  profile.has_local_calls = true;
  // Mill operator's manual (NGC) 2017, macros: #1=123.456789; jumps to N0; M98 P40011 calls O40011,
  // and L says how often
  profile.digit_limit = 12;
  profile.smallest_target = 0;
  profile.count_factor = 0;
  // Mill operator's manual 96-8000, last block (modal) address data: D is #4107, I #4104
  profile.keeps_all_words = true;
  // Mill operator's manual 96-8000, integer argument passing: D E F H L M S T count ones
  profile.counts_feed_arguments = false;
  profile.calls = {9, 9, 9};      // alarm 307: nine levels; published suites call macros five deep
  profile.modal_layout[12] = 14;  // G54 and the like are group 12 there
  profile.modal_layout[23] = 23;
  profile.output.fewest_digits = 1;
  profile.output.without_popen = OutputRule::WithoutPopen::Prints;  // the line is always open
  profile.output.style.overflow = OutputStyle::Overflow::Widen;
  profile.output.style.plus_sign = OutputStyle::PlusSign::Omit;
}

constexpr Profile haas() {
  Profile profile = fanuc_16i();
  profile.name = "haas";
  profile.text = "Haas";
  take_haas_macros(profile);
  profile.whole_with_point = "S";  // as programs in use write it
  profile.cycle_repeats = 'L';
  profile.pecks_shrink = true;  // mill operator's manual 96-8000, G73 and G83
  profile.pecks_clear = true;
  profile.shifts_by_distances = true;  // the same manual, G76
  profile.bars_origins_in_rotation = false;
  profile.rotates_in_space = false;
  profile.scale = {1.0, true, false};  // mill operator's manual, G51: P2. and P2 are both twice
  profile.inverse_time = {InverseTime::OfArc::Length, 1000.0, 999999.999, false};
  profile.feed_counts = {1000.0, 10000.0};  // setting 77 as it comes: F12 is 0.0012 inch/min
  // Mill operator's manual 96-8000: G28, G43; G53 passes over work offsets for its block only, and
  // nothing is said of its speed
  profile.machine_move_length = MachineMoveLength::Ignores;
  profile.machine_moves_by_mode = true;
  profile.length_change = LengthChange::ShiftsCoordinates;
  profile.bare_reference_moves_all = true;
  profile.own_g_codes = CodeSet::Haas;
  profile.unit_is_setting = true;
  profile.missing_g_codes = kMissingOfHaas;
  profile.plans_ahead = true;
  // Mill operator's manual 96-8000, G10: G10 L12 P5 R.375 sets the diameter of tool 5
  profile.enters_diameters = true;
  profile.checks_skip_signal = true;
  profile.marks_latched_point = true;
  profile.tool_measurement = ToolMeasurement::ToTravelEnd;
  profile.dwell_point_is_seconds = true;
  // Mill operator's manual (NGC) 2017, G154, G10 L20, M109
  profile.additional_system = "G154 P";
  profile.additional_systems = 99;
  profile.asks_for_keys = true;
  profile.parameter_settings = kSettingsOfHaas;
  profile.single_direction = {ParameterId::SingleDirection, std::nullopt, 35};  // not modal there
  return profile;
}

constexpr Profile brother() {
  Profile profile = fanuc_16i();
  profile.name = "brother";
  profile.text = "Brother C00";
  profile.has_then = false;
  profile.rotates_in_space = false;
  profile.loops = {4, 4};
  profile.missing_g_codes = kMissingOfBrother;
  profile.own_g_codes = CodeSet::Brother;
  // C00 NC programming manual eCOM3NCPR, 6.7: "tool replacement canned cycle (G100/M06)", G36 to
  // G39, G120 to G129, G133, G134 and G177 to G189 by these names; M98Hxxxx looks for a sequence
  // number.  Of P and H in one block it says nothing.
  profile.replaces_tools = true;
  profile.start_letter = 'H';
  profile.starts_in_called = false;
  // Published post processors for it write G4 P0.6 for 0.6 s, older ones P600, and #3006=(TEXT).
  profile.dwell_point_is_seconds = true;
  profile.has_bare_message = true;
  profile.calls = {4, 8, 8};
  profile.macro_alarm.base = 9000;
  profile.macro_alarm.largest = 999;
  profile.macro_alarm.text_length = 20;
  profile.output.without_popen = OutputRule::WithoutPopen::Alarm;
  profile.output.most_digits = 9;
  profile.output.counts_sides_apart = true;  // the same manual, page 6-30
  profile.output.most_variables = 10;
  return profile;
}

constexpr Profile kProfiles[] = {fanuc_16i(),    fanuc_30i(), fanuc_0i(), meldas(),
                                 mazatrol_iso(), haas(),      brother()};

/// Models that run as a profile does, but for a few codes.
struct ModelProfile {
  std::string_view model;
  Profile profile;
};
constexpr ModelProfile kModelProfiles[] = {{"0i-MD", fanuc_0i_d()},
                                           {"0i-MF", fanuc_0i_f()},
                                           {"0i-D", fanuc_0i_d()},
                                           {"0i-F", fanuc_0i_f()}};

const GCode* unless_missing(const GCode* code, const Profile& profile) {
  const auto missing = profile.missing_g_codes;
  const bool is_missing = code != nullptr && code->set == CodeSet::Family && !missing.empty() &&
                          !(code->number < missing.front()) &&  // as the codes of nearly all blocks
                          std::ranges::binary_search(missing, code->number);
  return is_missing ? nullptr : code;
}

consteval bool missing_codes_rise() {
  return std::ranges::all_of(kProfiles, [](const Profile& profile) {
    return std::ranges::is_sorted(profile.missing_g_codes);
  });
}
static_assert(missing_codes_rise(), "missing_g_codes are searched as rising");

}  // namespace

std::span<const Profile> profiles() {
  return kProfiles;
}

const GCode* find_g_code(GNumber number, const Profile& profile) {
  return unless_missing(find_g_code(number, profile.own_g_codes), profile);
}

[[gnu::hot]] const GCode* find_g_code(double value, const Profile& profile) {
  return unless_missing(find_g_code(value, profile.own_g_codes), profile);
}

bool has_g_code(const Profile& profile, const GCode& code) {
  return find_g_code(code.number, profile) == &code;
}

std::string work_system_name(int system, const Profile& profile) {
  constexpr int kBeforeG54 = 53;
  return system <= kWorkSystems
             ? fmt::format("G{}", kBeforeG54 + system)
             : fmt::format("{}{}", profile.additional_system, system - kWorkSystems);
}

const Profile* find_profile(std::string_view name) {
  const auto* const row = std::ranges::find(kProfiles, name, &Profile::name);
  return row != std::end(kProfiles) ? row : nullptr;
}

const Profile& profile_of_model(const Profile& profile, std::string_view model) {
  const auto* const row = std::ranges::find(kModelProfiles, model, &ModelProfile::model);
  return row != std::end(kModelProfiles) ? row->profile : profile;
}

}  // namespace g31::fanuc
