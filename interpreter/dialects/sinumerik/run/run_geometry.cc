#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/circle_through.h"
#include "interpreter/dialects/sinumerik/execute/point_fit.h"
#include "interpreter/dialects/sinumerik/run/functions.h"

namespace g31::sinumerik {
namespace {

constexpr double kNoFit = -1.0;

bool is_triangle(const VariableView& points) {
  return points.shape.dimensions == 2 && points.shape.size[0] == 3 && points.shape.size[1] == 3;
}

/// The points of an array [3,3], as columns.
Eigen::Matrix3d columns(const VariableView& points) {
  return Eigen::Map<const Eigen::Matrix3d>(points.numbers);
}

}  // namespace

namespace function {

/// CALCDAT(points, n, result)
MaybeFailure circle_of_points(Operands& at, const Op& op, Arguments list) {
  const VariableView points = at.variable(list[0].variable);
  const VariableView result = at.variable(list[2].variable);
  const double count = rounded(at.number(list[1]));
  if (count != 3.0 && count != 4.0) {
    return failure(AlarmId::BadArguments, fmt::format("CALCDAT: {:g} points, not 3 or 4", count));
  }
  const auto used = static_cast<std::size_t>(count);
  const bool fits = points.shape.dimensions == 2 &&
                    points.shape.size[0] >= static_cast<int>(used) && points.shape.size[1] == 2 &&
                    result.shape.count() >= 3;
  if (!fits) {
    return failure(AlarmId::WrongDimension, "CALCDAT: points [n,2] and result [3]");
  }
  std::vector<Eigen::Vector2d> all;
  for (std::size_t i = 0; i < used; ++i) {
    all.emplace_back(points.numbers[2 * i], points.numbers[2 * i + 1]);
  }
  const auto circle = circle_through(all);
  if (circle) {
    const double values[] = {circle->centre.x(), circle->centre.y(), circle->radius};
    for (std::size_t i = 0; i < std::size(values); ++i) {
      if (MaybeFailure wrong = failure(at.store(result, i, values[i]))) {
        return wrong;
      }
    }
  }
  at.number(op.result) = circle ? 1.0 : 0.0;
  return std::nullopt;
}

/// MEAFRAME(ideal, measured, quality)
MaybeFailure measured_frame(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const VariableView ideal = at.variable(list[0].variable);
  const VariableView measured = at.variable(list[1].variable);
  if (!is_triangle(ideal) || !is_triangle(measured)) {
    return failure(AlarmId::WrongDimension, "MEAFRAME: three points each, [3,3]");
  }
  const auto fit = fitted(columns(ideal), columns(measured));
  if (MaybeFailure wrong = at.assign(list[2], fit ? fit->left_over : kNoFit)) {
    return wrong;
  }
  Frame result;
  if (fit) {
    result.set_turn(fit->turn);
    for (int axis = 0; axis < kLinearAxisCount; ++axis) {
      result.set_component(axis, Component::Coarse, channel.stored_datum(axis, fit->shift[axis]));
    }
  }
  at.frame(op.result) = result;
  return std::nullopt;
}

}  // namespace function
}  // namespace g31::sinumerik
