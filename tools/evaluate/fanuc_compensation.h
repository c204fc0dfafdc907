#pragma once

#include <optional>
#include <string>

#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {

/// Why an error does not fit the tables of a Fanuc; nullopt: it does.
std::optional<std::string> why_no_fanuc_compensation(const MachineError& error);

/// A program that enters compensations into a Fanuc, in detection units of 0.001 mm: along an axis
/// pitch errors (parameters 3620 to 3624, data N10000 on), across it straightness (5711, 5721, 5731
/// to 5734, 5761 to 5764), which knows four places: those of the curve that leave least.
/// A pitch error is what the correction gains from one multiple of the interval to the next, at the
/// number of that section, 3620 being the one before machine coordinate 0.
/// The correction of a straightness point is whole where its section ends towards positive places.
/// Of places that are not evenly apart, points of pitch errors lie nearer than those, so that the
/// lines between them meet the error there; what stays is said in the text.
/// Source: parameter manual B-63980EN/01 pages 99 and 100 (pitch errors); what straightness and G10
/// L52 read, and the least interval, are from general knowledge of the 30i.
std::string fanuc_compensation(const MachineError& error);

}  // namespace g31::evaluate
