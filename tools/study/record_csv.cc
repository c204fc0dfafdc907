#include "tools/study/record_csv.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace g31::study {
namespace {

std::string field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

void add_line(std::string& text, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    text += (i > 0 ? "," : "") + field(fields[i]);
  }
  text += "\r\n";
}

}  // namespace

std::string record_csv(const Record& record) {
  const Description& d = record.description;
  std::vector<std::string> fields = {"run", "seed", "status", "exit"};
  fields.insert(fields.end(), d.listed.begin(), d.listed.end());
  fields.insert(fields.end(), d.drawn.begin(), d.drawn.end());
  for (const ResultForm& result : d.results) {
    fields.push_back(result.name);
  }
  fields.emplace_back("note");
  std::string text;
  add_line(text, fields);
  for (const Row& row : record.rows) {
    fields = {fmt::format("{}", row.run + 1), fmt::format("{}", row.seed), row.status,
              fmt::format("{}", row.exit_code)};
    const auto& values = d.points.at(row.run / d.repeats);
    fields.insert(fields.end(), values.begin(), values.end());
    for (const double drawn : row.drawn) {
      fields.push_back(fmt::format("{}", drawn));
    }
    for (const auto& result : row.results) {
      fields.push_back(result ? fmt::format("{}", *result) : "");
    }
    fields.push_back(row.note);
    add_line(text, fields);
  }
  return text;
}

}  // namespace g31::study
