#include "interpreter/source/line_starts.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "machine/base/contract.h"

namespace g31::source {

void use_line_feeds(std::string& text) {
  if (text.find('\n') == std::string::npos) {
    std::ranges::replace(text, '\r', '\n');
  }
}

std::size_t line_ends_in(std::string_view text) {
  std::size_t count = 0;
  // No more than a byte counts, in whole registers: so many are compared at a time as one holds.
  constexpr std::size_t kPiece = 240;
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kPiece))) {
    std::uint8_t in_piece = 0;
    for (const char c : text.substr(0, kPiece)) {
      in_piece = static_cast<std::uint8_t>(in_piece + (c == '\n' ? 1 : 0));
    }
    count += in_piece;
  }
  return count;
}

LineStarts::LineStarts(std::string_view text) : size_(text.size()), starts_{0} {
  for (std::size_t i = text.find('\n'); i != text.npos; i = text.find('\n', i + 1)) {
    starts_.push_back(i + 1);
  }
}

LineColumn LineStarts::at(std::size_t offset) const {
  G31_EXPECTS(offset <= size_);
  const auto next = std::ranges::upper_bound(starts_, offset);
  return {static_cast<int>(next - starts_.begin()),
          static_cast<int>(offset - *std::prev(next) + 1)};
}

std::optional<std::size_t> LineStarts::begin_of(int line) const {
  if (line < 1 || static_cast<std::size_t>(line) > starts_.size()) {
    return std::nullopt;
  }
  return starts_[static_cast<std::size_t>(line) - 1];
}

}  // namespace g31::source
