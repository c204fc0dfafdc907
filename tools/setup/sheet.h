#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/setup/check_value.h"
#include "tools/setup/document.h"
#include "tools/setup/keys.h"
#include "tools/setup/variable_name.h"

namespace g31::setup {

/// One key that passed its checks.
struct Entry {
  SheetValue value;  ///< of the type of its row; paths are resolved against the sheet's folder
  Location where;    ///< of the value
};

/// One table of a sheet: its checked keys by name.
struct SheetTable {
  Location where;
  std::map<std::string, Entry, InAnyCase> entries;
  /// Of a list within the elements of a list ([[tool.body]]): the element that it is in, from 0.
  std::size_t of = 0;
  bool is_whole = true;  ///< no value of it was refused
};

/// The checked keys of one sheet, or of several laid over each other.
struct Sheet {
  /// By section and, for named sections, NAME; a table without keys is here too.
  std::map<std::pair<SectionId, std::string>, SheetTable> tables;
  /// The elements of [[part]] and the like; a list that is given without elements is here, and one
  /// within the elements of another that is given.
  std::map<SectionId, std::vector<SheetTable>> lists;
  /// Comments that look like variables, `#500 = 3.0`.
  std::vector<Location> lost_variables;

  /// The entry of an exact key of a section that has no NAME, or nullptr.
  [[nodiscard]] const Entry* find(KeyId id) const;
};

/// Takes the keys of `above` where both have one; lists are replaced as a whole.
void lay_over(Sheet& below, const Sheet& above);

}  // namespace g31::setup
