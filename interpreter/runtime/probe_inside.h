#pragma once

#include <optional>
#include <string>

#include <fmt/format.h>

#include "machine/port/machine_port.h"

namespace g31::runtime {

/// What PRB517 says of a probe that has come into the spindle inside a part; nullopt: it stands in
/// none.
inline std::optional<std::string> comes_inside(const machine::MachinePort& port) {
  const std::string part = port.stands_inside();
  return part.empty() ? std::nullopt
                      : std::optional(fmt::format(" as it comes into the spindle: in '{}'", part));
}

}  // namespace g31::runtime
