#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include <Eigen/Core>

#include "machine/kinematics/axis_chain.h"

namespace g31::machine {

/// What the rotary axes of a machine turn.
enum class KinematicType {
  Tool,  ///< the tool: one or two axes in the head
  Part,  ///< the part: one or two axes in the table
  Mixed  ///< one each
};

/// Positions of rotary axes 1 and 2 that bring the tool to a direction.
struct RotaryPair {
  std::array<double, 2> deg = {0.0, 0.0};  ///< in (-180, 180]; 0 where there is no such axis
  /// Any position does: at a pole, or where the axis does not turn the tool against the part.
  std::array<bool, 2> is_free = {false, false};
};

/// None, one or both.
struct RotaryPairs {
  std::array<RotaryPair, 2> all;
  std::size_t count = 0;

  [[nodiscard]] const RotaryPair* begin() const { return all.data(); }
  [[nodiscard]] const RotaryPair* end() const { return all.data() + count; }
};

/// The rotary axes of a machine as what brings the tool to a direction.
///
/// Axis 2 is the one that axis 1 carries; with one of each kind axis 1 turns the tool.
class OrientationAxes {
 public:
  /// nullopt: no rotary axis, more than two, or two that are parallel.
  static std::optional<OrientationAxes> of(const AxisChainSetup& chain);

  /// Of axes whose directions are given, when all stand at 0.
  /// @param axes       storage indices; -1 for an axis 2 that there is not
  /// @param direction  ISO sense: a positive angle turns the tool right-handed for the part
  OrientationAxes(KinematicType type, const std::array<int, 2>& axes,
                  const std::array<Point, 2>& direction);

  [[nodiscard]] KinematicType type() const { return type_; }
  [[nodiscard]] std::size_t count() const { return axes_[1] < 0 ? 1 : 2; }
  /// Storage indices of axes 1 and 2; -1 where there is none.
  [[nodiscard]] const std::array<int, 2>& axes() const { return axes_; }

  /// How the tool is turned against the part.
  [[nodiscard]] Eigen::Matrix3d turn(const std::array<double, 2>& deg) const;

  /// All pairs that bring the tool to a direction.  Two pairs that are nearer to each other than
  /// about 1e-6 rad count as one, and a direction that is out of reach by so much as reached.
  /// @param d_P  the direction from tip to holder in the part, of any length > 0
  /// @param d_T  the same with all axes at 0
  [[nodiscard]] RotaryPairs pairs_for(const Point& d_P, const Point& d_T = Point::UnitZ()) const;

  bool operator==(const OrientationAxes&) const = default;

 private:
  [[nodiscard]] RotaryPairs single(std::size_t axis, const Point& d_P, const Point& d_T) const;

  KinematicType type_;
  std::array<int, 2> axes_;
  std::array<Point, 2> direction_;
};

/// How far a rotary axis goes.
struct RotaryTravel {
  double lower = -std::numeric_limits<double>::infinity();  ///< deg
  double upper = std::numeric_limits<double>::infinity();
};

/// The position of an axis that differs from `angle` by whole turns, lies within the travel and
/// is nearest to `from`; of two as near the one nearer to 0.  nullopt: none lies within.
std::optional<double> turn_within(double angle, double from, const RotaryTravel& travel);

/// The pair that the axes reach with the least motion; a free axis stays.
///
/// The axis that comes first moves least; of equal ones the other axis moves least; of those the
/// one that ends with the first axis nearest to 0, then with the other.  Source: FANUC A-78712E
/// p. 1380.
/// @param from   where the axes stand
/// @param first  0: axis 1 comes first, 1: axis 2
std::optional<RotaryPair> least_motion(const RotaryPairs& pairs, const std::array<double, 2>& from,
                                       const std::array<RotaryTravel, 2>& travel,
                                       std::size_t first);

/// The nearest position that a Hirth coupling has: `offset` + k `pitch`.
/// @param pitch  deg; 0: no coupling
double on_tooth(double angle, double offset, double pitch);

}  // namespace g31::machine
