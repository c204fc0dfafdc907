#include "tools/session/variables_file.h"

#include <charconv>

#include <fmt/format.h>

#include "tools/setup/assignment.h"

namespace g31::session {

std::string variables_text(const std::map<std::string, double>& variables) {
  std::string text;
  for (const auto& [name, value] : variables) {
    text += fmt::format("{}={}\n", name, value);
  }
  return text;
}

Result<std::map<std::string, std::optional<double>>, std::string> parse_variables_text(
    std::string_view text) {
  std::map<std::string, std::optional<double>> variables;
  for (int line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') {
      line.pop_back();
    }
    if (line.empty() || line.front() == ';') {
      continue;
    }
    auto assignment = setup::parse_assignment(line);
    if (!assignment) {
      return fmt::format("line {}: {}", line_number, assignment.error());
    }
    variables[assignment.value().name] = assignment.value().value;
  }
  return variables;
}

}  // namespace g31::session
