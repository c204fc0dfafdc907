#include "probe/planning/drawn_size.h"

#include <algorithm>
#include <cmath>

namespace g31::probe {
namespace {

constexpr double kOnFaceMm = 1e-6;

bool is_on(const parts::RemovedFace& face, const Point& p_P) {
  if (face.surface == parts::FaceSurface::Plane) {
    return std::abs((p_P - face.at_P).dot(face.normal_P)) < kOnFaceMm;
  }
  if (face.surface != parts::FaceSurface::Cylinder) {
    return false;
  }
  const Point from_axis = p_P - face.axis_at_P;
  const Point out = from_axis - face.axis_P * face.axis_P.dot(from_axis);
  return std::abs(out.norm() - face.radius_mm) < kOnFaceMm;
}

bool is_between(const parts::DrawnDimension& dimension, const Point& first, const Point& second) {
  const auto& faces = dimension.faces;
  const auto has = [&](const Point& p) {
    return std::ranges::any_of(faces, [&p](const auto& face) { return is_on(face, p); });
  };
  const auto planes = static_cast<std::size_t>(
      std::ranges::count(faces, parts::FaceSurface::Plane, &parts::RemovedFace::surface));
  const bool is_distance = planes == 2 && faces.size() == 2;
  const bool is_diameter = planes == 0;
  return (is_distance || is_diameter) && has(first) && has(second);
}

}  // namespace

const parts::DrawnDimension* drawn_between(const std::vector<parts::DrawnDimension>& dimensions,
                                           const PlannedPoint& first, const PlannedPoint& second) {
  const auto found = std::ranges::find_if(dimensions, [&](const auto& dimension) {
    return is_between(dimension, first.at_P, second.at_P);
  });
  return found == dimensions.end() ? nullptr : &*found;
}

}  // namespace g31::probe
