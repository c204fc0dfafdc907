#pragma once

#include <string>

#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {

/// An INI file for the compensations of a SINUMERIK: along an axis $AA_ENC_COMP, across it $AN_CEC.
/// The values are the deviations themselves: a positive value makes the axis move in the negative
/// direction.
/// Source: function manual K3, 6FC5397-1BP40-3BA1, 4.4.2.1 page 238 (direction, $AA_ENC_COMP),
/// 4.4.2.3 page 242 and 4.4.3.2 pages 248 and 249 (data, form of the file); that $AN_CEC counts in
/// the same direction is read off tables that shops enter (measured less commanded place).
std::string sinumerik_compensation(const MachineError& error);

}  // namespace g31::evaluate
