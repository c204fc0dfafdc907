#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace g31::sinumerik {

/// What of a frame an index names.
enum class Component : std::uint8_t {
  Coarse,    ///< TR: shift
  Fine,      ///< FI: fine shift
  Rotation,  ///< RT: angle about the axis
  Scale,     ///< SC
  Mirror,    ///< MI: 1 mirrored
};

inline constexpr auto kComponentNames =
    std::to_array<std::string_view>({"TR", "FI", "RT", "SC", "MI"});

/// @param name  upper case
constexpr std::optional<Component> find_component(std::string_view name) {
  for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
    if (kComponentNames[i] == name) {
      return static_cast<Component>(i);
    }
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik
