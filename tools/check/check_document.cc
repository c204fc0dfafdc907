#include "tools/check/check_document.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/source/printable.h"

namespace g31::check {
namespace {

using Json = nlohmann::ordered_json;

std::string_view level_of(const analysis::Finding& finding) {
  return source::name_of(analysis::info(finding.rule).level);
}

/// Where a finding stands: on one line, and never of no width.  Columns count characters from 1.
struct Extent {
  std::string file;
  int line = 0;
  int column = 0;
  int end_column = 0;
};

/// @param bytes  of the line before the column
int column_of(std::string_view line, std::size_t bytes) {
  return 1 + static_cast<int>(source::character_count(source::printable(line.substr(0, bytes))));
}

Extent extent_of(const analysis::Finding& finding, const source::SourceMap& sources) {
  const source::ShownPlace place = sources.show(finding.where);
  const auto before = static_cast<std::size_t>(std::max(place.column, 1)) - 1;
  const int column = column_of(place.text, before);
  const int end = column_of(place.text, before + finding.where.length);
  return {place.file, place.line, column, std::max(end, column + 1)};
}

/// GitHub's own escapes.
std::string escaped(std::string_view text, bool is_property) {
  std::string all;
  for (const char c : text) {
    const bool is_special =
        c == '%' || c == '\n' || c == '\r' || (is_property && (c == ':' || c == ','));
    all += is_special ? fmt::format("%{:02X}", static_cast<unsigned>(c)) : std::string(1, c);
  }
  return all;
}

}  // namespace

std::string check_document(std::span<const analysis::Finding> findings,
                           std::span<const std::string> unread, const source::SourceMap& sources) {
  Json document = {{"schema", "g31.check/1"}};
  document["findings"] = Json::array();
  for (const analysis::Finding& finding : findings) {
    const Extent extent = extent_of(finding, sources);
    Json row = {{"rule", analysis::info(finding.rule).code},
                {"level", level_of(finding)},
                {"message", analysis::diagnostic_of(finding).message},
                {"file", extent.file},
                {"line", extent.line},
                {"column", extent.column},
                {"end_line", extent.line},
                {"end_column", extent.end_column},
                {"fix", nullptr}};
    row["remedy"] = finding.remedy;
    row["alarm"] = finding.alarm != 0 ? Json(finding.alarm) : Json(nullptr);
    document["findings"].push_back(std::move(row));
  }
  if (!unread.empty()) {
    document["diagnostics"] = Json::array();
    for (const std::string& message : unread) {
      document["diagnostics"].push_back(
          {{"severity", "error"}, {"code", ""}, {"message", message}});
    }
  }
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string github_annotations(std::span<const analysis::Finding> findings,
                               const source::SourceMap& sources) {
  std::string text;
  for (const analysis::Finding& finding : findings) {
    const Extent extent = extent_of(finding, sources);
    const std::string_view level = level_of(finding);
    const auto message = source::printable(analysis::diagnostic_of(finding).message);
    text += fmt::format("::{} file={},line={},col={},endLine={},endColumn={},title={}::{}\n",
                        level == "note" ? "notice" : level, escaped(extent.file, true), extent.line,
                        extent.column, extent.line, extent.end_column,
                        analysis::info(finding.rule).code, escaped(message, false));
  }
  return text;
}

}  // namespace g31::check
