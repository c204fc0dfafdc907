#include "interpreter/dialects/sinumerik/state/frame.h"

#include <cmath>

#include <Eigen/Geometry>

#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "machine/base/contract.h"
#include "machine/units/units.h"

namespace g31::sinumerik {
namespace {

constexpr double kAngleSteps = 1e11;  // per degree

double sine(double degrees) {
  return mathematics(FunctionId::SIN, degrees, 0.0).value_or(0.0);
}
double cosine(double degrees) {
  return mathematics(FunctionId::COS, degrees, 0.0).value_or(0.0);
}

/// About one axis; quarter turns are exact.
Eigen::Matrix3d about(int axis, double degrees) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  turn(a, a) = turn(b, b) = cosine(degrees);
  turn(b, a) = sine(degrees);
  turn(a, b) = -turn(b, a);
  return turn;
}

/// A way as it is outside: scaled, mirrored and turned, not shifted.
AxisPositions outside(const AxisPositions& way, const AxisPositions& factors,
                      const Eigen::Matrix3d& turn) {
  AxisPositions outer = factors.cwiseProduct(way);
  if (!turn.isIdentity(0.0)) {
    outer.head<3>() = (turn * outer.head<3>()).eval();
  }
  return outer;
}

}  // namespace

AxisPositions Frame::factors() const {
  return scale_.cwiseProduct(mirror_);
}

Frame::Single Frame::Single::chained(const Single& inner) const {
  return {coarse + factor() * inner.coarse, fine + factor() * inner.fine, scale * inner.scale,
          mirror * inner.mirror};
}

double Frame::Single::component(Component component) const {
  switch (component) {
    case Component::Coarse:
      return coarse;
    case Component::Fine:
      return fine;
    case Component::Rotation:
      return 0.0;
    case Component::Scale:
      return scale;
    case Component::Mirror:
      return mirror < 0.0 ? 1.0 : 0.0;
  }
  contract_violated("every component has a value", __FILE__, __LINE__);
}

void Frame::Single::set_component(Component component, double value) {
  switch (component) {
    case Component::Coarse:
      coarse = value;
      return;
    case Component::Fine:
      fine = value;
      return;
    case Component::Rotation:
      return;
    case Component::Scale:
      scale = value;
      return;
    case Component::Mirror:
      mirror = value != 0.0 ? -1.0 : 1.0;
      return;
  }
}

double Frame::apply(int further_axis, double place) const {
  const Single& one = single(further_axis);
  return one.factor() * place + one.shift();
}

double Frame::undo(int further_axis, double place) const {
  const Single& one = single(further_axis);
  return (place - one.shift()) / one.factor();
}

AxisPositions Frame::apply(const AxisPositions& q) const {
  return outside(q, factors(), turn_) + coarse_ + fine_;
}

AxisPositions Frame::undo(const AxisPositions& q) const {
  AxisPositions inner = q - coarse_ - fine_;
  if (!turn_.isIdentity(0.0)) {
    inner.head<3>() = turn_.inverse() * inner.head<3>().eval();
  }
  return inner.cwiseQuotient(factors());
}

Frame Frame::chained(const Frame& inner) const {
  Frame all;
  all.coarse_ = coarse_ + outside(inner.coarse_, factors(), turn_);
  all.fine_ = fine_ + outside(inner.fine_, factors(), turn_);
  const Eigen::Vector3d mine = factors().head<3>();
  all.turn_ = turn_ * mine.asDiagonal() * inner.turn_ * mine.cwiseInverse().asDiagonal();
  all.scale_ = scale_.cwiseProduct(inner.scale_);
  all.mirror_ = mirror_.cwiseProduct(inner.mirror_);
  for (std::size_t i = 0; i < further_.size(); ++i) {
    all.further_[i] = further_[i].chained(inner.further_[i]);
  }
  return all;
}

Frame Frame::inverse() const {
  Frame back;
  back.coarse_ = undo(AxisPositions::Zero());
  const Eigen::Vector3d mine = factors().head<3>();
  back.turn_ = mine.cwiseInverse().asDiagonal() * turn_.inverse() * mine.asDiagonal();
  back.scale_ = scale_.cwiseInverse();
  back.mirror_ = mirror_;
  for (std::size_t i = 0; i < further_.size(); ++i) {
    const Single& one = further_[i];
    back.further_[i] = {-one.shift() / one.factor(), 0.0, 1.0 / one.scale, one.mirror};
  }
  return back;
}

