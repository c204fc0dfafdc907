#include "tools/check/check_document.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/source/printable.h"
#include "tools/check/extent.h"

namespace g31::check {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "g31.check/1";

std::string_view level_of(const analysis::Finding& finding) {
  return source::name_of(analysis::info(finding.rule).level);
}

/// GitHub's own escapes, of control characters too, which move no cursor of who reads the log.
std::string escaped(std::string_view text, bool is_property) {
  std::string all;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_special = c == '%' || code < ' ' || (is_property && (c == ':' || c == ','));
    all += is_special ? fmt::format("%{:02X}", code) : std::string(1, c);
  }
  return all;
}

Json json_of(const analysis::Fix& fix, const source::SourceMap& sources) {
  Json edits = Json::array();
  for (const analysis::Edit& edit : fix.edits) {
    const Extent extent = extent_of(edit, sources);
    edits.push_back({{"line", extent.line},
                     {"column", extent.column},
                     {"end_line", extent.end_line},
                     {"end_column", extent.end_column},
                     {"text", edit.text}});
  }
  return {{"title", fix.title}, {"edits", std::move(edits)}};
}

}  // namespace

std::string check_document(std::span<const analysis::Finding> findings,
                           std::span<const std::string> unread, const source::SourceMap& sources) {
  Json document = {{"schema", kSchema}};
  document["findings"] = Json::array();
  for (const analysis::Finding& finding : findings) {
    const Extent extent = extent_of(finding, sources);
    Json row = {{"rule", analysis::info(finding.rule).code},
                {"level", level_of(finding)},
                {"message", analysis::diagnostic_of(finding).message},
                {"file", extent.file},
                {"line", extent.line},
                {"column", extent.column},
                {"end_line", extent.end_line},
                {"end_column", extent.end_column},
                {"fix", finding.fix ? json_of(*finding.fix, sources) : Json(nullptr)}};
    row["line_text"] = extent.line_text;
    row["remedy"] = finding.remedy;
    row["alarm"] = finding.alarm != 0 ? Json(finding.alarm) : Json(nullptr);
    document["findings"].push_back(std::move(row));
  }
  if (!unread.empty()) {
    constexpr int kUnreadableInput = 2;
    document["status"] = "usage";
    document["exit_code"] = kUnreadableInput;
    document["diagnostics"] = Json::array();
    for (const std::string& message : unread) {
      document["diagnostics"].push_back(
          {{"severity", "error"}, {"code", ""}, {"message", message}});
    }
  }
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string rules_document() {
  Json document = {{"schema", kSchema}};
  document["findings"] = Json::array();
  document["rules"] = Json::array();
  for (const analysis::Rule& rule : analysis::rules()) {
    document["rules"].push_back({{"rule", rule.code},
                                 {"level", source::name_of(rule.level)},
                                 {"title", rule.title},
                                 {"text", rule.text}});
  }
  return document.dump(1) + "\n";
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
