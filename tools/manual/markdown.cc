#include "tools/manual/markdown.h"

#include <ranges>

#include <fmt/format.h>

namespace g31::manual {
namespace {

std::string cells_row(std::ranges::forward_range auto&& cells) {
  std::string row = "|";
  for (const std::string_view cell : cells) {
    row += ' ';
    for (const char c : cell) {
      row += c == '|' ? "\\|" : std::string(1, c);
    }
    row += " |";
  }
  return row + "\n";
}

std::string cells_head(std::ranges::sized_range auto&& columns) {
  std::string rule = "|";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    rule += "---|";
  }
  return cells_row(columns) + rule + "\n";
}

}  // namespace

std::string page_head(std::string_view title, std::string_view name) {
  return fmt::format(
      "<!-- Made from the tables of g31: `g31 explain --page {} > docs/{}`.  A test compares. "
      "-->\n\n"
      "# {}\n\n",
      name, name, title);
}

std::string table_head(std::initializer_list<std::string_view> columns) {
  return cells_head(columns);
}

std::string table_head(std::span<const std::string> columns) {
  return cells_head(columns);
}

std::string table_row(std::initializer_list<std::string_view> cells) {
  return cells_row(cells);
}

std::string table_row(std::span<const std::string> cells) {
  return cells_row(cells);
}

std::string code(std::string_view text) {
  return text.empty() ? std::string() : fmt::format("`{}`", text);
}

}  // namespace g31::manual
