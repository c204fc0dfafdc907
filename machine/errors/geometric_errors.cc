#include "machine/errors/geometric_errors.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace g31::errors {
namespace {

constexpr double kRadPerMicrometrePerMetre = 1e-6;

/// um/m
Point turn_of(const std::array<ErrorTable, 6>& errors, double place) {
  return {errors[3].at(place), errors[4].at(place), errors[5].at(place)};
}

}  // namespace

GeometricErrors::GeometricErrors(const GeometricErrorSetup& setup) : setup_(setup) {}

Point GeometricErrors::at(const Point& p_M, const Point& arm_M) const {
  Point sum_M = Point::Zero();
  // From the tool back to the part: the arm of an axis is what follows it.
  Point following_M = arm_M;
  for (std::size_t i = setup_.part_to_tool.size(); i-- > 0;) {
    const int axis = setup_.part_to_tool[i];
    const auto& errors = setup_.along[static_cast<std::size_t>(axis)];
    const double place = p_M[axis];
    const Point shift_M(errors[0].at(place), errors[1].at(place), errors[2].at(place));
    sum_M += shift_M + kRadPerMicrometrePerMetre * turn_of(errors, place).cross(following_M);
    following_M[axis] += place;
  }
  const Point skew_M(-setup_.c0y * p_M.y() + setup_.b0z * p_M.z(), -setup_.a0z * p_M.z(), 0.0);
  return sum_M + kRadPerMicrometrePerMetre * skew_M;
}

Point GeometricErrors::turn_at(const Point& p_M) const {
  Point sum_M = Point::Zero();
  for (const int axis : setup_.part_to_tool) {
    sum_M += turn_of(setup_.along[static_cast<std::size_t>(axis)], p_M[axis]);
  }
  return kRadPerMicrometrePerMetre * sum_M;
}

bool GeometricErrors::are_zero() const {
  const bool straight = setup_.c0y == 0.0 && setup_.b0z == 0.0 && setup_.a0z == 0.0;
  return straight && std::ranges::all_of(setup_.along, [](const auto& errors) {
           return std::ranges::all_of(errors, &ErrorTable::is_zero);
         });
}

}  // namespace g31::errors
