#include "tools/setup/document.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <toml++/toml.h>

#include "tools/disk/disk.h"
#include "tools/setup/setup_error.h"

namespace g31::setup {
namespace {

/// Deeper than any sheet; the TOML library has no limit for dotted keys and would recurse until
/// the stack is gone.
constexpr int kMostDotsInAKey = 32;
constexpr int kDeepestNode = 64;

SetupError error_at(const Document& document, SetupErrorId id, const Location& where,
                    std::string_view detail) {
  return {document.path,
          where.line,
          where.column,
          message_of(id, {detail}),
          std::string(code_of(id)),
          std::string(document.line(where.line)),
          {}};
}

/// The bytes of a file, or the reason why not.
struct FileText {
  std::string text;
  std::string reason;  ///< "" when it could be read
};

FileText read_file(const std::string& path) {
  constexpr const char* kTooLarge = "it is larger than 16 MiB";
  disk::Disk disk;
  if (disk.size(path).value_or(0) > kLargestSheetBytes) {
    return {{}, kTooLarge};
  }
  auto text = disk.read(path);
  if (!text) {
    return {{}, disk::why_unreadable(path)};
  }
  if (text->size() > kLargestSheetBytes) {
    return {{}, kTooLarge};
  }
  if (text->starts_with("\xFF\xFE") || text->starts_with("\xFE\xFF")) {
    return {{}, "it is UTF-16 text, two bytes a character; save it as UTF-8"};
  }
  return {*std::move(text), {}};
}

/// The first key with more than kMostDotsInAKey dots; document == nullptr when there is none.
/// Counts the dots between two of `= , [ ] { }` outside of quotes, which no value has so many of.
Location too_deep_key(const Document& document) {
  Location here{&document, 1, 0};
  int dots = 0;
  bool quoted = false;
  bool comment = false;
  for (const char c : document.text) {
    ++here.column;
    if (c == '\n') {
      here = {&document, here.line + 1, 0};
      dots = 0;
      quoted = comment = false;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == '#' && !quoted) {
      comment = true;
    } else if (std::string_view("=,[]{}").find(c) != std::string_view::npos) {
      dots = 0;
    } else if (c == '.' && !quoted && !comment && ++dots > kMostDotsInAKey) {
      return here;
    }
  }
  return {};
}

Node node_from(const toml::node& source, int depth);

int line_of(const toml::source_region& region) {
  return std::max(static_cast<int>(region.begin.line), 1);
}

int column_of(const toml::source_region& region) {
  return std::max(static_cast<int>(region.begin.column), 1);
}

Table table_from(const toml::table& source, int depth) {
  Table table;
  for (const auto& [key, value] : source) {
    table.push_back({std::string(key.str()), line_of(key.source()), column_of(key.source()),
                     node_from(value, depth + 1)});
  }
  // The library sorts by name; a reader of errors goes through the file.
  std::ranges::stable_sort(table, {}, [](const Member& m) { return std::pair(m.line, m.column); });
  return table;
}

Array array_from(const toml::array& source, int depth) {
  Array array;
  for (const toml::node& element : source) {
    array.push_back(node_from(element, depth + 1));
  }
  return array;
}

Node node_from(const toml::node& source, int depth) {
  Node node{line_of(source.source()), column_of(source.source()), DateOrTime{}};
  source.visit([&](const auto& typed) {
    using Typed = std::remove_cvref_t<decltype(typed)>;
    if constexpr (std::is_same_v<Typed, toml::table>) {
      node.value = depth < kDeepestNode ? table_from(typed, depth) : Table{};
    } else if constexpr (std::is_same_v<Typed, toml::array>) {
      node.value = depth < kDeepestNode ? array_from(typed, depth) : Array{};
    } else if constexpr (toml::is_boolean<Typed> || toml::is_integer<Typed> ||
                         toml::is_floating_point<Typed> || toml::is_string<Typed>) {
      node.value = typed.get();
    }
  });
  return node;
}

}  // namespace

std::string_view Document::line(int number) const {
  const auto begin = lines.begin_of(number);
  if (!begin) {
    return {};
  }
  std::string_view rest = std::string_view(text).substr(*begin);
  rest = rest.substr(0, rest.find('\n'));
  if (rest.ends_with('\r')) {
    rest.remove_suffix(1);
  }
  return rest;
}

Result<std::shared_ptr<const Document>, SetupError> read_document(const std::string& path,
                                                                  std::size_t order) {
  FileText file = read_file(path);
  if (!file.reason.empty()) {
    const Document unread{path, order};
    return error_at(unread, SetupErrorId::CannotRead, {}, file.reason);
  }
  return parse_document(path, std::move(file.text), order);
}

Result<std::shared_ptr<const Document>, SetupError> parse_document(std::string path,
                                                                   std::string text,
                                                                   std::size_t order) {
  const auto document = std::make_shared<Document>();
  *document = {std::move(path), order, std::move(text)};
  document->lines = source::LineStarts(document->text);
  if (const Location deep = too_deep_key(*document); deep.document != nullptr) {
    return error_at(*document, SetupErrorId::Syntax, deep, "a key of more than 32 parts");
  }
  try {
    document->root = table_from(toml::parse(document->text, document->path), 0);
  } catch (const toml::parse_error& error) {
    const Location where{document.get(), line_of(error.source()), column_of(error.source())};
    return error_at(*document, SetupErrorId::Syntax, where, error.description());
  }
  return std::shared_ptr<const Document>(document);
}

}  // namespace g31::setup
