#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "interpreter/runtime/input_scripts.h"
#include "machine/kinematics/axis_chain.h"
#include "machine/port/machine_port.h"
#include "machine/units/axis_positions.h"

namespace g31::runtime {

/// One line of the tool table: what the *control* believes (H and D numbers, or T).
struct ToolEntry {
  double length_mm = 0.0;
  double length_wear_mm = 0.0;
  double radius_mm = 0.0;
  double radius_wear_mm = 0.0;
  std::string name = {};  ///< for controls that call tools by name
  double type = 0.0;      ///< of SINUMERIK: 120 end mill, 710 3D probe, ...

  bool operator==(const ToolEntry&) const = default;
};

/// How much a control keeps for one tool offset number: one value for all (A), geometry and wear
/// (B), both of length and of radius (C).
enum class OffsetMemory { A, B, C };

/// What the operator's panel makes of programmed feeds.
struct FeedSwitches {
  double override_percent = 100.0;
  double dry_run_mm_min = 0.0;  ///< takes the place of every feed; 0: no dry run

  bool operator==(const FeedSwitches&) const = default;
};

/// What a work offset does beside shifting, X, Y and Z; of controls whose offsets are frames.
struct OffsetShape {
  std::vector<double> rotate_deg = {0.0, 0.0, 0.0};
  std::vector<double> fine_mm = {0.0, 0.0, 0.0};
  std::vector<double> scale = {1.0, 1.0, 1.0};
  std::string mirrored = {};  ///< letters
};

/// U, V or W: mm and mm/min, machine coordinates.
struct FurtherAxisSetup {
  double home = 0.0;
  double rapid_per_min = 20000.0;
  double travel_min = -1e8;
  double travel_max = 1e8;
};

/// Where a control with words for inputs shows a displacement sensor.
struct SensorWord {
  int number = 0;         ///< of the variable
  int input = 0;          ///< analog input that the sensor is wired to
  double count_mm = 0.0;  ///< > 0, what a count is worth
};

/// What a control does not take of its set-up.
struct RefusedSetting {
  std::string key;      ///< of the sheet: "variables.#500", "work_offsets.G59", "tools.9"
  std::string message;  ///< one line
};

/// The state of a control before the program starts, as a set-up sheet describes it.  Plain data:
/// each dialect takes what it knows and reports names it does not.
struct ControlSetup {
  std::string profile;    ///< "" = chosen by content and file ending
  std::string increment;  ///< "IS-A", "IS-B", "IS-C" or "" = profile's
  std::string axes;       ///< letters in the order of controlled axes; "" = X Y Z A B C
  OffsetMemory offset_memory = OffsetMemory::C;
  int lookahead_blocks = 0;  ///< NC blocks buffered behind the running one; 0: every read waits
  FeedSwitches feed_switches;
  std::optional<machine::RapidPath> rapids;  ///< nullopt: as the profile has it
  std::set<int> block_skip;                  ///< switches that are on, 1..9
  std::string variables_file;                ///< non-volatile variables; "" = none
  std::string files_folder;                  ///< where the program's files are; "" = nowhere
  /// "6001.1" is bit 1 of 6001, "3410" a value, "1240.X" a value of one axis.
  std::map<std::string, double> parameters;
  /// Where the machine's axes have their reference marks; parameters win.
  AxisPositions q_M_reference = AxisPositions::Zero();
  std::map<std::string, int> macro_calls;  ///< "G100" -> 9010
  /// "#515" -> 6.0; nullopt is vacant.  A string value is for dialects that have strings.
  std::map<std::string, std::optional<double>> variables;
  /// Those of them that come from the variables file, which the control keeps over power-off.
  std::set<std::string> kept_variables;
  /// Machine data and user data of controls that have such: a number, a text, "axis X" or a list.
  std::map<std::string, std::variant<double, std::string, std::vector<double>>> data;
  /// What programs call axes beside their letters: "SP1" to 'C'.
  std::map<std::string, char> axis_names;
  /// U, V and W, where the machine has them: they carry neither tool nor part.
  std::map<char, FurtherAxisSetup> further_axes;
  /// The number of the spindle that turns tools; nullopt: as the control has it on such a machine.
  std::optional<int> tool_spindle;
  std::vector<InputStep> inputs;  ///< what [[input]] scripts
  std::string keys;  ///< that the operator presses, one for each prompt of the program; ASCII
  std::vector<SensorWord> sensor_words;  ///< of [[sensor]], by controls that have such words
  /// Soft limits of axes, where the machine has any.
  std::map<int, std::pair<double, double>> q_M_travel;
  std::map<std::string, AxisPositions>
      work_offsets;                                  ///< "G54".."G59", "EXT", "G54.1 P1", "G154 P1"
  std::map<std::string, OffsetShape> offset_shapes;  ///< of some of them
  std::map<int, ToolEntry> tools;                    ///< by H/D/T number
  /// What the control takes the machine for; the machine is what it is.
  machine::AxisChainSetup kinematics;
};

}  // namespace g31::runtime
