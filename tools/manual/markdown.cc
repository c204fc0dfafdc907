#include "tools/manual/markdown.h"

#include <fmt/format.h>

namespace g31::manual {

std::string page_head(std::string_view title, std::string_view name) {
  return fmt::format(
      "<!-- Made from the tables of g31: `g31 explain --page {} > docs/{}`.  A test compares. "
      "-->\n\n"
      "# {}\n\n",
      name, name, title);
}

std::string table_head(std::initializer_list<std::string_view> columns) {
  std::string rule = "|";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    rule += "---|";
  }
  return table_row(columns) + rule + "\n";
}

std::string table_row(std::initializer_list<std::string_view> cells) {
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

std::string code(std::string_view text) {
  return text.empty() ? std::string() : fmt::format("`{}`", text);
}

}  // namespace g31::manual
