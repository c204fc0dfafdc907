#include "tools/check/baseline.h"

#include <cstddef>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/base/json_nesting.h"
#include "tools/check/extent.h"

namespace g31::check {
namespace {

using Json = nlohmann::ordered_json;

/// One way to write a path: "./a.nc" is "a.nc".
std::string plain_path(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

const std::string* text_in(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? found->get_ptr<const std::string*>()
                                                     : nullptr;
}

}  // namespace

Result<Baseline, std::string> Baseline::read(const std::string& name, std::string_view text) {
  const Json document = nests_too_deep(text) ? Json() : Json::parse(text, nullptr, false);
  const std::string* const schema = text_in(document, "schema");
  const bool has_findings =
      document.is_object() && document.contains("findings") && document.at("findings").is_array();
  if (schema == nullptr || *schema != "g31.check/1" || !has_findings) {
    return fmt::format(
        "{} is no document g31.check/1: g31 check FILE... --json known.json writes one", name);
  }
  Baseline baseline;
  std::size_t number = 0;
  for (const Json& finding : document.at("findings")) {
    ++number;
    for (const char* const key : {"rule", "file", "line_text"}) {
      if (text_in(finding, key) == nullptr) {
        return fmt::format("{}: finding {} has no text `{}`: write the document anew with --json",
                           name, number, key);
      }
    }
    baseline.known_.emplace(*text_in(finding, "rule"), plain_path(*text_in(finding, "file")),
                            *text_in(finding, "line_text"));
  }
  return baseline;
}

std::vector<analysis::Finding> Baseline::without_known(std::vector<analysis::Finding> found,
                                                       const source::SourceMap& sources) const {
  std::erase_if(found, [&](const analysis::Finding& finding) {
    const Extent extent = extent_of(finding, sources);
    return known_.contains({std::string(analysis::info(finding.rule).code), plain_path(extent.file),
                            extent.line_text});
  });
  return found;
}

}  // namespace g31::check
