#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "parts/artefacts/makers.h"
#include "parts/artefacts/polygon.h"
#include "parts/artefacts/ring_gauge.h"
#include "parts/artefacts/solid.h"

namespace g31::parts {
namespace {

/// Around a sphere: half a million facets in all.
constexpr std::size_t kMostSphereSides = 1000;
constexpr std::size_t kMostPrismSides = 1000;

std::string too_fine(const std::string& shape, const std::string& limit) {
  return "the sagitta of the " + shape + " is too small: it would take more than " + limit +
         " facets";
}

}  // namespace

Result<Mesh, std::string> make_ring(const Sizes& sizes) {
  RingGauge ring;
  ring.bore_mm = sizes.at("bore");
  ring.outer_diameter_mm = sizes.at("outer_diameter");
  ring.height_mm = sizes.at("height");
  ring.sagitta_mm = sizes.at("sagitta");
  return ring_gauge_mesh(ring);
}

Result<Mesh, std::string> make_cylinder(const Sizes& sizes) {
  const double radius = 0.5 * sizes.at("diameter");
  const double bottom = -sizes.at("height");
  const auto facets = sides_within(radius, sizes.at("sagitta"), kMostFacets);
  if (!facets) {
    return too_fine("cylinder", "100000");
  }
  const std::array<Point2, 4> profile = {Point2(0.0, 0.0), Point2(radius, 0.0),
                                         Point2(radius, bottom), Point2(0.0, bottom)};
  return revolved(profile, *facets);
}

Result<Mesh, std::string> make_plug(const Sizes& sizes) {
  const double radius = 0.5 * sizes.at("diameter");
  const double foot = 0.5 * sizes.at("foot_diameter");
  const double shoulder = -sizes.at("height");
  const double bottom = shoulder - sizes.at("foot_height");
  if (foot <= radius) {
    return std::string("the foot_diameter of a plug must be larger than its diameter");
  }
  const auto facets = sides_within(foot, sizes.at("sagitta"), kMostFacets);
  if (!facets) {
    return too_fine("plug", "100000");
  }
  const std::array<Point2, 6> profile = {Point2(0.0, 0.0),         Point2(radius, 0.0),
                                         Point2(radius, shoulder), Point2(foot, shoulder),
                                         Point2(foot, bottom),     Point2(0.0, bottom)};
  return revolved(profile, *facets);
}

Result<Mesh, std::string> make_sphere(const Sizes& sizes) {
  const double radius = 0.5 * sizes.at("diameter");
  const auto sides = sphere_sides_within(radius, sizes.at("sagitta"), kMostSphereSides);
  if (!sides) {
    return too_fine("sphere", "500000");
  }
  // Down the right-hand half of a tangent polygon, with the poles in the middles of its flat ends.
  const std::vector<Point2> outline = tangent_polygon(radius, *sides);
  std::vector<Point2> profile = {{0.0, radius}};
  for (std::size_t i = *sides / 4; i-- > 0;) {
    profile.push_back(outline[i]);
  }
  for (std::size_t i = *sides; i-- > 3 * *sides / 4;) {
    profile.push_back(outline[i]);
  }
  profile.emplace_back(0.0, -radius);
  return revolved(profile, *sides);
}

Result<Mesh, std::string> make_prism(const Sizes& sizes) {
  const double sides = sizes.at("sides");
  if (sides != std::floor(sides) || sides < 3.0 || sides > static_cast<double>(kMostPrismSides)) {
    return std::string("the sides of a prism must be a whole number from 3 to 1000");
  }
  const double radius = 0.5 * sizes.at("across_flats");
  const double bottom = -sizes.at("height");
  const std::array<Point2, 4> profile = {Point2(0.0, 0.0), Point2(radius, 0.0),
                                         Point2(radius, bottom), Point2(0.0, bottom)};
  return revolved(profile, static_cast<std::size_t>(sides));
}

}  // namespace g31::parts
