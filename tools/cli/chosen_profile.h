#pragma once

#include <string>
#include <string_view>

#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "machine/base/result.h"

namespace g31::cli {

/// The control of the Fanuc dialect where nothing names one.
inline constexpr std::string_view kDefaultControl = "fanuc-16i";

/// A control by its name: one of the Fanuc dialect has a profile, the SINUMERIK has none.
struct ChosenControl {
  std::string_view name;
  const fanuc::Profile* profile = nullptr;
};

/// The control of this name; else one line that names the nearest and all known ones.
Result<ChosenControl, std::string> control_named(std::string_view name);

/// The control that a program's file ending speaks for (.MPF, .SPF and .ARC are SINUMERIK), else
/// the first line of its text (%_N_NAME_MPF).
std::string_view control_of_program(const std::string& path, std::string_view text);

}  // namespace g31::cli
