#include "tools/setup/sheet.h"

namespace g31::setup {

const Entry* Sheet::find(KeyId id) const {
  const KeyRow& row = key_rows()[static_cast<std::size_t>(id)];
  const auto table = tables.find({row.section, ""});
  if (table == tables.end()) {
    return nullptr;
  }
  const auto entry = table->second.entries.find(std::string(row.name));
  return entry != table->second.entries.end() ? &entry->second : nullptr;
}

void lay_over(Sheet& below, const Sheet& above) {
  for (const auto& [name, table] : above.tables) {
    SheetTable& target = below.tables[name];
    target.where = table.where;
    for (const auto& [key, entry] : table.entries) {
      target.entries.insert_or_assign(key, entry);
    }
  }
  for (const auto& [section, list] : above.lists) {
    below.lists.insert_or_assign(section, list);
  }
  below.lost_variables.insert(below.lost_variables.end(), above.lost_variables.begin(),
                              above.lost_variables.end());
}

}  // namespace g31::setup
