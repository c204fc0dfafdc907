#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "interpreter/dialects/fanuc/vocabulary/plane.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {

/// An affine map of work coordinates and its inverse: what programmable mirror, scaling and
/// rotation make of a point as the program writes it (frame L, local) on its way to work
/// coordinates (W).
///
/// mm and deg.  Each maker gives the closed form of its inverse, and `then` composes both sides, so
/// undo(apply(q)) differs from q by rounding only.
class WorkTransform {
 public:
  /// Every point stays where it is.
  WorkTransform() = default;

  /// One axis mirrored at a coordinate.
  static WorkTransform mirror(int axis, double at);
  /// X Y Z enlarged about a centre; a factor below 0 mirrors too.  @param factors  none is 0
  static WorkTransform scaling(const Point& centre, const Point& factors);
  /// The axes of a plane turned counterclockwise about a centre.
  static WorkTransform rotation(const Plane& plane, const Eigen::Vector2d& centre,
                                double angle_deg);

  /// This map first, then `next`.
  [[nodiscard]] WorkTransform then(const WorkTransform& next) const;

  [[nodiscard]] AxisPositions apply(const AxisPositions& q_L) const {
    return is_identity_ ? q_L : AxisPositions(linear_ * q_L + offset_);
  }
  [[nodiscard]] AxisPositions undo(const AxisPositions& q_W) const {
    return is_identity_ ? q_W : AxisPositions(inverse_ * (q_W - offset_));
  }

  /// How much longer a way along the axis becomes; > 0.
  [[nodiscard]] double stretch(int axis) const {
    return is_identity_ ? 1.0 : linear_.col(axis).norm();
  }
  /// Whether a clockwise arc of the plane becomes a counterclockwise one.
  [[nodiscard]] bool reverses_turns(const Plane& plane) const;
  [[nodiscard]] bool is_identity() const { return is_identity_; }

  bool operator==(const WorkTransform&) const = default;

 private:
  void judge_identity();

  using Matrix = Eigen::Matrix<double, static_cast<int>(kAxisCount), static_cast<int>(kAxisCount)>;

  Matrix linear_ = Matrix::Identity();
  Matrix inverse_ = Matrix::Identity();
  AxisPositions offset_ = AxisPositions::Zero();
  bool is_identity_ = true;  // as nearly every point goes through
};

/// G51 in force.
struct Scaling {
  Point centre = Point::Zero();  ///< mm, behind the mirror
  Point factors = Point::Ones();

  bool operator==(const Scaling&) const = default;
};

/// G68 in force.
struct Rotation {
  Plane plane;
  Eigen::Vector2d centre;  ///< mm, behind mirror and scaling
  double angle_deg;        ///< behind mirror and scaling

  bool operator==(const Rotation&) const = default;
};

/// The three maps a program can have in force, in the order in which the control applies them:
/// mirror (G51.1), scaling (G51), rotation (G68).
struct TransformStages {
  std::array<std::optional<double>, kAxisCount> mirrored_at;  ///< by axis
  std::optional<Scaling> scaling;
  std::optional<Rotation> rotation;
  double angle_deg = 0.0;  ///< of the last G68, as the program has it
  /// Of G68 with I J K, which the plane of the coordinates is of then; work coordinates.
  std::optional<Point> space_centre;

  /// Whether another plane than this one is turned.
  [[nodiscard]] bool turns_other_than(const Plane& plane) const {
    return rotation && rotation->plane.across != plane.across;
  }

  /// The mirror: what the centre of scaling goes through as well.
  [[nodiscard]] WorkTransform before_scaling() const;
  /// Mirror and scaling: what the centre of a rotation goes through as well.
  [[nodiscard]] WorkTransform before_rotation() const;
  [[nodiscard]] WorkTransform all() const;

  bool operator==(const TransformStages&) const = default;
};

}  // namespace g31::fanuc
