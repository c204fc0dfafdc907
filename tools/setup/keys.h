#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace g31::setup {

/// Rows SETUP_SECTION of keys.def.
enum class SectionId {
#define SETUP_SECTION(id, path, form, name_form, example, text) id,
#define SETUP_KEY(id, section, name_form, name, type, limit, unit, default_text, example, text)
#include "tools/setup/keys.def"
#undef SETUP_SECTION
#undef SETUP_KEY
};

/// Rows SETUP_KEY of keys.def.
enum class KeyId {
#define SETUP_SECTION(id, path, form, name_form, example, text)
#define SETUP_KEY(id, section, name_form, name, type, limit, unit, default_text, example, text) id,
#include "tools/setup/keys.def"
#undef SETUP_SECTION
#undef SETUP_KEY
};

enum class SectionForm { One, Named, List };

/// U, V and W, which carry neither tool nor part.
constexpr bool is_further_axis(std::string_view letter) {
  return letter == "U" || letter == "V" || letter == "W";
}

/// What a free name must look like.
enum class NameForm {
  Exact,             ///< no free name
  AxisLetter,        ///< X Y Z A B C
  AnyAxisLetter,     ///< the same, and U V W
  ParameterNumber,   ///< 3410, or 6001.1 with a bit 0..7
  MacroCallCode,     ///< G100, M6
  VariableName,      ///< see variable_name.h
  WorkOffset,        ///< G54..G59, EXT, G54.1 Pn, G154 Pn, G505..G599
  ToolNumber,        ///< 0..99999999
  SizeName,          ///< any name
  RotaryLetter,      ///< A B C
  ErrorName,         ///< EXX: E, a direction X Y Z A B C, a linear axis X Y Z
  CompensationName,  ///< EXX: the same with a direction X Y Z
};

enum class ValueType {
  Text,
  Path,  ///< text; a relative one starts at the sheet's folder
  Number,
  NumberOrFlag,    ///< true is 1, false is 0
  NumberOrVacant,  ///< "" is vacant
  WholeNumber,
  WholeNumbers,
  TwoNumbers,
  ThreeNumbers,
  NumberOrNumbers,  ///< a list of one number, or of as many as it has
  NumberOrTable,    ///< a list of one number, or of pairs
  Datum,            ///< a number, a text or a list of numbers; true is 1, false is 0
  ExpectedNumber,   ///< a number or [value, tolerance]: a list of these two
  ExpectedValue,    ///< that, or a text
};

/// Which values of the right type are allowed.
enum class Limit {
  Any,
  Positive,
  Resolution,  ///< 1e-9..1e9
  NotNegative,
  Share,          ///< 0..1
  Bit,            ///< 0 or 1
  SwitchNumber,   ///< 1..9, each element
  ProgramNumber,  ///< 1..99999999
  BlockCount,     ///< 0..9999
  Rising,         ///< the first below the second
  NotEmpty,
  MeshUnit,  ///< a row of mesh_units.def
  IncrementSystem,
  OffsetMemory,
  RapidPath,
  StoppingKind,
  ProbeType,
  SeatKind,
  ProbeState,
  MeasuringInput,  ///< 1..8
  DigitalInput,    ///< 1..64, 1000..1015 or 11016..11255
  SensorWord,      ///< 1032..1035 or 1132..1135, or less 1000
  ColumnName,      ///< letters, digits and _ . - +
  ToolOfProbe,     ///< 1..99999999
  ToolKind,        ///< a row of probe::kToolKindNames
  ToolProbeShape,  ///< a row of probe::kToolProbeShapeNames
  ToolProbeSide,   ///< bed or table
  EdgePosition,    ///< 1..9
  TipAngle,        ///< above 0, 180 at most
  MachineCode,     ///< M and a number
  ProgramSwitch,   ///< that, #1100 to #1115 or $A_OUT[n]
  AxisLetter,
  AxisLetters,     ///< no letter twice
  WorkOffsetName,  ///< as NameForm::WorkOffset
  NotAllZero,
  NoneZero,
  RunStatus,     ///< as the document of a run has it
  RisingPlaces,  ///< the first numbers of pairs
  VariableName,  ///< as NameForm::VariableName
  ResultUnit,    ///< a row of result_units.def
  KeyPresses,    ///< printable ASCII
  Tolerance,     ///< 0 or more, or two numbers, the first below the second
};

struct SectionRow {
  SectionId id;
  std::string_view path;
  SectionForm form;
  NameForm name_form;
  std::string_view example;
  std::string_view text;
};

struct KeyRow {
  KeyId id;
  SectionId section;
  NameForm name_form;
  std::string_view name;  ///< the key, or for free names the rule in words
  ValueType type;
  Limit limit;
  std::string_view unit;
  std::string_view default_text;
  std::string_view example;
  std::string_view text;
};

/// All rows in the order of keys.def.
std::span<const SectionRow> section_rows();
std::span<const KeyRow> key_rows();

const SectionRow& row_of(SectionId id);

/// The section whose whole path is `path`, or nullptr.
const SectionRow* find_section(std::string_view path);

/// What a key of a sheet turned out to be.
struct FoundKey {
  const KeyRow* row = nullptr;
  std::string name;  ///< the one spelling: "#0515" is "#515"
};

/// The row for a key of a section; a row with a free name only when no exact row fits.
std::optional<FoundKey> find_key(SectionId section, std::string_view key);

/// The one spelling of a free name, or nullopt when it does not have that form.
std::optional<std::string> normal_name(NameForm form, std::string_view name);

/// The sections inside a section, by the last part of their path.
std::vector<std::string_view> inner_sections(SectionId section);

/// Names that a misspelt key of the section may have meant.
std::vector<std::string_view> known_keys(SectionId section);

/// Names that a misspelt free name may have meant; empty where they are without number.
std::vector<std::string_view> known_names(NameForm form);

/// A free name in words, for "it should be ...".
std::string_view rule_of(NameForm form);

}  // namespace g31::setup
