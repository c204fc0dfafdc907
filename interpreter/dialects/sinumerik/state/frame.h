#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "interpreter/dialects/sinumerik/vocabulary/frame_components.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {

/// A FRAME: positions of an inner system in terms of the outer one.  It mirrors and scales, then
/// turns, then shifts; only X, Y and Z turn.  U, V and W stand for themselves, one by one.
class Frame {
 public:
  /// Inner to outer, and back.
  [[nodiscard]] AxisPositions apply(const AxisPositions& q) const;
  [[nodiscard]] AxisPositions undo(const AxisPositions& q) const;
  /// The same of U, V or W.
  [[nodiscard]] double apply(int further_axis, double place) const;
  [[nodiscard]] double undo(int further_axis, double place) const;

  /// This frame : inner.
  [[nodiscard]] Frame chained(const Frame& inner) const;
  [[nodiscard]] Frame inverse() const;

  /// mm, degrees, factors, 0 or 1.
  [[nodiscard]] double component(int axis, Component component) const;
  void set_component(int axis, Component component, double value);
  /// Whether a component may have this value: a factor of 0 has no way back.
  [[nodiscard]] static bool takes(Component component, double value);
  /// Whether the frame as a whole, chained of others, has values that components may have.
  [[nodiscard]] bool is_within_limits() const;

  /// Degrees about X, Y and Z: turned about Z, then the new Y, then the new X (RPY).
  [[nodiscard]] Eigen::Vector3d angles() const;
  void set_angles(const Eigen::Vector3d& degrees);
  /// Turned by two solid angles, degrees: the new plane is that of the axis `first`, turned about
  /// the next one in the circle X Y Z, and of that one, turned about `first`; `first` stays in the
  /// old plane of itself and the third axis.
  void set_solid_angles(int first, double about_first, double about_second);
  /// The rotation alone.
  [[nodiscard]] const Eigen::Matrix3d& turn() const { return turn_; }
  /// The rotation and the mirror: where a direction comes to, scales apart.
  [[nodiscard]] Eigen::Matrix3d directions() const {
    return turn_ * mirror_.head<kLinearAxisCount>().asDiagonal();
  }
  void set_turn(const Eigen::Matrix3d& turn) { turn_ = turn; }
  /// Shifted further along its own axes, by the shift of a frame; the fine shift takes it.
  void add_fine_shift(const Frame& shift);

  /// Every component is the same.
  friend bool operator==(const Frame& a, const Frame& b);

 private:
  /// One of U, V and W.
  struct Single {
    double coarse = 0.0;
    double fine = 0.0;
    double scale = 1.0;
    double mirror = 1.0;
    friend bool operator==(const Single&, const Single&) = default;
    [[nodiscard]] double factor() const { return scale * mirror; }
    [[nodiscard]] double shift() const { return coarse + fine; }
    [[nodiscard]] Single chained(const Single& inner) const;
    [[nodiscard]] double component(Component component) const;
    void set_component(Component component, double value);
  };

  [[nodiscard]] AxisPositions factors() const;
  [[nodiscard]] const Single& single(int further_axis) const {
    return further_[static_cast<std::size_t>(further_axis - kFirstFurtherAxis)];
  }

  AxisPositions coarse_ = AxisPositions::Zero();
  AxisPositions fine_ = AxisPositions::Zero();
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
  AxisPositions scale_ = AxisPositions::Ones();
  AxisPositions mirror_ = AxisPositions::Ones();  ///< -1 where mirrored
  std::array<Single, kFurtherAxes.size()> further_;
};

}  // namespace g31::sinumerik
