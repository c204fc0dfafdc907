#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "machine/base/result.h"

namespace g31::plan {

/// A text of JSON.
/// @param name      of the file, for messages
/// @param expected  what it should hold: "a whole plan.json of g31 plan"
///
/// Error: one line with the place.
Result<nlohmann::json, std::string> json_document(const std::string& name, std::string_view text,
                                                  std::string_view expected);

}  // namespace g31::plan
