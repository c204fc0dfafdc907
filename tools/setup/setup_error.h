#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/source/source_map.h"
#include "tools/setup/document.h"

namespace g31::setup {

/// Rows of setup_errors.def.
enum class SetupErrorId {
#define SETUP_ERROR(name, code, text, about) name,
#include "tools/setup/setup_errors.def"
#undef SETUP_ERROR
};

struct SetupErrorRow {
  std::string_view code;
  std::string_view text;   ///< fmt format
  std::string_view about;  ///< what to look at
};

/// All rows of setup_errors.def.
std::span<const SetupErrorRow> setup_error_rows();

/// A place in a set-up sheet, for messages about what is found out only later.
source::ShownPlace place_of(const Location& where);

/// One thing that is wrong with a set-up sheet: data, ready to be shown.
struct SetupError {
  std::string file;         ///< as the command line or the sheet names it
  int line = 0;             ///< from 1; 0 when the error is about the whole file
  int column = 0;           ///< from 1, in characters
  std::string message;      ///< one line, no final full stop
  std::string code;         ///< "SET103"
  std::string source_line;  ///< the text of `line`
  std::string remedy;       ///< what would be right; may be empty
};

using SetupErrors = std::vector<SetupError>;

/// The compiler-style form: `file:line:column: error: text [CODE]`, the line, a caret under it,
/// and the remedy.  Ends with a line break.  Long lines are cut around the caret; control
/// characters and bytes that are not UTF-8 show as `?`.
std::string render(const SetupError& error);

/// The errors of several documents while they are read, given back in the order of the files.
class ErrorList {
 public:
  /// An error of row `id` at a place; `details` fill the {} of the row, one each.
  void add(SetupErrorId id, const Location& where, std::initializer_list<std::string_view> details,
           std::string remedy = {});

  /// An error that is already complete, of the document read as number `order`.
  void add(std::size_t order, SetupError error);

  [[nodiscard]] bool empty() const { return items_.empty(); }

  /// All errors: documents in the order they were read, inside each by line and column.
  [[nodiscard]] SetupErrors in_file_order() const;

 private:
  struct Item {
    std::size_t order = 0;
    SetupError error;
  };
  std::vector<Item> items_;
};

/// The text of row `id` with its {} filled.
std::string message_of(SetupErrorId id, std::initializer_list<std::string_view> details);

/// An error of row `id` at a place.
SetupError error_at(source::ShownPlace place, SetupErrorId id,
                    std::initializer_list<std::string_view> details, std::string remedy = {});

/// "SET101" and so on.
std::string_view code_of(SetupErrorId id);

}  // namespace g31::setup
