#include "probe/contact/way_distance.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "probe/contact/contact_triangle.h"

namespace g31::probe {
namespace {

/// The least distance of a triangle from the way.
double least_distance(const ContactTriangle& triangle, const Point& p_from, const Point& p_to) {
  // A distance that is 0 on a piece has its flat part between the sections all the same.
  constexpr int kSections = 60;
  constexpr double kGolden = std::numbers::phi - 1.0;
  const auto at = [&](double share) {
    return nearest_of(triangle, p_from + share * (p_to - p_from)).distance;
  };
  double low = 0.0;
  double high = 1.0;
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double at_left = at(left);
  double at_right = at(right);
  for (int i = 0; i < kSections; ++i) {
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = at(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = at(right);
    }
  }
  return std::min({at_left, at_right, at(0.0), at(1.0)});
}

}  // namespace

double distance_of_way(const parts::Mesh& mesh, const Point& p_from, const Point& p_to) {
  const double length = (p_to - p_from).norm();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const ContactTriangle triangle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    const double from = nearest_of(triangle, p_from).distance;
    const double to = nearest_of(triangle, p_to).distance;
    if (0.5 * (from + to - length) < least) {
      least = std::min(least, least_distance(triangle, p_from, p_to));
    }
  }
  return least;
}

}  // namespace g31::probe
