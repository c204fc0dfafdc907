#include "tools/setup/varied_key.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/nearest_name.h"
#include "machine/units/axis_positions.h"
#include "parts/artefacts/artefact.h"
#include "probe/tooling/tool_probe_setup.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

using Names = std::vector<std::string_view>;

/// "; did you mean X?", or the list of what there is.
std::string advice(std::string_view unknown, const Names& known) {
  if (const auto nearest = nearest_name(unknown, known)) {
    return fmt::format(", did you mean {}?", *nearest);
  }
  return known.empty() ? ", nor any other" : fmt::format(", known are {}", fmt::join(known, ", "));
}

/// The section with the longest path that `path` begins with.
const SectionRow* section_of(std::string_view path) {
  const SectionRow* longest = nullptr;
  for (const SectionRow& row : section_rows()) {
    const bool begins =
        path.starts_with(row.path) && path.size() > row.path.size() && path[row.path.size()] == '.';
    if (begins && (longest == nullptr || row.path.size() > longest->path.size())) {
      longest = &row;
    }
  }
  return longest;
}

/// "at.X" is component 0 of "at"; of a key without components nothing.
std::optional<std::size_t> component_in(std::string_view rest) {
  const bool ends = rest.size() > 2 && rest[rest.size() - 2] == '.';
  const int axis = ends ? axis_index(rest.back()) : -1;
  return is_linear_axis(axis) ? std::optional(static_cast<std::size_t>(axis)) : std::nullopt;
}

bool has_components(const KeyRow& row) {
  return row.limit == Limit::Any &&
         (row.type == ValueType::TwoNumbers || row.type == ValueType::ThreeNumbers);
}

/// Finds the key that `rest` names at its end.  @returns how many characters it takes there
std::optional<std::size_t> find_at_end(VariedKey& found, std::string_view rest, bool whole) {
  const auto try_key = [&](std::string_view text) -> std::optional<std::size_t> {
    const std::size_t dot = whole ? std::string_view::npos : text.rfind('.');
    const std::string_view key = dot == std::string_view::npos ? text : text.substr(dot + 1);
    const auto row = find_key(found.section, key);
    if (!row) {
      return std::nullopt;
    }
    found.row = row->row;
    found.key = row->name;
    return key.size();
  };
  if (const auto component = component_in(rest)) {
    const auto taken = try_key(rest.substr(0, rest.size() - 2));
    if (taken && has_components(*found.row)) {
      found.component = component;
      return *taken + 2;
    }
  }
  return try_key(rest);
}

/// The name of a part as reports call it.
std::string name_of_part(const SheetTable& table) {
  const TableKeys keys(table);
  const std::string shape = keys.get(KeyId::PartShape, std::string());
  const std::string file = keys.get(KeyId::PartFile, std::string());
  return keys.get(KeyId::PartName,
                  shape.empty() ? std::filesystem::path(file).stem().string() : shape);
}

/// What tells the elements of a list apart: the number of a tool, the name of the others.
std::string name_in_list(SectionId section, const SheetTable& table) {
  const TableKeys keys(table);
  if (section == SectionId::Tool) {
    const Entry* const number = keys.find(KeyId::ToolWhich);
    return number != nullptr ? fmt::format("{}", number_of(*number)) : "";
  }
  return section == SectionId::ToolProbe
             ? keys.get(KeyId::ToolProbeName, probe::ToolProbeSetup().name)
             : name_of_part(table);
}

bool has_names(const SectionRow& section) {
  return section.form != SectionForm::List || section.id == SectionId::Part ||
         section.id == SectionId::Tool || section.id == SectionId::ToolProbe;
}

std::optional<std::string> why_no_size(const SheetTable& part, const VariedKey& key) {
  const std::string shape = TableKeys(part).get(KeyId::PartShape, std::string());
  Names sizes;
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    if (size.shape == shape) {
      sizes.push_back(size.name);
    }
  }
  if (std::ranges::find(sizes, key.key) != sizes.end()) {
    return std::nullopt;
  }
  return shape.empty()
             ? fmt::format("a part from a file has no size {}", key.key)
             : fmt::format("shape {} has no size {}{}", shape, key.key, advice(key.key, sizes));
}

/// The numbers that a key has where a sheet does not give it; nullopt: other keys decide.
std::optional<std::vector<double>> default_list(const KeyRow& row) {
  const auto line = parse_document("", fmt::format("it = {}", row.default_text), 0);
  if (!line) {
    return std::nullopt;  // words
  }
  const auto value = checked_value(line.value()->root.front().node, row.type, row.limit, row.unit);
  return value ? std::optional(std::get<std::vector<double>>(value.value())) : std::nullopt;
}

