#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "machine/base/indexed_by.h"

namespace g31::fanuc {

inline constexpr int kWorkSystems = 6;  ///< G54 to G59
/// From here on builders and shops take G codes to call macros by, up to what parameters 6050 to
/// 6059 take.
inline constexpr double kFirstCallingCode = 100.0;
inline constexpr double kLastCallingCode = 9999.0;

/// What a G code makes the control do; the interpreter has one function for each.
enum class GAction : std::uint8_t {
  Modal,            ///< only sets its group
  NoEffect,         ///< one-shot, and nothing that is simulated depends on it
  ExactStop,        ///< one-shot: says how the motion of its block ends
  ContourControl,   ///< one-shot: Q switches it
  SingleDirection,  ///< one-shot, or a kind of motion by a parameter
  Motion,
  Dwell,
  SetData,
  EndData,
  CheckReference,
  ToReference,
  FromReference,
  Skip,
  MeasureTool,
  MeasureDiameter,
  MeasureWork,
  MeasureCentre,
  ToolLength,
  TipControl,  ///< a tool length code, with tool centre point control
  LocalShift,
  MachineMove,
  WorkOffset,
  MacroCall,
  SetPosition,
  PresetSystem,
  PolarOn,
  PolarOff,
  Mirror,
  MirrorOff,
  Scaling,
  ScalingOff,
  Rotation,
  TiltedPlane,
  ToolToPlane,
  TableOffset,       ///< G54.2
  SettingError,      ///< G54.4
  OriginOnTable,     ///< G254
  OriginOnTableOff,  ///< G255
  RotationOff,
  CannedCycle,
  HolePattern,  ///< takes the words of its block, and drills with the cycle in force
  CycleOff,
  StrokeCheck,
  LengthUnit,       ///< a modal code that says what lengths count
  FeedType,         ///< a modal code that says what F means
  SurfaceSpeed,     ///< a modal code that says what S means
  ToolReplacement,  ///< changes the tool and goes to where it begins
  Unsimulated,      ///< one-shot: takes the words of its block, nothing happens
  Refused,          ///< not simulated, and the way would be another one without it
};

/// Whether a run tells that it passes over a code.
constexpr bool is_passed_over(GAction action) {
  return action == GAction::Unsimulated;
}

/// Which controls of the family have a G code; a Mazak has those of MELDAS, too, and its own in the
/// place of theirs.
enum class CodeSet : std::uint8_t { Family, Meldas, Haas, Brother, Mazak };

/// Groups of modal codes; the value is n of #4000+n, which shows the code in force.
enum class Group : std::uint8_t {
  OneShot = 0,  ///< none: in its own block only, shown nowhere
#define G_GROUP(name, number, text) name = number,
#include "interpreter/dialects/fanuc/vocabulary/g_groups.def"
#undef G_GROUP
};

/// A G number as it is written: 54.1 is {54, 1}.
struct GNumber {
  std::int16_t whole = 0;
  std::int8_t tenth = 0;
  friend auto operator<=>(GNumber, GNumber) = default;
  [[nodiscard]] double value() const { return whole + tenth / 10.0; }
};

/// "G54.1"
std::string to_text(GNumber number);

/// One row of g_codes.def.
struct GCode {
  GNumber number;
  Group group;
  GAction action;
  CodeSet set;
  std::string_view text;
};

inline constexpr int kGroupCount = 32;

/// The code in force of each group.
using GroupCodes = IndexedBy<Group, GNumber, kGroupCount>;

/// All rows, rising.
std::span<const GCode> g_codes();

/// The row of a number for a control that has the codes of `own` beside and in the place of those
/// of the family, or nullptr.
const GCode* find_g_code(GNumber number, CodeSet own);
/// That of a word's value; nullptr also when it is negative, too large or has more decimals.
const GCode* find_g_code(double value, CodeSet own);

}  // namespace g31::fanuc
