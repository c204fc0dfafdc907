#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace g31::metrology {

/// Where a motion along a circle stands still for a while and goes on: the samples in the middle of
/// each standstill, in their order.
///
/// It stands still where a quarter of a degree takes more than three times as long as most of them
/// do.  Standstills less than 45 degrees behind the one before, the start or the end do not count:
/// a path that stops as often never runs.  Nor do slow ways of more than a degree.
/// @param t    time of each sample, s, rising
/// @param way  angle that was passed until then, rad, rising but for noise
std::vector<std::size_t> standstills(std::span<const double> t, std::span<const double> way);

}  // namespace g31::metrology
