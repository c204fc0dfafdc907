#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

#include "parts/import/mesh_limits.h"
#include "parts/import/text_lines.h"
#include "parts/import/whole_file.h"

namespace g31::parts {
namespace {

/// Checks an OBJ line by line; a face may name vertices that come later.
class ObjCheck {
 public:
  explicit ObjCheck(std::string_view text) : lines_(text) {}

  std::optional<std::string> why_not() {
    while (const auto line = lines_.next()) {
      if (auto wrong = of_statement(*line)) {
        return fmt::format("line {}: {}", lines_.number(), *wrong);
      }
    }
    if (last_named_ > vertices_) {
      return fmt::format("line {}: a face names vertex {}, but there are only {}", last_named_line_,
                         last_named_, vertices_);
    }
    return std::nullopt;
  }

 private:
  std::optional<std::string> of_statement(std::string_view line) {
    std::string_view rest = line;
    const std::string_view statement = take_word(rest);
    if (statement == "v") {
      ++vertices_;
      return of_vertex(rest);
    }
    return statement == "f" ? of_face(rest) : std::nullopt;
  }

  std::optional<std::string> of_vertex(std::string_view rest) {
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next_word(rest);
      if (!number_in<double>(word)) {
        return fmt::format("a vertex has three numbers; '{}' is none{}", word, perhaps_cut_off());
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> of_face(std::string_view rest) {
    std::size_t corners = 0;
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
      const auto number = number_in<std::int64_t>(word.substr(0, word.find('/')));
      if (!number || *number == 0 || *number < -static_cast<std::int64_t>(vertices_)) {
        return fmt::format("'{}' names no vertex of a face", word);
      }
      if (*number > 0 && static_cast<std::uint64_t>(*number) > last_named_) {
        last_named_ = static_cast<std::uint64_t>(*number);
        last_named_line_ = lines_.number();
      }
      ++corners;
    }
    if (corners < 3) {
      return fmt::format("a face has three corners or more, this one {}{}", corners,
                         perhaps_cut_off());
    }
    return std::nullopt;
  }

  /// The next word of a statement, which goes on behind a line that ends with a backslash.
  std::string_view next_word(std::string_view& rest) {
    std::string_view word = take_word(rest);
    while (word == "\\") {
      rest = lines_.next().value_or("");
      word = take_word(rest);
    }
    return word;
  }

  [[nodiscard]] std::string_view perhaps_cut_off() const {
    return lines_.rest().empty() ? ", and here the file ends: it was cut off" : "";
  }

  TextLines lines_;
  std::uint64_t vertices_ = 0;
  std::uint64_t last_named_ = 0;
  std::size_t last_named_line_ = 0;
};

}  // namespace

std::optional<std::string> why_no_whole_obj(std::string_view text) {
  return ObjCheck(text).why_not();
}

}  // namespace g31::parts