/// The list of a key with one of its numbers changed; else why there is none.
Result<std::vector<double>, std::string> with_component(const SheetTable& table,
                                                        const VariedKey& key, double number) {
  const auto old = table.entries.find(key.key);
  const auto given = old != table.entries.end()
                         ? std::optional(std::get<std::vector<double>>(old->second.value))
                         : default_list(*key.row);
  if (!given) {
    return fmt::format("the sheet has no {0} ({1}): write {0} into it, whose other numbers stay",
                       key.key, key.row->default_text);
  }
  std::vector<double> list = *given;
  list.at(*key.component) = number;
  Node node;
  node.value = Array();
  for (const double each : list) {
    std::get<Array>(node.value).push_back({1, 1, each});
  }
  const auto checked = checked_value(node, key.row->type, key.row->limit, key.row->unit);
  if (!checked) {
    return fmt::format("{} is {}, it should be {}", key.key, checked.error().is,
                       checked.error().should_be);
  }
  return list;
}

/// @returns why it cannot
std::optional<std::string> put(SheetTable& table, const VariedKey& key, const Entry& entry) {
  if (!key.component) {
    table.entries.insert_or_assign(key.key, entry);
    return std::nullopt;
  }
  const auto list = with_component(table, key, number_of(entry));
  if (!list) {
    return list.error();
  }
  table.entries.insert_or_assign(key.key, Entry{list.value(), entry.where});
  return std::nullopt;
}

}  // namespace

Result<VariedKey, std::string> find_varied_key(std::string_view path) {
  VariedKey found;
  found.path = path;
  const SectionRow* const section = section_of(path);
  if (section == nullptr) {
    Names known;
    for (const SectionRow& row : section_rows()) {
      known.push_back(row.path);
    }
    return fmt::format("no section of a set-up sheet begins like this{}",
                       advice(path.substr(0, path.find('.')), known));
  }
  found.section = section->id;
  const std::string_view rest = path.substr(section->path.size() + 1);
  if (!has_names(*section)) {
    return fmt::format(
        "of lists only part.NAME, tool.NUMBER and tool_probe.NAME can be varied, not those of "
        "[[{}]]",
        section->path);
  }
  const auto taken = find_at_end(found, rest, section->form == SectionForm::One);
  if (!taken) {
    const std::string_view last = rest.substr(rest.rfind('.') + 1);
    return fmt::format("{} has no key {}{}", section->path, last,
                       advice(last, known_keys(section->id)));
  }
  if (section->form == SectionForm::One) {
    if (found.row->type == ValueType::TwoNumbers && found.component.value_or(0) > 1) {
      return fmt::format("{} has no Z", found.key);
    }
    return found;
  }
  if (rest.size() <= *taken + 1) {
    return fmt::format("it takes a name: {}.NAME.{}", section->path, found.key);
  }
  const std::string_view name = rest.substr(0, rest.size() - *taken - 1);
  const auto normal = section->form == SectionForm::Named ? normal_name(section->name_form, name)
                                                          : std::optional(std::string(name));
  if (!normal) {
    return fmt::format("{} is not a name in [{}]{}", name, section->path,
                       advice(name, known_names(section->name_form)));
  }
  found.name = *normal;
  return found;
}

Result<SheetValue, ValueProblem> value_for(const VariedKey& key, const Node& node) {
  const std::size_t dot = key.key.find('.');
  const bool is_bit = key.row->name_form == NameForm::ParameterNumber && dot != std::string::npos &&
                      axis_index(key.key.at(dot + 1)) < 0;
  return key.component ? checked_value(node, ValueType::Number, Limit::Any, key.row->unit)
                       : checked_value(node, key.row->type, is_bit ? Limit::Bit : key.row->limit,
                                       key.row->unit);
}

bool takes_any_number(const VariedKey& key) {
  constexpr auto kNumbers =
      std::to_array({ValueType::Number, ValueType::NumberOrFlag, ValueType::NumberOrVacant});
  return key.component || std::ranges::find(kNumbers, key.row->type) != kNumbers.end();
}

std::optional<std::string> lay_value(Sheet& sheet, const VariedKey& key, const Entry& entry) {
  if (row_of(key.section).form != SectionForm::List) {
    SheetTable& table = sheet.tables[{key.section, key.name}];
    if (table.where.document == nullptr) {  // the sheet has none
      table.where = entry.where;
    }
    return put(table, key, entry);
  }
  std::vector<SheetTable>& list = sheet.lists[key.section];
  std::vector<std::string> names;
  for (const SheetTable& table : list) {
    names.push_back(name_in_list(key.section, table));
  }
  const auto found = std::ranges::find(names, key.name);
  if (found == names.end()) {
    return fmt::format("there is no {} {}{}", row_of(key.section).path, key.name,
                       advice(key.name, Names(names.begin(), names.end())));
  }
  const auto part = list.begin() + (found - names.begin());
  if (key.row->name_form == NameForm::SizeName) {
    if (auto wrong = why_no_size(*part, key)) {
      return wrong;
    }
  }
  return put(*part, key, entry);
}

}  // namespace g31::setup
