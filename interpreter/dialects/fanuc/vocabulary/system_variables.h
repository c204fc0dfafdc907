#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace g31::fanuc {

/// What a system variable counts in.
enum class Unit {
  None,
  Bit,   ///< 0 or 1
  Bits,  ///< an integer whose bits mean something each
  Milliseconds,
  Hours,
  Length,  ///< in the unit in force
  Axis,    ///< Length for X Y Z, degrees for A B C
};

enum class Access {
  Read,
  Write,
  ReadWrite,
  Input,  ///< a program only reads it, the set-up sheet gives its value
};

enum class WhileMoving { Enabled, Disabled };

/// What a row of system_variables.def holds: rows of shows.def.
enum class Shows : std::uint8_t {
#define SHOWS(name, read, write) name,
#include "interpreter/dialects/fanuc/vocabulary/shows.def"
#undef SHOWS
};

/// Sets of rows that controls have or have not.
enum class VariableGroup : std::uint8_t {
  Basic,  ///< every control
  Series30i,
  ExecutingModal,  ///< modal data of the block in execution
  LegacyOffsets,   ///< #2500 to #2806
  OffsetsAt7001,   ///< #7001 to #7960: G54.1 P1 to P48
  LongOffsets,     ///< #14001 to #20000: G54.1 P1 to P300
  OffsetsA,        ///< tool offset memory A: one value a number
  OffsetsB,        ///< geometry and wear
  OffsetsC,        ///< geometry and wear, of length and of radius
  OffsetsCTurned,  ///< C with parameter 6000.3 = 1
  OffsetsMeldas,
  OffsetsHaas,
  ExternalOffset,  ///< #5201 is the external work offset
  ShiftAt5201,     ///< #5201 is the shift of G52
  WordsByNumber,   ///< #4102 to #4130: the words that Fanuc shows
  HaasTables,      ///< #10000 and on, settings, parameters, inputs, outputs (MB-360)
  MeldasCommons,   ///< #400 and on, #100100 and on, #900000 and on
};

/// A set of groups.
class VariableGroups {
 public:
  constexpr VariableGroups(std::initializer_list<VariableGroup> groups) {
    for (const VariableGroup group : groups) {
      bits_ |= bit(group);
    }
  }
  [[nodiscard]] constexpr bool meets(VariableGroups other) const {
    return (bits_ & other.bits_) != 0;
  }
  [[nodiscard]] constexpr VariableGroups with(VariableGroup group) const {
    VariableGroups more = *this;
    more.bits_ |= bit(group);
    return more;
  }
  [[nodiscard]] constexpr VariableGroups without(VariableGroup group) const {
    VariableGroups fewer = *this;
    fewer.bits_ &= ~bit(group);
    return fewer;
  }

 private:
  static constexpr std::uint32_t bit(VariableGroup group) {
    return std::uint32_t{1} << static_cast<unsigned>(group);
  }
  std::uint32_t bits_ = 0;
};

/// One row of system_variables.def: a run of numbers that mean the same thing for axes, offsets or
/// groups 1, 2...
struct SystemVariable {
  int first;
  int last;
  Shows shows;
  VariableGroups groups;
  Unit unit;
  Access access;
  WhileMoving while_moving;
  std::string_view text;
};

/// Work offsets stand in runs of 20 numbers, one run a system, one number an axis (MB-145).
inline constexpr int kNumbersPerSystem = 20;
inline constexpr int kFirstWorkOffset = 5201;  ///< the external one; G54 to G59 follow

/// All rows of all controls, rising by their first number.
std::span<const SystemVariable> system_variables();

/// The system variables that one control has.
class SystemVariableIndex {
 public:
  explicit SystemVariableIndex(VariableGroups groups);

  /// The row that holds #number, or nullptr when the control has no such variable (alarm 115).
  [[nodiscard]] const SystemVariable* find(int number) const;

  /// Rising, without overlap.
  [[nodiscard]] std::span<const SystemVariable* const> rows() const { return rows_; }

 private:
  std::vector<const SystemVariable*> rows_;
};

}  // namespace g31::fanuc
