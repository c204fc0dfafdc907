#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace g31::testing {

/// The folder of the listings printed in Hirose's paper, which are not part of this repository:
/// what G31_HIROSE names, or a folder beside the repository; nullopt when they are not there.
inline std::optional<std::string> original_listings() {
  const char* const named = std::getenv("G31_HIROSE");
  std::string folder = named != nullptr ? named : "../shared/cases/hirose";
  return std::filesystem::exists(folder + "/O9010.nc") ? std::optional(std::move(folder))
                                                       : std::nullopt;
}

}  // namespace g31::testing
