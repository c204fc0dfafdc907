#include "tools/cli/chosen_profile.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/session.h"
#include "machine/base/nearest_name.h"

namespace g31::cli {

Result<ChosenControl, std::string> control_named(std::string_view name) {
  if (const fanuc::Profile* const profile = fanuc::find_profile(name)) {
    return ChosenControl{profile->name, profile};
  }
  if (name == sinumerik::kControlName) {
    return ChosenControl{sinumerik::kControlName, nullptr};
  }
  std::vector<std::string_view> known;
  for (const fanuc::Profile& profile : fanuc::profiles()) {
    known.push_back(profile.name);
  }
  known.push_back(sinumerik::kControlName);
  const auto nearest = nearest_name(name, known);
  return fmt::format("unknown control '{}'{}; known: {}", name,
                     nearest ? fmt::format(", did you mean '{}'?", *nearest) : "",
                     fmt::join(known, ", "));
}

std::string_view control_of_program(const std::string& path, std::string_view text) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const bool by_ending = ending == ".mpf" || ending == ".spf" || ending == ".arc";
  return by_ending || text.starts_with("%_N_") ? sinumerik::kControlName : kDefaultControl;
}

}  // namespace g31::cli
