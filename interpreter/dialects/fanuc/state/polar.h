#pragma once

#include <optional>

#include <Eigen/Core>

namespace g31::fanuc {

/// G16: points of the plane by radius and angle (MB-301).  mm and deg, local coordinates (L).
///
/// An absolute radius counts from the work origin, an incremental one from the present point; an
/// absolute angle counts from the first axis, counterclockwise, an incremental one from the angle
/// before.  What a block leaves out stays as it was.
class PolarCoordinates {
 public:
  /// The radius and angle that the present point has about the origin.
  static PolarCoordinates about_origin(const Eigen::Vector2d& p_L_present);
  /// The pole is the present point; radius and angle are 0.
  static PolarCoordinates about(const Eigen::Vector2d& p_L_present);

  void set_radius(double radius);
  void add_radius(double radius, const Eigen::Vector2d& p_L_present);
  void set_angle(double angle_deg) { angle_deg_ = angle_deg; }
  void add_angle(double angle_deg) { angle_deg_ += angle_deg; }

  /// The point that pole, radius and angle make.
  [[nodiscard]] Eigen::Vector2d point() const;

  bool operator==(const PolarCoordinates&) const = default;

 private:
  Eigen::Vector2d p_L_pole_ = Eigen::Vector2d::Zero();
  double radius_ = 0.0;
  double angle_deg_ = 0.0;
};

}  // namespace g31::fanuc
