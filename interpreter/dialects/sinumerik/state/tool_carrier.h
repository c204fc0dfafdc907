#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "interpreter/dialects/sinumerik/state/failure.h"
#include "machine/base/result.h"
#include "machine/kinematics/kinematic_vectors.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {

/// $TC_CARR1 to 65 of one tool carrier: what the control believes of rotary axes.
struct ToolCarrier {
  static constexpr std::size_t kAngle1 = 13;        ///< to 14: where 21 and 22 name no axis
  static constexpr std::size_t kBasic1 = 24;        ///< to 25
  static constexpr std::size_t kHirthOffset1 = 26;  ///< to 27
  static constexpr std::size_t kLower1 = 30;        ///< to 31
  static constexpr std::size_t kUpper1 = 32;        ///< to 33
  static constexpr std::size_t kName = 34;
  static constexpr std::size_t kFineBasic1 = 64;  ///< to 65
  static constexpr std::size_t kLast = 65;

  std::array<double, kLast + 1> numbers = {};  ///< mm and deg, by n
  std::array<int, 2> axes = {-1, -1};          ///< 21 and 22: storage indices; -1: none
  std::string kind = "T";                      ///< 23
  std::array<std::string, 3> names;            ///< 34 to 36

  /// What the vectors and fine offsets come to; alarm 14153 for a kind that there is not.
  [[nodiscard]] Result<machine::KinematicVectors, Failure> vectors(bool with_fine) const;
  /// The position of axis 1 or 2 at which its angle is 0.  @param i  0 or 1
  [[nodiscard]] double basic_position(std::size_t i, bool with_fine) const;
  bool operator==(const ToolCarrier&) const = default;
};

/// The data of a machine; its travel goes into the limits.  @param travel  of axes 1 and 2
ToolCarrier carrier_of(const machine::KinematicVectors& vectors,
                       const std::array<machine::RotaryTravel, 2>& travel);

/// What TCARR and TRAORI have made of the rotary axes.
struct Orientation {
  int carrier = 0;                       ///< TCARR; 0: none
  machine::KinematicVectors vectors;     ///< of the carrier when it was selected
  std::array<double, 2> deg = {};        ///< its angles in force
  std::array<double, 2> basic_deg = {};  ///< positions of its axes where the angles are 0

  // What the last TCOFR found.
  std::array<double, 4> found_deg = {};  ///< positions of both axes, of both solutions
  int solutions = 0;
  int free_axes = 0;  ///< bit 0: axis 1, bit 1: axis 2

  int transformation = 0;                        ///< TRAORI; 0: none
  machine::KinematicVectors traori_vectors;      ///< when it was switched on
  std::optional<machine::VectorChain> chain;     ///< of TRAORI
  std::optional<machine::OrientationAxes> axes;  ///< of TRAORI
  std::array<double, 2> traori_basic_deg = {};
  std::array<double, 2> traori_offsets_deg = {};  ///< what the call has added to them
  /// Of TRAORI: how the tool lies where all angles are 0, of length 1; nullopt: square to the
  /// plane.
  std::optional<Eigen::Vector3d> basic_direction;

  /// The same, whether TRAORI or a carrier turns the tool.  @param normal  of the plane
  [[nodiscard]] Eigen::Vector3d upright(int normal) const {
    return chain && basic_direction ? *basic_direction
                                    : Eigen::Vector3d(Eigen::Vector3d::Unit(normal));
  }

  bool operator==(const Orientation&) const = default;
};

/// The rotary axes of vectors as what brings the tool to a direction; nullopt: parallel, or one has
/// no direction.
std::optional<machine::OrientationAxes> orientation_of(const machine::KinematicVectors& vectors);

}  // namespace g31::sinumerik
