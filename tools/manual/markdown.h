#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace g31::manual {

/// The head of a page that is made: its title, and how to make it again.
std::string page_head(std::string_view title, std::string_view name);

/// The first two lines of a table.
std::string table_head(std::initializer_list<std::string_view> columns);
std::string table_head(std::span<const std::string> columns);

/// One line of a table.
std::string table_row(std::initializer_list<std::string_view> cells);
std::string table_row(std::span<const std::string> cells);

/// As code in a line; "" stays empty.
std::string code(std::string_view text);

}  // namespace g31::manual
