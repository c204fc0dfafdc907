#pragma once

#include <string>
#include <string_view>

#include "interpreter/dialects/fanuc/profile.h"
#include "machine/base/result.h"

namespace g31::cli {

/// The control of the Fanuc dialect where nothing names one.
inline constexpr std::string_view kDefaultControl = "fanuc-16i";

/// The profile of this name; else one line that names the nearest and all known ones.
Result<const fanuc::Profile*, std::string> profile_named(std::string_view name);

}  // namespace g31::cli
