#include "tools/setup/check_sheet.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/nearest_name.h"
#include "machine/units/axis_positions.h"
#include "parts/artefacts/artefact.h"
#include "tools/setup/check_value.h"
#include "tools/setup/keys.h"
#include "tools/setup/lost_variables.h"

namespace g31::setup {
namespace {

using Names = std::vector<std::string_view>;

/// A key as TOML wants it written.
std::string written(std::string_view key) {
  const bool bare = !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '_' || c == '-');
  });
  return bare ? std::string(key) : fmt::format("\"{}\"", key);
}

std::string resolved(const Document& document, const std::string& path) {
  return (std::filesystem::path(document.path).parent_path() / path).string();
}

std::string joined(const Names& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

const Node* find_member(const Table& table, std::string_view key) {
  const auto member = std::ranges::find(table, key, &Member::key);
  return member != table.end() ? &member->node : nullptr;
}

/// The rows of a section in words: its keys, and the rules of its free names.
Names names_in_words(SectionId section) {
  Names names;
  for (const KeyRow& row : key_rows()) {
    if (row.section == section && row.name_form != NameForm::SizeName) {
      names.push_back(row.name);
    }
  }
  const Names inner = inner_sections(section);
  names.insert(names.end(), inner.begin(), inner.end());
  return names;
}

/// The sizes that the shape of a part has: none without a shape, nullopt for an unknown shape.
std::optional<Names> sizes_of_shape(const Table& part) {
  const Node* shape = find_member(part, "shape");
  if (shape == nullptr) {
    return Names();
  }
  const auto* name = std::get_if<std::string>(&shape->value);
  const auto is_it = [&](const parts::Shape& row) { return name != nullptr && row.name == *name; };
  if (std::ranges::none_of(parts::shapes(), is_it)) {
    return std::nullopt;
  }
  Names sizes;
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    if (size.shape == *name) {
      sizes.push_back(size.name);
    }
  }
  return sizes;
}

/// Walks one document; every function adds what it finds to sheet_ or to errors_.
class SheetCheck {
 public:
  SheetCheck(const Document& document, ErrorList& errors) : document_(document), errors_(errors) {}

  void check_root();
  void check_root_of_machine_file();
  [[nodiscard]] const Sheet& sheet() const { return sheet_; }

 private:
  /// The table being checked: its section, how errors name it and what they call its header.
  struct Scope {
    SectionId section;
    std::string path;
    std::string header;
    std::optional<Names> sizes;  ///< of a part's shape; nullopt when the shape is not known
  };

  [[nodiscard]] Location at_key(const Member& m) const { return {&document_, m.line, m.column}; }
  [[nodiscard]] Location at(const Node& n) const { return {&document_, n.line, n.column}; }

  void unknown_key(const Member& member, std::string_view header, const Names& known,
                   std::string_view in_words);
  void refused(const Node& node, std::string_view path, const ValueProblem& problem,
               std::string_view example);
  const Table* table_or_error(const Node& node, std::string_view path, std::string_view example);

  void check_section(const SectionRow& row, const Member& member);
  void check_named(const SectionRow& row, const Member& member);
  void check_list(const SectionRow& row, const Member& member);
  void check_members(const Table& members, const Scope& scope, SheetTable& into);
  void check_key(const Member& member, const Scope& scope, SheetTable& into);
  void check_part(const Table& members, const Location& where);
  void check_shape(const Node& shape);
  void check_skip_signal(const Table& members, const Location& where);

  const Document& document_;
  ErrorList& errors_;
  std::size_t outer_element_ = 0;  ///< of the list being checked that may have lists within
  Sheet sheet_;
};

void SheetCheck::unknown_key(const Member& member, std::string_view header, const Names& known,
                             std::string_view in_words) {
  const auto nearest = nearest_name(member.key, known);
  const std::string advice = nearest ? fmt::format("did you mean {}?", written(*nearest))
                                     : fmt::format("which takes {}", in_words);
  errors_.add(SetupErrorId::UnknownKey, at_key(member), {written(member.key), header, advice});
}

void SheetCheck::refused(const Node& node, std::string_view path, const ValueProblem& problem,
                         std::string_view example) {
  const std::string remedy =
      problem.id == SetupErrorId::WrongType ? fmt::format("for example: {}", example) : "";
  errors_.add(problem.id, at(node), {path, problem.is, problem.should_be}, remedy);
}