/// Where Y is 90 or -90 only the sum of the other two shows: it is read as Z (function manual K2,
/// 6FC5397-0BP10-0BA0, page 2-44).
Eigen::Vector3d Frame::angles() const {
  constexpr double kUpright = 1e-10;  // cosine of Y
  const double cosine_y = std::hypot(turn_(0, 0), turn_(1, 0));
  const double y = std::atan2(-turn_(2, 0), cosine_y);
  const bool is_upright = cosine_y < kUpright;
  const double x = is_upright ? 0.0 : std::atan2(turn_(2, 1), turn_(2, 2));
  const double z =
      is_upright ? std::atan2(-turn_(0, 1), turn_(1, 1)) : std::atan2(turn_(1, 0), turn_(0, 0));
  return Eigen::Vector3d(x, y, z) * (180.0 / std::numbers::pi);
}

void Frame::set_angles(const Eigen::Vector3d& degrees) {
  turn_ = about(2, degrees.z()) * about(1, degrees.y()) * about(0, degrees.x());
}

void Frame::set_solid_angles(int first, double about_first, double about_second) {
  const int second = (first + 1) % 3;
  const int third = (first + 2) % 3;
  turn_.col(first) = about(second, about_second).col(first);
  const Eigen::Vector3d trace = about(first, about_first).col(second);
  turn_.col(third) = Eigen::Vector3d(turn_.col(first)).cross(trace).normalized();
  turn_.col(second) = Eigen::Vector3d(turn_.col(third)).cross(Eigen::Vector3d(turn_.col(first)));
}

void Frame::add_fine_shift(const Frame& shift) {
  fine_ += outside(shift.apply(AxisPositions::Zero()), factors(), turn_);
  for (std::size_t i = 0; i < further_.size(); ++i) {
    further_[i].fine += further_[i].factor() * shift.further_[i].shift();
  }
}

bool operator==(const Frame& a, const Frame& b) {
  constexpr Component kAll[] = {Component::Coarse, Component::Fine, Component::Rotation,
                                Component::Scale, Component::Mirror};
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    for (const Component component : kAll) {
      if (a.component(axis, component) != b.component(axis, component)) {
        return false;
      }
    }
  }
  return a.further_ == b.further_;
}

double Frame::component(int axis, Component component) const {
  if (is_further_axis(axis)) {
    return single(axis).component(component);
  }
  switch (component) {
    case Component::Coarse:
      return coarse_[axis];
    case Component::Fine:
      return fine_[axis];
    case Component::Rotation:
      // The control keeps angles, this frame a matrix: 45 is to be read as 45.
      return is_linear_axis(axis) ? std::round(angles()[axis] * kAngleSteps) / kAngleSteps : 0.0;
    case Component::Scale:
      return scale_[axis];
    case Component::Mirror:
      return mirror_[axis] < 0.0 ? 1.0 : 0.0;
  }
  contract_violated("every component has a value", __FILE__, __LINE__);
}

bool Frame::takes(Component component, double value) {
  constexpr double kLeastFactor = 1e-6;
  constexpr double kMostFactor = 1e6;
  const double size = std::abs(value);
  return component == Component::Scale ? size >= kLeastFactor && size <= kMostFactor
                                       : size <= kFarthestPlace;
}

bool Frame::is_within_limits() const {
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    if (!takes(Component::Coarse, coarse_[axis]) || !takes(Component::Fine, fine_[axis]) ||
        !takes(Component::Scale, scale_[axis])) {
      return false;
    }
  }
  for (const Single& one : further_) {
    if (!takes(Component::Coarse, one.coarse) || !takes(Component::Fine, one.fine) ||
        !takes(Component::Scale, one.scale)) {
      return false;
    }
  }
  return turn_.allFinite();
}

void Frame::set_component(int axis, Component component, double value) {
  if (is_further_axis(axis)) {
    further_[static_cast<std::size_t>(axis - kFirstFurtherAxis)].set_component(component, value);
    return;
  }
  switch (component) {
    case Component::Coarse:
      coarse_[axis] = value;
      return;
    case Component::Fine:
      fine_[axis] = value;
      return;
    case Component::Rotation:
      if (is_linear_axis(axis)) {
        Eigen::Vector3d degrees = angles();
        degrees[axis] = value;
        set_angles(degrees);
      }
      return;
    case Component::Scale:
      scale_[axis] = value;
      return;
    case Component::Mirror:
      mirror_[axis] = value != 0.0 ? -1.0 : 1.0;
      return;
  }
}

}  // namespace g31::sinumerik
