#include "interpreter/dialects/fanuc/state/work_transform.h"

#include "interpreter/runtime/angles.h"
#include "machine/base/contract.h"

namespace g31::fanuc {

WorkTransform WorkTransform::mirror(int axis, double at) {
  WorkTransform map;
  map.linear_(axis, axis) = -1.0;
  map.inverse_(axis, axis) = -1.0;
  map.offset_[axis] = 2.0 * at;
  map.judge_identity();
  return map;
}

WorkTransform WorkTransform::scaling(const Point& centre, const Point& factors) {
  WorkTransform map;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    G31_EXPECTS(factors[axis] != 0.0);
    map.linear_(axis, axis) = factors[axis];
    map.inverse_(axis, axis) = 1.0 / factors[axis];
    map.offset_[axis] = centre[axis] * (1.0 - factors[axis]);
  }
  map.judge_identity();
  return map;
}

WorkTransform WorkTransform::rotation(const Plane& plane, const Eigen::Vector2d& centre,
                                      double angle_deg) {
  const double cosine = runtime::cosine_deg(angle_deg);
  const double sine = runtime::sine_deg(angle_deg);
  WorkTransform map;
  map.linear_(plane.first, plane.first) = cosine;
  map.linear_(plane.first, plane.second) = -sine;
  map.linear_(plane.second, plane.first) = sine;
  map.linear_(plane.second, plane.second) = cosine;
  map.inverse_ = map.linear_.transpose();
  map.offset_[plane.first] = centre.x() - cosine * centre.x() + sine * centre.y();
  map.offset_[plane.second] = centre.y() - sine * centre.x() - cosine * centre.y();
  map.judge_identity();
  return map;
}

WorkTransform WorkTransform::then(const WorkTransform& next) const {
  WorkTransform both;
  both.linear_ = next.linear_ * linear_;
  both.inverse_ = inverse_ * next.inverse_;
  both.offset_ = next.apply(offset_);
  both.judge_identity();
  return both;
}

bool WorkTransform::reverses_turns(const Plane& plane) const {
  const double along = linear_(plane.first, plane.first) * linear_(plane.second, plane.second);
  const double across = linear_(plane.first, plane.second) * linear_(plane.second, plane.first);
  return along < across;
}

void WorkTransform::judge_identity() {
  is_identity_ = linear_ == Matrix::Identity() && offset_ == AxisPositions::Zero();
}

WorkTransform TransformStages::before_scaling() const {
  WorkTransform map;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (mirrored_at[axis]) {
      map = map.then(WorkTransform::mirror(static_cast<int>(axis), *mirrored_at[axis]));
    }
  }
  return map;
}

WorkTransform TransformStages::before_rotation() const {
  const WorkTransform map = before_scaling();
  return scaling ? map.then(WorkTransform::scaling(scaling->centre, scaling->factors)) : map;
}

WorkTransform TransformStages::all() const {
  const WorkTransform map = before_rotation();
  return rotation ? map.then(WorkTransform::rotation(rotation->plane, rotation->centre,
                                                     rotation->angle_deg))
                  : map;
}

}  // namespace g31::fanuc
