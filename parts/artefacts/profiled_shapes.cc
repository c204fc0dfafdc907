#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "parts/artefacts/makers.h"
#include "parts/artefacts/polygon.h"
#include "parts/artefacts/solid.h"

namespace g31::parts {
namespace {

/// Of a shaft: facets around times rows along.
constexpr std::size_t kMostShaftFacets = 2'000'000;

/// The error at every place where it bends, and at both ends.
/// Error: a place outside the shape, or an error that leaves nothing of it.
Result<std::vector<Point2>, std::string> errors_along(const ShapeProfile& profile, double length,
                                                      double thickness) {
  std::vector<Point2> rows;
  for (const auto& [place, deviation] : profile) {
    if (place < 0.0 || place > length) {
      return std::string("the places of a profile must lie between 0 and the end of the shape");
    }
    if (!(std::fabs(deviation) < thickness)) {
      return std::string(
          "the deviations of a profile must be smaller than the thickness of the shape");
    }
    rows.emplace_back(place, deviation);
  }
  if (rows.empty()) {
    rows.emplace_back(0.0, 0.0);
  }
  if (rows.front().x() > 0.0) {
    rows.insert(rows.begin(), Point2(0.0, rows.front().y()));
  }
  if (rows.back().x() < length) {
    rows.emplace_back(length, rows.back().y());
  }
  return rows;
}

/// A bar along X whose cross-section is a rectangle everywhere.  @param tops  (x, z), x rising
Mesh bar(const std::vector<Point2>& tops, double width, double height) {
  constexpr std::uint32_t kCorners = 4;
  Mesh mesh;
  const double side = 0.5 * width;
  for (const Point2& top : tops) {
    mesh.vertices.emplace_back(top.x(), -side, -height);
    mesh.vertices.emplace_back(top.x(), side, -height);
    mesh.vertices.emplace_back(top.x(), side, top.y());
    mesh.vertices.emplace_back(top.x(), -side, top.y());
  }
  const auto add_face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  const auto last = static_cast<std::uint32_t>(kCorners * (tops.size() - 1));
  add_face(0, 3, 2, 1);
  for (std::uint32_t section = 0; section < last; section += kCorners) {
    for (std::uint32_t corner = 0; corner < kCorners; ++corner) {
      const std::uint32_t next = (corner + 1) % kCorners;
      add_face(section + corner, section + next, section + kCorners + next,
               section + kCorners + corner);
    }
  }
  add_face(last, last + 1, last + 2, last + 3);
  return mesh;
}

}  // namespace

Result<Mesh, std::string> make_bed(const Sizes& sizes, const ShapeProfile& profile) {
  const double length = sizes.at("length");
  const double height = sizes.at("height");
  const auto rows = errors_along(profile, length, height);
  if (!rows) {
    return rows.error();
  }
  return bar(rows.value(), sizes.at("width"), height);
}

Result<Mesh, std::string> make_shaft(const Sizes& sizes, const ShapeProfile& profile) {
  const double radius = 0.5 * sizes.at("diameter");
  const double height = sizes.at("height");
  const auto rows = errors_along(profile, height, radius);
  if (!rows) {
    return rows.error();
  }
  const auto by_error = [](const Point2& a, const Point2& b) { return a.y() < b.y(); };
  const double largest = radius + std::ranges::max_element(rows.value(), by_error)->y();
  const auto facets =
      sides_within(largest, sizes.at("sagitta"), kMostShaftFacets / (rows.value().size() + 2));
  if (!facets) {
    return std::string(
        "the sagitta of the shaft is too small: it would take more than 2000000 facets");
  }
  std::vector<Point2> outline = {Point2(0.0, 0.0)};
  for (const Point2& row : rows.value()) {
    outline.emplace_back(radius + row.y(), -row.x());
  }
  outline.emplace_back(0.0, -height);
  return revolved(outline, *facets);
}

}  // namespace g31::parts