const Table* SheetCheck::table_or_error(const Node& node, std::string_view path,
                                        std::string_view example) {
  const auto* table = std::get_if<Table>(&node.value);
  if (table == nullptr) {
    refused(node, path, {SetupErrorId::WrongType, kind_of(node), "a table"}, example);
  }
  return table;
}

void SheetCheck::check_root() {
  Names known;
  for (const SectionRow& row : section_rows()) {
    if (row.path.find('.') == std::string_view::npos) {
      known.push_back(row.path);
    }
  }
  for (const Member& member : document_.root) {
    if (std::ranges::find(known, member.key) != known.end()) {
      check_section(*find_section(member.key), member);
    } else {
      unknown_key(member, "the sheet", known, joined(known));
    }
  }
}

void SheetCheck::check_root_of_machine_file() {
  const SectionRow& row = row_of(SectionId::Machine);
  if (find_member(document_.root, row.path) == nullptr) {
    const Location start{&document_, 1, 1};
    SheetTable& table = sheet_.tables[{row.id, ""}];
    table.where = start;
    check_members(document_.root, {row.id, std::string(row.path), "the machine file", {}}, table);
    return;
  }
  for (const Member& member : document_.root) {
    if (member.key == row.path) {
      check_section(row, member);
    } else {
      unknown_key(member, "the machine file", Names{row.path}, row.example);
    }
  }
}

void SheetCheck::check_section(const SectionRow& row, const Member& member) {
  switch (row.form) {
    case SectionForm::One:
      if (const Table* members = table_or_error(member.node, row.path, row.example)) {
        SheetTable& table = sheet_.tables[{row.id, ""}];
        table.where = at_key(member);
        check_members(*members, {row.id, std::string(row.path), std::string(row.example), {}},
                      table);
      }
      return;
    case SectionForm::Named:
      check_named(row, member);
      return;
    case SectionForm::List:
      check_list(row, member);
      return;
  }
}

void SheetCheck::check_named(const SectionRow& row, const Member& member) {
  const Table* tables = table_or_error(member.node, row.path, row.example);
  if (tables == nullptr) {
    return;
  }
  for (const Member& named : *tables) {
    const std::optional<std::string> name = normal_name(row.name_form, named.key);
    const std::string path = fmt::format("{}.{}", row.path, written(named.key));
    if (!name) {
      unknown_key(named, fmt::format("[{}]", row.path), known_names(row.name_form),
                  rule_of(row.name_form));
      continue;
    }
    const Table* members = table_or_error(named.node, path, row.example);
    if (members == nullptr) {
      continue;
    }
    if (sheet_.tables.contains({row.id, *name})) {
      errors_.add(SetupErrorId::GivenTwice, at_key(named),
                  {fmt::format("{}.{}", row.path, written(*name))});
      continue;
    }
    SheetTable& table = sheet_.tables[{row.id, *name}];
    table.where = at_key(named);
    check_members(*members, {row.id, path, fmt::format("[{}]", path), {}}, table);
  }
}

void SheetCheck::check_list(const SectionRow& row, const Member& member) {
  const auto* array = std::get_if<Array>(&member.node.value);
  if (array == nullptr) {
    refused(member.node, row.path,
            {SetupErrorId::WrongType, kind_of(member.node), "an array of tables"}, row.example);
    return;
  }
  std::vector<SheetTable>& list = sheet_.lists[row.id];
  for (const std::string_view inner : inner_sections(row.id)) {
    sheet_.lists[find_section(fmt::format("{}.{}", row.path, inner))->id];
  }
  for (const Node& element : *array) {
    const Table* members = table_or_error(element, row.path, row.example);
    if (members == nullptr) {
      continue;
    }
    Scope scope{row.id, std::string(row.path), std::string(row.example), {}};
    if (row.id == SectionId::Part) {
      scope.sizes = sizes_of_shape(*members);
      check_part(*members, at(element));
    } else if (row.id == SectionId::SkipSignal) {
      check_skip_signal(*members, at(element));
    }
    SheetTable table;
    table.where = at(element);
    table.of = outer_element_;
    const bool is_inner = row.path.find('.') != std::string_view::npos;
    outer_element_ = is_inner ? outer_element_ : list.size();
    check_members(*members, scope, table);
    list.push_back(std::move(table));
  }
}

