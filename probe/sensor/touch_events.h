#pragma once

#include <string>

#include <fmt/format.h>

#include "machine/port/surroundings.h"
#include "probe/contact/sweep_mesh.h"

namespace g31::probe {

inline machine::Contact contact_of(const SweepHit& hit, const std::string& part) {
  return {hit.p_M_point, hit.n_M, part};
}

/// What is told where something gives way no further.
inline std::string pushed_too_deep(const std::string& what, double limit_mm,
                                   const std::string& into) {
  return fmt::format("{} is pushed {:.3f} mm into {}, its deflection limit", what, limit_mm, into);
}

}  // namespace g31::probe
