#include "interpreter/dialects/sinumerik/state/channel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "machine/units/within_turn.h"

namespace g31::sinumerik {
namespace {

bool is_length(Component component) {
  return component == Component::Coarse || component == Component::Fine;
}

constexpr int kInch = number_in_group("G70");
constexpr int kInchAndFeed = number_in_group("G700");
constexpr int kPlaneZx = number_in_group("G18");
constexpr int kPlaneYz = number_in_group("G19");
constexpr int kRadius = number_in_group("DIAMOF");
constexpr int kDiameterAlways = number_in_group("DIAMON");
constexpr int kDiameterAbsolute = number_in_group("DIAM90");

/// MD20150 counts for these: their codes are in force without a word more.
constexpr Group kGroupsOfData[] = {
    Group::Plane,    Group::SettableFrame, Group::BlockTransition, Group::ExactStopWindow,
    Group::Unit,     Group::Distance,      Group::FeedType,        Group::ArcFeed,
    Group::Approach, Group::OutsideCorner, Group::Acceleration,    Group::Diameter};

}  // namespace

Failure no_such_axis(int axis) {
  return failure(
      AlarmId::NoSuchAddress,
      fmt::format("{0}; [machine.axes.{0}] in the set-up sheet adds it", letter_of_axis(axis)));
}

Failure no_frame_of(int axis) {
  return is_further_axis(axis)
             ? failure(AlarmId::NotImplemented,
                       fmt::format("{} in a block that measures or that sets what is none of its "
                                   "own",
                                   letter_of_axis(axis)))
             : failure(AlarmId::BadAxisIndex);
}

Channel::Channel(machine::MachinePort& machine, runtime::Observer& listener, const Globals& globals)
    : motion_data(globals),
      compensation_data(globals),
      transformation_data(globals),
      port(machine),
      observer(listener),
      outlet(machine, listener),
      frame_save_mask_(static_cast<std::size_t>(globals.find("$MN_FRAME_SAVE_MASK")->place)),
      program_function_mask_(
          static_cast<std::size_t>(globals.find("$MN_PROG_FUNCTION_MASK")->place)),
      upper_soft_limits_(static_cast<std::size_t>(globals.find("$MA_POS_LIMIT_PLUS")->place)),
      lower_soft_limits_(static_cast<std::size_t>(globals.find("$MA_POS_LIMIT_MINUS")->place)),
      rounding_tolerances_(static_cast<std::size_t>(globals.find("$MA_COMPRESS_POS_TOL")->place)),
      base_frames_(static_cast<std::size_t>(globals.find("$MC_MM_NUM_BASE_FRAMES")->place)),
      global_base_frames_(
          static_cast<std::size_t>(globals.find("$MN_MM_NUM_GLOBAL_BASE_FRAMES")->place)),
      rotary_is_modulo_(static_cast<std::size_t>(globals.find("$MA_ROT_IS_MODULO")->place)),
      axis_function_masks_(static_cast<std::size_t>(globals.find("$MA_MISC_FUNCTION_MASK")->place)),
      measuring_mask_(static_cast<std::size_t>(globals.find("$MNS_MEA_FUNCTION_MASK")->place)),
      simultaneous_limit_(static_cast<std::size_t>(globals.find("$SCS_MEA_SIMULTAN_LIMIT")->place)),
      rapids_are_straight_(static_cast<std::size_t>(globals.find("$MC_G0_LINEAR_MODE")->place)),
      codes_at_start_(static_cast<std::size_t>(globals.find("$MC_GCODE_RESET_VALUES")->place)),
      technology_(static_cast<std::size_t>(globals.find("$MCS_TECHNOLOGY")->place)),
      tool_parameter_mask_(
          static_cast<std::size_t>(globals.find("$MC_TOOL_PARAMETER_DEF_MASK")->place)),
      length_plane_(static_cast<std::size_t>(globals.find("$SC_TOOL_LENGTH_CONST")->place)),
      turning_length_plane_(
          static_cast<std::size_t>(globals.find("$SC_TOOL_LENGTH_CONST_T")->place)),
      length_kind_(static_cast<std::size_t>(globals.find("$SC_TOOL_LENGTH_TYPE")->place)),
      spindles_of_axes_(
          static_cast<std::size_t>(globals.find("$MA_SPIND_ASSIGN_TO_MACHAX")->place)),
      speed_limits_{static_cast<std::size_t>(globals.find("$MA_SPIND_VELO_LIMIT")->place),
                    static_cast<std::size_t>(globals.find("$SA_SPIND_MAX_VELO_G26")->place),
                    static_cast<std::size_t>(globals.find("$SA_SPIND_MAX_VELO_LIMS")->place)},
      tool_change_mode_(static_cast<std::size_t>(globals.find("$MC_TOOL_CHANGE_MODE")->place)),
      diameter_axis_(static_cast<std::size_t>(globals.find("$MC_DIAMETER_AX_DEF")->place)),
      carrier_fine_(static_cast<std::size_t>(globals.find("$SC_TOCARR_FINE_CORRECTION")->place)),
      most_carriers_(static_cast<std::size_t>(globals.find("$MN_MM_NUM_TOOL_CARRIER")->place)) {
  numbers = globals.layout().numbers;
  for (const Group one : kGroupsOfData) {
    numbers[code_at_start(one)] = preset_number(one);
  }
  motion_data.take(port.axis_data(), numbers);
  texts.resize(static_cast<std::size_t>(globals.layout().texts));
  frames.resize(static_cast<std::size_t>(globals.layout().frames));
  settable.resize(kSettableFrames);
  for (int i = 0; i < kGroupCount; ++i) {
    group.at(static_cast<std::size_t>(i)) = preset_number(static_cast<Group>(i));
  }
  for (const Group one_block : kOneBlockGroups) {
    group[one_block] = 0;
  }
}

std::optional<double> Channel::simultaneous_limit() const {
  constexpr unsigned kSimultaneously = 1U << 14U;
  return (bits_of(numbers[measuring_mask_]) & kSimultaneously) != 0
             ? std::optional(numbers[simultaneous_limit_])
             : std::nullopt;
}

bool Channel::is_lathe() const {
  constexpr double kTurning = 1.0;
  constexpr int kAxisY = 1;
  return numbers[technology_] == kTurning || (port.travel(kTransverseAxis) && !port.travel(kAxisY));
}

std::size_t Channel::code_at_start(Group one) const {
  return codes_at_start_ + static_cast<std::size_t>(one) - 1;
}

void Channel::preset_codes() {
  for (const Group one : kGroupsOfData) {
    const double number = numbers[code_at_start(one)];
    const auto is_row = [&](const GCode& code) {
      return code.group == one && code.action != GAction::Refused &&
             static_cast<double>(code.number) == number;
    };
    if (std::ranges::any_of(g_codes(), is_row)) {
      group[one] = static_cast<int>(number);
    }
  }
  if (is_lathe() && group[Group::Plane] == preset_number(Group::Plane)) {
    group[Group::Plane] = kPlaneZx;
  }
  take_stored_frames();
  frames_changed();
}

void Channel::make_master(int spindle_number) {
  const int old = master_number();
  if (spindle_number != old) {
    other_spindles[old] = spindle;
    spindle = other_spindles[spindle_number];
    other_spindles.erase(spindle_number);
    master_spindle = spindle_number;
  }
}

int Channel::port_spindle(int spindle_number) const {
  constexpr int kOfLathe = 3;  // 1 and 2 turn parts
  const int of_tools = tool_spindle.value_or(is_lathe() ? kOfLathe : machine::kToolSpindle);
  return spindle_number == of_tools ? machine::kToolSpindle
                                    : machine::kToolSpindle + spindle_number;
}

std::optional<int> Channel::axis_of_spindle(int spindle_number) const {
  if (spindle_number < 1) {
    return std::nullopt;  // what the data of axes without a spindle say
  }
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    // The machine is asked last: where no axis is a spindle, each speed would ask it of all.
    if (numbers[spindles_of_axes_ + static_cast<std::size_t>(axis)] == spindle_number &&
        is_rotary_axis(axis) && port.travel(axis)) {
      return axis;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> Channel::place_of(SpeedDatum datum, int spindle_number) const {
  const auto axis = axis_of_spindle(spindle_number);
  return axis ? std::optional(speed_limits_.at(static_cast<std::size_t>(datum)) +
                              static_cast<std::size_t>(*axis))
              : std::nullopt;
}

double Channel::speed_limit(SpeedDatum datum, int spindle_number) const {
  const auto place = place_of(datum, spindle_number);
  return place && motion_data.is_written(*place) ? std::max(0.0, numbers[*place])
                                                 : std::numeric_limits<double>::infinity();
}

bool Channel::keep_speed_limit(SpeedDatum datum, int spindle_number, double speed) {
  const auto place = place_of(datum, spindle_number);
  if (place) {
    numbers[*place] = speed;
    motion_data.written(*place);
  }
  return place.has_value();
}

void Channel::preset_rapids() {
  group[Group::RapidPath] =
      numbers[rapids_are_straight_] != 0.0 ? number_in_group("RTLION") : number_in_group("RTLIOF");
}

machine::RapidPath Channel::rapid_path() const {
  return group[Group::RapidPath] == number_in_group("RTLIOF") &&
                 group[Group::BlockTransition] == number_in_group("G60") &&
                 group[Group::Compressor] == number_in_group("COMPOF") &&
                 group[Group::RadiusCompensation] == number_in_group("G40")
             ? machine::RapidPath::Independent
             : machine::RapidPath::Straight;
}

bool Channel::is_modulo(int axis) const {
  return is_rotary_axis(axis) && numbers[rotary_is_modulo_ + static_cast<std::size_t>(axis)] != 0.0;
}

bool Channel::has_axis_function(int axis, AxisFunction function) const {
  const std::uint32_t mask =
      bits_of(numbers[axis_function_masks_ + static_cast<std::size_t>(axis)]);
  return ((mask >> static_cast<unsigned>(function)) & 1U) != 0U;
}

double Channel::within_turn(int axis, double degrees) const {
  return is_modulo(axis) ? machine::within_turn(degrees) : degrees;
}

Plane Channel::plane() const {
  switch (group[Group::Plane]) {
    case kPlaneZx:
      return {2, 0, 1};
    case kPlaneYz:
      return {1, 2, 0};
    default:
      return {0, 1, 2};
  }
}

double Channel::mm_per_length() const {
  return mm_per(group[Group::Unit] == kInch || group[Group::Unit] == kInchAndFeed
                    ? LengthUnit::Inch
                    : LengthUnit::Millimetre);
}

double Channel::mm_per_feed() const {
  return mm_per(group[Group::Unit] == kInchAndFeed ? LengthUnit::Inch : LengthUnit::Millimetre);
}

double Channel::mm_per_datum() const {
  return mm_per(group[Group::Unit] == kInchAndFeed ? LengthUnit::Inch : LengthUnit::Millimetre);
}

double Channel::kept_per_datum(DatumUnit unit, std::optional<int> axis) const {
  const bool counts = unit != DatumUnit::Plain && (!axis || is_length_axis(*axis));
  if (!counts || group[Group::Unit] != kInchAndFeed) {
    return 1.0;
  }
  return unit == DatumUnit::Metres ? mm_per_datum() / kMmPerMetre : mm_per_datum();
}

double Channel::stored(int axis, double value) const {
  return is_length_axis(axis) ? value * mm_per_length() : value;
}

int Channel::transverse_axis() const {
  const std::string& name = texts[diameter_axis_];
  return name.empty() ? kTransverseAxis : axis_named(name);
}

int Channel::diameter_code(int axis) const {
  if (!is_length_axis(axis)) {
    return kRadius;
  }
  if (const int own = axis_settings.diameter[static_cast<std::size_t>(axis)]; own != 0) {
    return own;
  }
  // The name of the transverse axis is looked for only where it counts.
  const int of_channel = group[Group::Diameter];
  return of_channel != kRadius && axis == transverse_axis() ? of_channel : kRadius;
}

double Channel::stored_place(int axis, double value, Counts counts,
                             Modification modification) const {
  const int code = diameter_code(axis);
  const bool doubled =
      says_across(modification)
          ? modification == Modification::AbsoluteDiameter ||
                modification == Modification::IncrementalDiameter
          : code == kDiameterAlways || (code == kDiameterAbsolute && counts == Counts::Absolute);
  return stored(axis, doubled ? value / 2.0 : value);
}

double Channel::stored_datum(int axis, double value) const {
  return is_length_axis(axis) ? value * mm_per_datum() : value;
}

double Channel::shown_datum(int axis, double value) const {
  return is_length_axis(axis) ? value / mm_per_datum() : value;
}

double Channel::shown_place(int axis, double value) const {
  const int code = diameter_code(axis);
  const bool doubled = code == kDiameterAlways || code == kDiameterAbsolute;
  return shown_datum(axis, doubled ? value * 2.0 : value);
}

double Channel::shown_component(int axis, Component component, const Frame& frame) const {
  const double value = frame.component(axis, component);
  return is_length(component) ? shown_datum(axis, value) : value;
}

MaybeFailure Channel::set_component(int axis, Component component, double value,
                                    Frame& frame) const {
  if (!Frame::takes(component, value)) {
    return failure(AlarmId::ValueOutOfLimits,
                   fmt::format("{} {:g} of a frame", letter_of_axis(axis), value));
  }
  frame.set_component(axis, component, is_length(component) ? stored_datum(axis, value) : value);
  return std::nullopt;
}

bool Channel::keeps_settable_frame() const {
  return (std::lround(numbers[frame_save_mask_]) & 1) != 0;
}

double Channel::rounding_tolerance(int axis) const {
  return numbers[rounding_tolerances_ + static_cast<std::size_t>(axis)];
}

AxisPositions Channel::upper_soft_limits() const {
  return Eigen::Map<const AxisPositions>(&numbers[upper_soft_limits_]);
}

AxisPositions Channel::lower_soft_limits() const {
  return Eigen::Map<const AxisPositions>(&numbers[lower_soft_limits_]);
}

bool Channel::orders_exactly() const {
  return (std::lround(numbers[program_function_mask_]) & 1) != 0;
}

const Channel::Chains& Channel::chains() const {
  if (!chains_) {
    chains_ = {frames_now.outer(), frames_now.inner()};
  }
  return *chains_;
}

Frame Channel::frames_below() const {
  Frame all = frames_outside().chained(settable_now);
  chain(all, chains().inner);
  return all;
}

Frame Channel::active_frame() const {
  switch (suppression) {
    case 1:  // G53
      return frames_outside();
    case 2:  // SUPA
    case 3:  // G153
      return {};
    default: {
      Frame all = frames_below().chained(program_frame);
      chain(all, frames_now.cycle);
      return all;
    }
  }
}

}  // namespace g31::sinumerik
