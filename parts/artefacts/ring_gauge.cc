#include "parts/artefacts/ring_gauge.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "parts/artefacts/polygon.h"
#include "parts/artefacts/solid.h"

namespace g31::parts {
namespace {

std::optional<std::string> why_impossible(const RingGauge& ring) {
  for (const double size :
       {ring.bore_mm, ring.outer_diameter_mm, ring.height_mm, ring.sagitta_mm}) {
    if (!std::isfinite(size) || size <= 0.0) {
      return "bore, outer_diameter, height and sagitta of a ring must be greater than 0 mm";
    }
  }
  if (ring.bore_mm >= ring.outer_diameter_mm) {
    return "the bore of a ring must be smaller than its outer_diameter";
  }
  return std::nullopt;
}

}  // namespace

Result<Mesh, std::string> ring_gauge_mesh(const RingGauge& ring) {
  if (auto impossible = why_impossible(ring)) {
    return *std::move(impossible);
  }
  const double inside = 0.5 * ring.bore_mm;
  const double outside = 0.5 * ring.outer_diameter_mm;
  const auto facets = sides_within(outside, ring.sagitta_mm, kMostFacets);
  if (!facets) {
    return std::string(
        "the sagitta of the ring is too small: it would take more than 100000 facets");
  }
  const std::array<Point2, 4> profile = {Point2(inside, 0.0), Point2(outside, 0.0),
                                         Point2(outside, -ring.height_mm),
                                         Point2(inside, -ring.height_mm)};
  return revolved(profile, *facets);
}

}  // namespace g31::parts
