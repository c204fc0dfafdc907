#include "tools/setup/lost_variables.h"

#include <algorithm>
#include <string_view>

#include "tools/setup/variable_name.h"

namespace g31::setup {
namespace {

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  return text;
}

/// `#500 = 3.0`: digits right behind the #, then a number or "".
bool is_lost_variable(std::string_view line) {
  if (!line.starts_with('#')) {
    return false;
  }
  line.remove_prefix(1);
  if (line.empty() || !is_digit(line.front())) {
    return false;
  }
  while (!line.empty() && is_digit(line.front())) {
    line.remove_prefix(1);
  }
  line = without_blanks(line);
  if (!line.starts_with('=')) {
    return false;
  }
  line.remove_prefix(1);
  line = without_blanks(line);
  if (line.starts_with('-') || line.starts_with('+') || line.starts_with('.')) {
    line.remove_prefix(1);
  }
  return line.starts_with("\"\"") || (!line.empty() && is_digit(line.front()));
}

}  // namespace

std::vector<Location> lost_variables_in(const Document& document) {
  std::vector<Location> found;
  const std::string_view text = document.text;
  const bool has_long_texts =
      text.find("\"\"\"") != std::string_view::npos || text.find("'''") != std::string_view::npos;
  int line = 1;
  for (std::size_t at = 0; at < text.size() && !has_long_texts; ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view whole = text.substr(at, end - at);
    const std::string_view rest = without_blanks(whole);
    if (is_lost_variable(rest)) {
      found.push_back({&document, line, static_cast<int>(whole.size() - rest.size()) + 1});
    }
    at = end + 1;
  }
  return found;
}

}  // namespace g31::setup