void SheetCheck::check_members(const Table& members, const Scope& scope, SheetTable& into) {
  for (const Member& member : members) {
    const SectionRow* inner = find_section(fmt::format("{}.{}", scope.path, member.key));
    if (inner != nullptr) {
      check_section(*inner, member);
    } else {
      check_key(member, scope, into);
    }
  }
}

void SheetCheck::check_key(const Member& member, const Scope& scope, SheetTable& into) {
  const std::optional<FoundKey> found = find_key(scope.section, member.key);
  const bool is_size = found && found->row->name_form == NameForm::SizeName;
  if (is_size && !scope.sizes) {
    return;  // the unknown shape is the error; what it would take cannot be said
  }
  const Names sizes = scope.sizes.value_or(Names());
  const bool has_size = std::ranges::find(sizes, member.key) != sizes.end();
  if (!found || (is_size && !has_size)) {
    Names known = known_keys(scope.section);
    Names words = names_in_words(scope.section);
    known.insert(known.end(), sizes.begin(), sizes.end());
    words.insert(words.end(), sizes.begin(), sizes.end());
    unknown_key(member, scope.header, known, joined(words));
    return;
  }

  const KeyRow& row = *found->row;
  const std::size_t dot = found->name.find('.');
  const bool is_bit = row.name_form == NameForm::ParameterNumber && dot != std::string::npos &&
                      axis_index(found->name.at(dot + 1)) < 0;
  const std::string path = fmt::format("{}.{}", scope.path, written(member.key));
  const auto checked =
      checked_value(member.node, row.type, is_bit ? Limit::Bit : row.limit, row.unit);
  if (!checked) {
    refused(member.node, path, checked.error(), row.example);
    into.is_whole = false;
    return;
  }
  SheetValue value = checked.value();
  if (row.type == ValueType::Path) {
    value = resolved(document_, std::get<std::string>(value));
  }
  if (!into.entries.emplace(found->name, Entry{value, at(member.node)}).second) {
    errors_.add(SetupErrorId::GivenTwice, at_key(member), {path});
  }
}

void SheetCheck::check_part(const Table& members, const Location& where) {
  const Node* file = find_member(members, "file");
  const Node* shape = find_member(members, "shape");
  if ((file == nullptr) == (shape == nullptr)) {
    errors_.add(SetupErrorId::PartWithoutBody, where, {file == nullptr ? "none" : "both"},
                "for example: file = \"ring.stl\"");
  }
  if (shape != nullptr) {
    for (const char* const key : {"unit", "scale", "closed"}) {
      if (const Node* const given = find_member(members, key); given != nullptr) {
        errors_.add(SetupErrorId::KeyOfFile, at(*given), {key}, "leave it out");
      }
    }
    check_shape(*shape);
  }
}

void SheetCheck::check_shape(const Node& shape) {
  const auto* name = std::get_if<std::string>(&shape.value);
  Names known;
  for (const parts::Shape& row : parts::shapes()) {
    known.push_back(row.name);
  }
  if (name != nullptr && !name->empty() && std::ranges::find(known, *name) == known.end()) {
    errors_.add(SetupErrorId::OutOfRange, at(shape),
                {"part.shape", fmt::format("\"{}\"", *name),
                 fmt::format("\"{}\"", fmt::join(known, "\" or \""))});
  }
}

void SheetCheck::check_skip_signal(const Table& members, const Location& where) {
  if (find_member(members, "at") != nullptr && find_member(members, "axis") == nullptr) {
    errors_.add(SetupErrorId::SignalWithoutAxis, where, {}, "for example: axis = \"X\"");
  }
}

}  // namespace

Sheet check_sheet(const Document& document, ErrorList& errors) {
  SheetCheck check(document, errors);
  check.check_root();
  Sheet sheet = check.sheet();
  sheet.lost_variables = lost_variables_in(document);
  return sheet;
}

Sheet check_machine_file(const Document& document, ErrorList& errors) {
  SheetCheck check(document, errors);
  check.check_root_of_machine_file();
  return check.sheet();
}

}  // namespace g31::setup
