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

/// A place as a document has it: 1-based, columns in characters.
source::LineColumn place_of(const source::SourceFile& file, std::size_t offset) {
  source::LineColumn place = file.line_column(offset);
  const std::string_view line = file.line(place.line);
  const auto before = std::min(static_cast<std::size_t>(place.column) - 1, line.size());
  place.column =
      1 + static_cast<int>(source::character_count(source::printable(line.substr(0, before))));
  return place;
}

/// Where a finding stands: on one line, and never of no width.
struct Extent {
  source::LineColumn begin;
  source::LineColumn end;
};

Extent extent_of(const analysis::Finding& finding) {
  const source::SourceFile& file = *finding.where.file;
  const source::Span span = finding.where.span;
  const std::size_t line_end = std::min(file.text().find('\n', span.begin), file.text().size());
  Extent extent;
  extent.begin = place_of(file, span.begin);
  extent.end = place_of(file, std::clamp(span.end, span.begin, std::max(span.begin, line_end)));
  extent.end.column = std::max(extent.end.column, extent.begin.column + 1);
  return extent;
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

std::string check_document(std::span<const analysis::Finding> findings) {
  Json document = {{"schema", "g31.check/1"}};
  document["findings"] = Json::array();
  for (const analysis::Finding& finding : findings) {
    const source::SourceFile& file = *finding.where.file;
    const auto [begin, end] = extent_of(finding);
    Json row = {{"rule", analysis::info(finding.rule).code},
                {"level", level_of(finding)},
                {"message", analysis::diagnostic_of(finding).message},
                {"file", file.name()},
                {"line", begin.line},
                {"column", begin.column},
                {"end_line", end.line},
                {"end_column", end.column},
                {"fix", nullptr}};
    row["remedy"] = finding.remedy;
    row["alarm"] = finding.alarm != 0 ? Json(finding.alarm) : Json(nullptr);
    document["findings"].push_back(std::move(row));
  }
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string github_annotations(std::span<const analysis::Finding> findings) {
  std::string text;
  for (const analysis::Finding& finding : findings) {
    const source::SourceFile& file = *finding.where.file;
    const auto [begin, end] = extent_of(finding);
    const std::string_view level = level_of(finding);
    const auto message = source::printable(analysis::diagnostic_of(finding).message);
    text += fmt::format("::{} file={},line={},col={},endLine={},endColumn={},title={}::{}\n",
                        level == "note" ? "notice" : level, escaped(file.name(), true), begin.line,
                        begin.column, end.line, end.column, analysis::info(finding.rule).code,
                        escaped(message, false));
  }
  return text;
}

}  // namespace g31::check
