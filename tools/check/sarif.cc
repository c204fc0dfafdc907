#include "tools/check/sarif.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interpreter/source/diagnostic.h"
#include "tools/check/extent.h"

namespace g31::check {
namespace {

using Json = nlohmann::ordered_json;

/// RFC 3986: what a path segment may have as it is.  A colon in the first segment of a relative
/// path would make it a scheme.
bool is_plain(char c) {
  constexpr std::string_view kOthers = "-._~!$&'()*+,;=@/";
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
         kOthers.find(c) != kOthers.npos;
}

std::string uri_of(const std::string& path) {
  std::string uri = std::filesystem::path(path).is_absolute() ? "file://" : "";
  for (const char c : path) {
    uri += is_plain(c)
               ? std::string(1, c)
               : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return uri;
}

Json text_of(std::string_view text) {
  return {{"text", text}};
}

Json region_of(const Extent& extent) {
  return {{"startLine", extent.line},
          {"startColumn", extent.column},
          {"endLine", extent.end_line},
          {"endColumn", extent.end_column}};
}

Json rule_list() {
  Json list = Json::array();
  for (const analysis::Rule& rule : analysis::rules()) {
    list.push_back({{"id", rule.code},
                    {"shortDescription", text_of(rule.title)},
                    {"fullDescription", text_of(rule.text)},
                    {"defaultConfiguration", {{"level", source::name_of(rule.level)}}}});
  }
  return list;
}

Json fix_of(const analysis::Fix& fix, const Json& artifact, const source::SourceMap& sources) {
  Json replacements = Json::array();
  for (const analysis::Edit& edit : fix.edits) {
    replacements.push_back({{"deletedRegion", region_of(extent_of(edit, sources))},
                            {"insertedContent", text_of(edit.text)}});
  }
  Json change = {{"artifactLocation", artifact}, {"replacements", std::move(replacements)}};
  return {{"description", text_of(fix.title)},
          {"artifactChanges", Json::array({std::move(change)})}};
}

/// FNV-1a of a line without its blanks.
std::uint64_t hash_of(std::string_view line) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char c : line) {
    if (c != ' ' && c != '\t') {
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
    }
  }
  return hash;
}

/// Tells a finding from all others wherever its line goes: so who keeps them knows it again.
class Fingerprints {
 public:
  /// @returns the line, and how often the file has had one like it
  Json of(const std::string& rule, const Extent& extent) {
    const std::string hash = fmt::format("{:016x}", hash_of(extent.line_text));
    const int count = ++counts_[{rule, extent.file, hash}];
    return {{"primaryLocationLineHash", fmt::format("{}:{}", hash, count)}};
  }

 private:
  std::map<std::tuple<std::string, std::string, std::string>, int> counts_;
};

Json result_of(const analysis::Finding& finding, const source::SourceMap& sources,
               Fingerprints& fingerprints) {
  const analysis::Rule& rule = analysis::info(finding.rule);
  const Extent extent = extent_of(finding, sources);
  const Json artifact = {{"uri", uri_of(extent.file)}};
  const source::Diagnostic message = analysis::diagnostic_of(finding);
  Json result = {{"ruleId", rule.code},
                 {"ruleIndex", static_cast<std::size_t>(finding.rule)},
                 {"level", source::name_of(rule.level)},
                 {"message", text_of(message.remedy.empty() ? message.message
                                                            : fmt::format("{}; {}", message.message,
                                                                          message.remedy))}};
  Json place = {{"artifactLocation", artifact}, {"region", region_of(extent)}};
  result["locations"] = Json::array({{{"physicalLocation", std::move(place)}}});
  result["partialFingerprints"] = fingerprints.of(std::string(rule.code), extent);
  if (finding.fix) {
    result["fixes"] = Json::array({fix_of(*finding.fix, artifact, sources)});
  }
  return result;
}

}  // namespace

std::string sarif_log(std::span<const analysis::Finding> findings, const source::SourceMap& sources,
                      std::string_view version) {
  Json results = Json::array();
  Fingerprints fingerprints;
  for (const analysis::Finding& finding : findings) {
    results.push_back(result_of(finding, sources, fingerprints));
  }
  const Json driver = {{"name", "g31"}, {"version", version}, {"rules", rule_list()}};
  const Json run = {{"tool", {{"driver", driver}}},
                    {"columnKind", "unicodeCodePoints"},
                    {"results", std::move(results)}};
  const Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", Json::array({run})}};
  return log.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace g31::check
