#include "tools/cli/chosen_profile.h"

#include <vector>

#include <fmt/format.h>

#include "machine/base/nearest_name.h"

namespace g31::cli {

Result<const fanuc::Profile*, std::string> profile_named(std::string_view name) {
  if (const fanuc::Profile* const profile = fanuc::find_profile(name)) {
    return profile;
  }
  std::vector<std::string_view> known;
  for (const fanuc::Profile& profile : fanuc::profiles()) {
    known.push_back(profile.name);
  }
  const auto nearest = nearest_name(name, known);
  return fmt::format("unknown control '{}'{}; known: {}", name,
                     nearest ? fmt::format(", did you mean '{}'?", *nearest) : "",
                     fmt::join(known, ", "));
}

}  // namespace g31::cli
