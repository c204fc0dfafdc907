#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "parts/geometry/box.h"
#include "probe/contact/contact_triangle.h"

namespace g31::probe {

/// The answer "no contact" of sweep_triangle.
inline constexpr double kNoContact = std::numeric_limits<double>::infinity();

/// A pass that misses by less than this touches: exact tangency is a contact, and a line cannot be
/// computed better than this at 1e4 mm.
inline constexpr double kTangencyMm = 1e-12;

/// Some of the face and the three edges of a triangle, one bit each; an edge has its ends with it.
using Features = std::uint32_t;

inline constexpr Features kFace = 1;
inline constexpr Features kAllFeatures = 15;

/// Of the edge from vertex i to i + 1.
constexpr Features edge_feature(std::size_t i) {
  return 2U << i;
}

/// How far a ball moves along the path until it touches the triangle, mm; kNoContact if it does
/// not.
///
/// Closed form, the path of the centre against the triangle offset by the radius: offset plane,
/// edge cylinders, vertex spheres, in the form of closest approach.  The start must be free or in
/// touch; from a start inside, the answer is 0 or kNoContact, whether it goes deeper or not.
/// The offset triangle is convex: after a first contact that is left again there is no second one.
///
/// @param path    of the ball centre, length >= 0
/// @param radius  mm, > 0
/// Accuracy: |distance - radius| <= 1e-12 mm at the contact for coordinates up to 1e3 mm.
double sweep_triangle(const parts::Path& path, const ContactTriangle& triangle, double radius);

/// The same, looking for contacts with some features only.
double sweep_triangle(const parts::Path& path, const ContactTriangle& triangle, Features features,
                      double radius);

}  // namespace g31::probe
