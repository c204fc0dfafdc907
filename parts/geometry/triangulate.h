#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "machine/units/point.h"

namespace g31::parts {

/// Cuts a polygon, nearly plane, convex or not, into triangles that turn the same way round.
///
/// Ears are clipped one by one; where a polygon crosses itself or has no area some cut is made all
/// the same, so n corners always give n - 2 triangles, and fewer than three give none.
/// @param corners  indices into `vertices`, in order around the polygon
std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Point> vertices,
                                                       std::span<const std::uint32_t> corners);

}  // namespace g31::parts
