#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/page/language.h"

namespace g31::page {

/// Readings of one quantity, in the order of the runs, and what is known of it.
struct Readings {
  std::vector<double> values;
  std::string unit;
  std::optional<double> known;    ///< the true value
  std::vector<double> published;  ///< by somebody else
  std::optional<double> mean;
  std::optional<double> deviation;  ///< standard deviation of one reading
};

// Drawings in the colours of the page; values stand in their labels too.

/// How often readings lie where: as many classes as the square root of their number, 5 to 40.
std::string histogram(const Readings& readings, Language language);
/// Each reading after the other, with mean and two standard deviations on both sides.  Of more
/// readings than there are places for dots, a place shows all between its least and its largest.
std::string run_chart(const Readings& readings, Language language);

}  // namespace g31::page
