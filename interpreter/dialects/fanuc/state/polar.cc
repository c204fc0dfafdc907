#include "interpreter/dialects/fanuc/state/polar.h"

#include <cmath>
#include <numbers>

#include "interpreter/runtime/angles.h"

namespace g31::fanuc {

PolarCoordinates PolarCoordinates::about_origin(const Eigen::Vector2d& p_L_present) {
  PolarCoordinates polar;
  polar.radius_ = p_L_present.norm();
  polar.angle_deg_ = std::atan2(p_L_present.y(), p_L_present.x()) * 180.0 / std::numbers::pi;
  return polar;
}

PolarCoordinates PolarCoordinates::about(const Eigen::Vector2d& p_L_present) {
  PolarCoordinates polar;
  polar.p_L_pole_ = p_L_present;
  return polar;
}

void PolarCoordinates::set_radius(double radius) {
  p_L_pole_.setZero();
  radius_ = radius;
}

void PolarCoordinates::add_radius(double radius, const Eigen::Vector2d& p_L_present) {
  p_L_pole_ = p_L_present;
  radius_ = radius;
}

Eigen::Vector2d PolarCoordinates::point() const {
  return p_L_pole_ +
         radius_ * Eigen::Vector2d(runtime::cosine_deg(angle_deg_), runtime::sine_deg(angle_deg_));
}

}  // namespace g31::fanuc
