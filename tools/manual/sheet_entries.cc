#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "tools/manual/entries.h"
#include "tools/setup/value_words.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;
using setup::KeyRow;
using setup::NameForm;
using setup::SectionForm;
using setup::SectionRow;

std::string with_unit(const KeyRow& row) {
  return row.unit.empty() ? std::string(row.text) : fmt::format("{} ({})", row.text, row.unit);
}

std::string how_often(const SectionRow& row) {
  switch (row.form) {
    case SectionForm::One:
      return "once";
    case SectionForm::Named:
      return fmt::format("once for each name: {}", setup::rule_of(row.name_form));
    case SectionForm::List:
      return "once for each of them, in their order";
  }
  return "";
}

Entry entry_of_section(const SectionRow& row) {
  Entry entry{"section of a set-up sheet", std::string(row.example), std::string(row.text), {}};
  entry.facts.push_back({"given", how_often(row)});
  for (const KeyRow& key : setup::key_rows()) {
    if (key.section == row.id) {
      entry.facts.push_back({std::string(key.name), with_unit(key)});
    }
  }
  for (const std::string_view inner : setup::inner_sections(row.id)) {
    const SectionRow* const section = setup::find_section(fmt::format("{}.{}", row.path, inner));
    entry.facts.push_back({std::string(section->example), std::string(section->text)});
  }
  return entry;
}

Entry entry_of_key(const KeyRow& row) {
  const SectionRow& section = setup::row_of(row.section);
  Entry entry{"key of a set-up sheet",
              fmt::format("{} {}", section.example, row.name),
              std::string(row.text),
              {{"value", value_words(row)}}};
  if (!row.unit.empty()) {
    entry.facts.push_back({"unit", std::string(row.unit)});
    if (const setup::UnitBounds* const bounds = setup::find_unit(row.unit)) {
      entry.facts.push_back({"at most", fmt::format("{:.15g} in size", bounds->most)});
    }
  }
  entry.facts.push_back({"without it", std::string(row.default_text)});
  entry.facts.push_back({"for example", std::string(row.example)});
  return entry;
}

/// What stands behind the section in a path: "axes.X.travel" behind "machine"; nullopt: another
/// section's.
std::optional<std::string_view> rest_behind(const SectionRow& section, std::string_view path) {
  if (!path.starts_with(section.path)) {
    return std::nullopt;
  }
  path.remove_prefix(section.path.size());
  if (path.empty()) {
    return path;
  }
  if (path.front() != '.') {
    return std::nullopt;
  }
  path.remove_prefix(1);
  const std::string_view name = path.substr(0, path.find('.'));
  if (section.form == SectionForm::Named && setup::normal_name(section.name_form, name)) {
    path.remove_prefix(std::min(name.size() + 1, path.size()));
  }
  return path;
}

/// Of a path with a point in it, or one that is a section.
Entries entries_of_path(std::string_view path) {
  Entries found;
  for (const SectionRow& section : setup::section_rows()) {
    const auto rest = rest_behind(section, path);
    if (!rest) {
      continue;
    }
    if (rest->empty()) {
      found.push_back(entry_of_section(section));
      continue;
    }
    const auto key = setup::find_key(section.id, *rest);
    if (key && key->row->name_form != NameForm::SizeName) {
      found.push_back(entry_of_key(*key->row));
    }
  }
  return found;
}

/// Without brackets, quotes and blanks.
std::string bare(std::string_view topic) {
  std::string path(topic);
  std::erase_if(path, [](char c) { return c == '[' || c == ']' || c == '"' || c == ' '; });
  return path;
}

}  // namespace

std::string value_words(const KeyRow& row) {
  const std::string_view type = setup::words_for(row.type);
  const std::string_view limit = setup::words_for(row.limit);
  if (limit.empty()) {
    return std::string(type);
  }
  return limit.starts_with(type) ? std::string(limit) : fmt::format("{}: {}", type, limit);
}

Entries sheet_entries(std::string_view topic) {
  const std::string path = bare(topic);
  Entries found = entries_of_path(path);
  for (const KeyRow& row : setup::key_rows()) {
    if (row.name_form == NameForm::Exact && row.name == path) {
      found.push_back(entry_of_key(row));
    }
  }
  return found;
}

Entries all_sheet_entries() {
  Entries all;
  for (const SectionRow& section : setup::section_rows()) {
    all.push_back(entry_of_section(section));
    for (const KeyRow& key : setup::key_rows()) {
      if (key.section == section.id) {
        all.push_back(entry_of_key(key));
      }
    }
  }
  return all;
}

}  // namespace g31::manual
