#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "machine/port/work_watch.h"
#include "tools/setup/setup_error.h"

namespace g31::evaluate {

/// Rows of data_errors.def.
enum class DataErrorId {
#define DATA_ERROR(name, code, text) name,
#include "tools/evaluate/data_errors.def"
#undef DATA_ERROR
};

struct DataErrorRow {
  std::string_view code;
  std::string_view text;  ///< fmt format
};

/// All rows of data_errors.def.
std::span<const DataErrorRow> data_error_rows();

/// What is wrong with a file, shown as the errors of set-up sheets are.
using DataError = setup::SetupError;

/// A file that is evaluated.
struct DataFile {
  std::string name;                     ///< as the command line has it
  std::string_view text;                ///< all of it
  machine::WorkWatch* watch = nullptr;  ///< looked at for each row; may end the work

  /// In each step of long work on what it holds.
  void look() const {
    if (watch != nullptr) {
      watch->look();
    }
  }
};

/// A place in a text.
struct DataPlace {
  std::size_t line = 0;    ///< from 1; 0: the whole file
  std::size_t offset = 0;  ///< of a byte of that line, from the beginning of the text
};

/// What ends the lines of a text: a line feed, or a carriage return where there is none.
char line_end_of(std::string_view text);

/// An error of row `id`; `details` fill the {} of the row, one each.  What a file put into them is
/// cut and made printable.
DataError data_error(DataErrorId id, const DataFile& file, DataPlace place,
                     std::initializer_list<std::string_view> details, std::string remedy = {});

/// The place of a line, counted from 1.
DataPlace place_of_line(const DataFile& file, std::size_t line);

}  // namespace g31::evaluate
