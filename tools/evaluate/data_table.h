#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"
#include "tools/evaluate/data_error.h"

namespace g31::evaluate {

/// What the values of a column are.
enum class ColumnKind : std::uint8_t { Number, Length, Text };

/// A column that an evaluation wants.
struct WantedColumn {
  std::string name;
  ColumnKind kind = ColumnKind::Number;
  std::string other_name = {};  ///< taken where there is no `name`; "": none
  bool is_optional = false;
  std::string_view otherwise = {};  ///< what to say where the file has no such column
};

/// How the columns of a file are to be taken.
struct ColumnRules {
  std::map<std::string, std::string> names = {};  ///< what the file calls a column; else its name
  double mm_per_unit = 1.0;                       ///< of lengths
};

/// The wanted columns of a table.
class DataTable {
 public:
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] bool has(std::string_view name) const;
  /// Values of a column of numbers or lengths (mm); empty where an optional one is missing.
  [[nodiscard]] const std::vector<double>& numbers(std::string_view name) const;
  /// One step of the last digit that any row of a column shows, as the column counts.
  [[nodiscard]] double resolution(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& texts(std::string_view name) const;
  /// The line of a row in the file, from 1.
  [[nodiscard]] std::size_t line(std::size_t row) const { return lines_[row]; }

 private:
  friend class TableReader;
  struct Column {
    std::string name;
    bool is_there = false;
    int decimals = 0;  // the most that a row shows
    double unit = 1.0;
    std::vector<double> numbers;
    std::vector<std::string> texts;
  };
  [[nodiscard]] const Column& column(std::string_view name) const;

  std::vector<Column> columns_;
  std::vector<std::size_t> lines_;
};

/// Largest size of a length in mm: an instrument's sentinel such as 1e38 is none.
inline constexpr double kLargestLength = 1e9;
/// Of another number: seconds since 1970 are one.
inline constexpr double kLargestNumber = 1e12;

/// Reads a table with a line of names first.
///
/// Lines end in LF or CR LF; a byte order mark, empty lines and lines that begin with # are passed
/// over.  What separates is the one of comma, semicolon and tab that stands between the names; with
/// one of the latter two, and in double quotes, a comma in a number is a decimal point.  Names and
/// values may stand in double quotes, where nothing separates, and among blanks.  Numbers are
/// finite, of sizes within these two.
Result<DataTable, DataError> read_table(const DataFile& file,
                                        const std::vector<WantedColumn>& wanted,
                                        const ColumnRules& rules);

}  // namespace g31::evaluate
