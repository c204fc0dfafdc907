#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "parts/import/text_lines.h"
#include "parts/import/whole_file.h"

namespace g31::parts {
namespace {

class OffCheck {
 public:
  explicit OffCheck(std::string_view text) : lines_(text) {}

  std::optional<std::string> why_not() {
    if (auto wrong = of_head()) {
      return wrong;
    }
    // A line of a vertex has six characters or more, that of a face eight; the last has no end.
    const std::uint64_t held = (lines_.rest().size() + 2) / 6;
    if (vertices_ > held || faces_ > held) {
      return fmt::format(
          "its head promises {} vertices and {} faces, and {} bytes follow: it was "
          "cut off, or its head lies",
          vertices_, faces_, lines_.rest().size());
    }
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      if (auto wrong = of_vertex()) {
        return wrong;
      }
    }
    for (std::uint64_t i = 0; i < faces_; ++i) {
      if (auto wrong = of_face()) {
        return wrong;
      }
    }
    return next_line().empty() ? std::nullopt
                               : std::optional(fmt::format(
                                     "line {}: the {} vertices and {} faces that its head promises "
                                     "are over, and it goes on",
                                     lines_.number(), vertices_, faces_));
  }

 private:
  std::optional<std::string> of_head() {
    std::string_view line = next_line();
    const std::string_view kind = take_word(line);
    if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF") {
      return fmt::format("line {}: an OFF file begins with OFF", lines_.number());
    }
    if (take_word(line) == "BINARY") {
      return "its binary form is not read; write it as a text";
    }
    line = next_line();
    std::array<std::optional<std::uint64_t>, 2> counts;
    for (auto& count : counts) {
      count = number_in<std::uint64_t>(take_word(line));
    }
    if (!counts[0] || !counts[1]) {
      return fmt::format("line {}: the numbers of vertices, faces and edges are expected",
                         lines_.number());
    }
    vertices_ = *counts[0];
    faces_ = *counts[1];
    return std::nullopt;
  }

  std::optional<std::string> of_vertex() {
    std::string_view line = next_line();
    for (int i = 0; i < 3; ++i) {
      if (!number_in<double>(take_word(line))) {
        return wrong_line("a vertex with three numbers");
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> of_face() {
    std::string_view line = next_line();
    const auto corners = number_in<std::uint64_t>(take_word(line));
    if (!corners || *corners < 3) {
      return wrong_line("a face: its number of corners, three or more");
    }
    for (std::uint64_t i = 0; i < *corners; ++i) {
      const auto vertex = number_in<std::uint64_t>(take_word(line));
      if (!vertex || *vertex >= vertices_) {
        return wrong_line(
            fmt::format("a face with {} corners, vertices below {}", *corners, vertices_));
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string wrong_line(std::string_view expected) const {
    return fmt::format("line {}: expected {}{}", lines_.number(), expected,
                       lines_.rest().empty() ? "; here the file ends: it was cut off" : "");
  }

  /// The next that says something; "" at the end.
  std::string_view next_line() {
    while (const auto line = lines_.next()) {
      std::string_view said = line->substr(0, line->find('#'));
      std::string_view words = said;
      if (!take_word(words).empty()) {
        return said;
      }
    }
    return {};
  }

  TextLines lines_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
};

}  // namespace

std::optional<std::string> why_no_whole_off(std::string_view text) {
  return OffCheck(text).why_not();
}

}  // namespace g31::parts
