#include "tools/plan/json_document.h"

#include <algorithm>

#include <fmt/format.h>

#include "machine/base/json_nesting.h"

namespace g31::plan {
namespace {

/// "NAME:LINE:COLUMN", columns in bytes.
std::string place_of(const std::string& name, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("{}:{}:{}", name, line, before.size() - begin + 1);
}

}  // namespace

Result<nlohmann::json, std::string> json_document(const std::string& name, std::string_view text,
                                                  std::string_view expected) {
  if (nests_too_deep(text)) {
    return fmt::format("{}: lists stand more than {} deep inside one another; expected {}", name,
                       kDeepestJson, expected);
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    return fmt::format("{}: no JSON from here on; expected {}", place_of(name, text, error.byte),
                       expected);
  } catch (const nlohmann::json::exception&) {
    return fmt::format("{}: it holds a number that is too large; expected {}", name, expected);
  }
}

}  // namespace g31::plan
