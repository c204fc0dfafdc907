#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// The keys of one table, each with the value to take when it is not given.
class TableKeys {
 public:
  explicit TableKeys(const SheetTable& table) : table_(table) {}

  [[nodiscard]] const Entry* find(KeyId id) const {
    const KeyRow& row = key_rows()[static_cast<std::size_t>(id)];
    const auto entry = table_.entries.find(std::string(row.name));
    return entry != table_.entries.end() ? &entry->second : nullptr;
  }

  /// `Value` is the alternative of SheetValue that the key's type becomes.
  template <typename Value>
  [[nodiscard]] Value get(KeyId id, const Value& otherwise) const {
    const Entry* entry = find(id);
    return entry != nullptr ? std::get<Value>(entry->value) : otherwise;
  }

 private:
  const SheetTable& table_;
};

/// The tables of a list; none where the sheet has no such list.
inline std::span<const SheetTable> list_of(const Sheet& sheet, SectionId section) {
  const auto list = sheet.lists.find(section);
  return list != sheet.lists.end() ? std::span<const SheetTable>(list->second)
                                   : std::span<const SheetTable>();
}

inline double number_of(const Entry& entry) {
  return std::get<double>(entry.value);
}

/// @pre a letter of X Y Z A B C
inline std::size_t index_of_axis(const std::string& letter) {
  const int index = axis_index(letter.front());
  G31_EXPECTS(index >= 0);
  return static_cast<std::size_t>(index);
}

/// Of a table whose keys are axis letters.
inline AxisPositions positions_from(const SheetTable& table) {
  AxisPositions q = AxisPositions::Zero();
  for (const auto& [letter, entry] : table.entries) {
    if (letter.size() != 1) {
      continue;  // rotate_deg and the like
    }
    q[static_cast<Eigen::Index>(index_of_axis(letter))] = number_of(entry);
  }
  return q;
}

/// Of a key of three numbers; without it the origin.
inline Point point_from(const TableKeys& keys, KeyId id) {
  const std::vector<double> list = keys.get(id, std::vector<double>{0.0, 0.0, 0.0});
  return {list.at(0), list.at(1), list.at(2)};
}

}  // namespace g31::setup
