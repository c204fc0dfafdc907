#pragma once

#include <string>

#include "machine/port/surroundings.h"
#include "probe/contact/sweep_mesh.h"

namespace g31::probe {

inline machine::Contact contact_of(const SweepHit& hit, const std::string& part) {
  return {hit.p_M_point, hit.n_M, part};
}

/// What the balls move by, mm: the linear axes.
inline Point way_of(const machine::Sweep& sweep) {
  return linear_axes(sweep.q_M_to) - linear_axes(sweep.q_M_from);
}

}  // namespace g31::probe
