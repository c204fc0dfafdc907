#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "machine/units/axis_positions.h"

namespace g31::sinumerik {

/// What an NC word addresses: the axes in storage order, then the rows of addresses.def.
enum class Address : std::uint8_t {
  FirstAxis = 0,
  LastAxis = kAxisCount - 1,
#define ADDRESS(id, name, least, most, text) id,
#include "interpreter/dialects/sinumerik/vocabulary/addresses.def"
#undef ADDRESS
  Count
};

constexpr std::size_t index_of(Address address) {
  return static_cast<std::size_t>(address);
}

struct AddressInfo {
  std::string_view name;
  double least;
  double most;
  std::string_view text;
};

/// mm, deg: how far from their zero the control takes places of axes.
inline constexpr double kFarthestPlace = 1e9;

/// The rows of addresses.def.
std::span<const AddressInfo> addresses();

/// @param name  upper case; axes are not among them
std::optional<Address> find_address(std::string_view name);

/// "X", "CR"
std::string_view name_of(Address address);

struct ValueRange {
  double least = -kFarthestPlace;
  double most = kFarthestPlace;
  [[nodiscard]] bool holds(double value) const { return value >= least && value <= most; }
};

/// The values that the control takes at an address at all.
ValueRange range_of(Address address);

inline constexpr int kMostSpindles = 20;
inline constexpr int kMostProbes = 8;   ///< MEAS=1 and on
inline constexpr int kFixedPoints = 4;  ///< FP=1 and on
inline constexpr int kMostMachineCodes = 5;
inline constexpr int kMostAuxiliaryCodes = 3;

/// What a setting of the spindle has in the place of an axis.
inline constexpr int kSpindleAxis = kAxisCount;

/// U, V and W carry neither tool nor part: tailstocks, steady rests, loaders.  They stand behind
/// the spindle among the numbers that a value of type AXIS may have.
inline constexpr std::string_view kFurtherAxes = "UVW";
inline constexpr int kFirstFurtherAxis = kSpindleAxis + 1;
inline constexpr std::size_t kAxisNumbers = kFirstFurtherAxis + kFurtherAxes.size();

/// @param axis  a value of type AXIS, or kSpindleAxis
constexpr bool is_machine_axis(int axis) {
  return axis >= 0 && axis < static_cast<int>(kAxisCount);
}
constexpr bool is_further_axis(int axis) {
  return axis >= kFirstFurtherAxis && axis < static_cast<int>(kAxisNumbers);
}
/// Whether frames shift an axis: the spindle they do not.
constexpr bool has_frame(int axis) {
  return is_machine_axis(axis) || is_further_axis(axis);
}
/// Whether an axis counts in lengths.
constexpr bool is_length_axis(int axis) {
  return is_further_axis(axis) || (is_machine_axis(axis) && is_linear_axis(axis));
}
/// "X", "S" of the spindle, "W"
constexpr char letter_of_axis(int axis) {
  return is_machine_axis(axis)   ? kAxisLetters[axis]
         : is_further_axis(axis) ? kFurtherAxes[static_cast<std::size_t>(axis - kFirstFurtherAxis)]
                                 : 'S';
}
/// @param axis  X to C, or U, V, W
constexpr Address address_of_axis(int axis) {
  return static_cast<Address>(
      is_further_axis(axis) ? static_cast<int>(Address::AxisU) + axis - kFirstFurtherAxis : axis);
}

/// How often an address may stand in a block.
constexpr int most_in_block(Address address) {
  return address == Address::Machine     ? kMostMachineCodes
         : address == Address::Auxiliary ? kMostAuxiliaryCodes
                                         : 1;
}

/// How the value of a word counts: rows of modifications.def.
enum class Modification : std::uint16_t {
  None,
#define MODIFICATION(id, name, text) id,
#include "interpreter/dialects/sinumerik/vocabulary/modifications.def"
#undef MODIFICATION
};

struct ModificationInfo {
  Modification modification;
  std::string_view name;
  std::string_view text;
};

std::span<const ModificationInfo> modifications();

/// Whether a word says itself whether it counts in diameter or in radius.
constexpr bool says_across(Modification modification) {
  return modification == Modification::AbsoluteDiameter ||
         modification == Modification::IncrementalDiameter ||
         modification == Modification::AbsoluteRadius ||
         modification == Modification::IncrementalRadius;
}
constexpr bool is_incremental(Modification modification) {
  return modification == Modification::Incremental ||
         modification == Modification::IncrementalDiameter ||
         modification == Modification::IncrementalRadius;
}
constexpr bool is_absolute(Modification modification) {
  return modification == Modification::Absolute || modification == Modification::AbsoluteDiameter ||
         modification == Modification::AbsoluteRadius;
}

/// @param name  upper case
std::optional<Modification> find_modification(std::string_view name);

/// Words with an axis in brackets: rows of axis_words.def.
enum class AxisWordId : std::uint8_t {
#define AXIS_WORD(id, name, role, least, most, text) id,
#include "interpreter/dialects/sinumerik/vocabulary/axis_words.def"
#undef AXIS_WORD
};

enum class AxisRole : std::uint8_t {
  Path,
  Positioning,
  Measuring,
  Setting,
  AxisSetting,
  Switch,
  AxisSwitch,
  Refused
};

/// Whether words of a role keep a number for an axis.
constexpr bool is_setting(AxisRole role) {
  return role == AxisRole::Setting || role == AxisRole::AxisSetting || role == AxisRole::Switch ||
         role == AxisRole::AxisSwitch;
}
/// Whether they stand alone, without a value.
constexpr bool is_switch(AxisRole role) {
  return role == AxisRole::Switch || role == AxisRole::AxisSwitch;
}
/// Whether the spindle may stand in the place of the axis.
constexpr bool takes_spindle(AxisRole role) {
  return role == AxisRole::Setting || role == AxisRole::Switch;
}

struct AxisWordInfo {
  AxisWordId id;
  std::string_view name;
  AxisRole role;
  double least;  ///< of a setting; what a switch stands for
  double most;
  std::string_view text;
};

std::span<const AxisWordInfo> axis_words();
const AxisWordInfo& info(AxisWordId id);
/// The axis that a name means on any machine: X or W, the machine axis X1 or MX1 behind it, or AX1,
/// the first axis; -1: none.
/// @param name  upper case
int axis_named(std::string_view name);

/// @param name  upper case; nullptr: no such word
const AxisWordInfo* find_axis_word(std::string_view name);

/// Rows of procedures.def.
enum class ProcedureId : std::uint8_t {
#define PROCEDURE(name, parameters, work, form, text) name,
#include "interpreter/dialects/sinumerik/vocabulary/procedures.def"
#undef PROCEDURE
};

/// What a procedure does to the flow of programs.
enum class ProcedureEffect : std::uint8_t {
  None,
  RunsText,     ///< which may jump, call and end the program
  WritesFiles,  ///< which may be called
};

constexpr ProcedureEffect effect_of(ProcedureId id) {
  switch (id) {
#define Done(f) ProcedureEffect::None
#define RunsText(f) ProcedureEffect::RunsText
#define Reports(f) ProcedureEffect::None
#define Writes(f) ProcedureEffect::WritesFiles
#define Nothing() ProcedureEffect::None
#define PROCEDURE(name, parameters, work, form, text) \
  case ProcedureId::name:                             \
    return work;
#include "interpreter/dialects/sinumerik/vocabulary/procedures.def"
#undef PROCEDURE
#undef Nothing
#undef Writes
#undef Reports
#undef RunsText
#undef Done
  }
  return ProcedureEffect::None;
}

struct ProcedureInfo {
  std::string_view name;
  std::string_view parameters;
  std::string_view form;
  std::string_view text;
};

/// Statements: rows of keywords.def.
struct KeywordInfo {
  std::string_view name;
  std::string_view form;
  std::string_view text;
  bool is_refused;  ///< where a program comes to it
};

std::span<const KeywordInfo> keywords();

/// A machining cycle that g31 has no program for.
struct CycleInfo {
  std::string_view name;
  std::string_view text;
};
std::span<const CycleInfo> unsimulated_cycles();
/// @param name  as programs write it; nullptr: none of them
const CycleInfo* find_unsimulated_cycle(std::string_view name);

std::span<const ProcedureInfo> procedures();
std::optional<ProcedureId> find_procedure(std::string_view name);

}  // namespace g31::sinumerik
