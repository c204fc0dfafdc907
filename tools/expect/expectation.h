#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/shown_value.h"
#include "interpreter/source/source_map.h"
#include "machine/base/result.h"
#include "tools/expect/characteristic.h"

namespace g31::expect {

/// A number and how far the true one may be from it.
struct Within {
  double value = 0.0;
  double tolerance = 0.0;
};

/// From and to, both allowed.
struct Range {
  double from = 0.0;
  double to = 0.0;
};

/// What a variable is to be: a number, vacant (a cell of none), or a text.
using ExpectedValue = std::variant<Within, runtime::ShownValue>;

// What is to be looked at; each with the value that it should have.

struct Status {
  std::string name;  ///< as the document of a run calls it
};
struct Alarm {
  int number = 0;
};
struct Variable {
  std::string name;  ///< as --print takes it
  ExpectedValue value;
};
/// The machine coordinate of a work origin, shifts of all kinds together.
struct WorkOffset {
  std::string name;  ///< "G54"
  char axis = 'X';
  Within value;
};
/// All that the program printed, as UTF-8.
struct Output {
  std::string text;
};
struct OutputPart {
  std::string text;
};
/// What a file holds.
struct OutputFile {
  std::string path;
};
/// Measuring moves that had their signal.
struct Touches {
  std::size_t count = 0;
};
/// Warnings of the run.
struct Findings {
  std::size_t count = 0;
};
struct MachineTime {
  Range seconds;
};

using What = std::variant<Status, Alarm, Variable, WorkOffset, Output, OutputPart, OutputFile,
                          Touches, Findings, MachineTime>;

/// One thing that a run is to come to, and where somebody says so.
struct Expectation {
  What what;
  source::ShownPlace place;
};

/// What a run is expected to come to.  Where neither a status nor an alarm is named, it is to
/// complete.
struct Expectations {
  std::vector<Expectation> rows;
  std::vector<Characteristic> characteristics;

  /// Whether a status or an alarm is among them.
  [[nodiscard]] bool names_an_ending() const;
  /// Whether the printouts must be kept for them.
  [[nodiscard]] bool need_output() const;
  template <typename Kind>
  [[nodiscard]] bool has() const {
    for (const Expectation& row : rows) {
      if (std::holds_alternative<Kind>(row.what)) {
        return true;
      }
    }
    return false;
  }
};

/// What a run came to, as far as somebody may expect something of it.
struct Actual {
  std::string status;
  std::optional<int> alarm;
  /// The value of a variable; nullopt: it cannot be read.
  std::function<std::optional<runtime::ShownValue>(const std::string& name)> variable;
  /// The same of a characteristic; nullopt also: it is from before the run.
  std::function<std::optional<runtime::ShownValue>(const std::string& name)> result;
  /// mm or deg; nullopt: there is no such offset.
  std::function<std::optional<double>(const std::string& name, char axis)> work_offset;
  /// The content of a file; nullopt: it cannot be read.
  std::function<std::optional<std::string>(const std::string& path)> file;
  std::string output;  ///< as UTF-8; so is what a file holds
  std::size_t touches = 0;
  std::size_t findings = 0;
  double machine_time_s = 0.0;
};

/// An expectation that was looked at.
struct Judged {
  std::string name;      ///< of what: "#160", "work_offsets.G54.X", "status"
  std::string expected;  ///< in words for people
  std::string got;
  bool holds = false;
  source::ShownPlace place;
  std::string remedy = {};  ///< where it does not hold; "": what is expected may have to change
};

/// What the run came to of each characteristic, in their order.
std::vector<MeasuredCharacteristic> measured(const Expectations& expectations,
                                             const Actual& actual);

/// Looks at each, in their order, then at the characteristics that have limits; without a status or
/// an alarm among them first at the status.
std::vector<Judged> judge(const Expectations& expectations, const Actual& actual);

/// `NAME=VALUE+-TOLERANCE`, `NAME=VALUE` exactly, or `NAME=vacant`.
/// @returns why it is none of them
Result<Expectation, std::string> parse_expectation(const std::string& text);

}  // namespace g31::expect
