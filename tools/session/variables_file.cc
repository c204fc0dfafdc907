#include "tools/session/variables_file.h"

#include <algorithm>
#include <utility>

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

Result<std::vector<KeptVariable>, setup::SetupErrors> parse_variables_text(const std::string& path,
                                                                           std::string_view text) {
  std::vector<KeptVariable> variables;
  setup::SetupErrors errors;
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
    source::ShownPlace place{path, line_number, 1, std::move(line)};
    if (assignment) {
      variables.push_back({assignment.value(), std::move(place)});
    } else {
      errors.push_back(
          error_at(std::move(place), setup::SetupErrorId::NoAssignment, {assignment.error()}));
    }
  }
  return errors.empty() ? Result<std::vector<KeptVariable>, setup::SetupErrors>(variables) : errors;
}

}  // namespace g31::session
