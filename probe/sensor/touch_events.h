#pragma once

#include <string>

#include "machine/port/surroundings.h"
#include "probe/contact/sweep_mesh.h"

namespace g31::probe {

inline machine::Contact contact_of(const SweepHit& hit, const std::string& part) {
  return {hit.p_M_point, hit.n_M, part};
}

}  // namespace g31::probe
