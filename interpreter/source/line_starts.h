#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace g31::source {

/// 1-based, columns counted in bytes.
struct LineColumn {
  int line = 1;
  int column = 1;
  friend bool operator==(LineColumn, LineColumn) = default;
};

/// LF for each CR of a text whose lines end with CR alone, as old computers and EIA readers leave
/// it: controls know LF only, so without this all of it would be one block.  A text with any LF
/// stays as it is.
void use_line_feeds(std::string& text);

/// How many LF a text has; one after the other, for a look at each byte takes four times as long.
std::size_t line_ends_in(std::string_view text);

/// Where the lines of a text begin: at its beginning and behind each LF.
class LineStarts {
 public:
  explicit LineStarts(std::string_view text);

  /// @param offset  0 to the size of the text, whose end is a legal place for a message
  [[nodiscard]] LineColumn at(std::size_t offset) const;

  /// Where a line begins.  @param line  from 1; nullopt: there is no such line
  [[nodiscard]] std::optional<std::size_t> begin_of(int line) const;

 private:
  std::size_t size_;
  std::vector<std::size_t> starts_;
};

}  // namespace g31::source
