#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/port/way.h"
#include "probe/contact/contact_mesh.h"
#include "probe/sensor/bodies.h"

namespace g31::probe {

/// One `[[sensor]]` of the set-up sheet; lengths in mm.
struct DisplacementSetup {
  std::string name;
  int input = 1;                    ///< analog input that it is wired to, from 1
  Point p_T_at = Point::Zero();     ///< from the gauge point, axes of the machine
  Point along_T = -Point::UnitZ();  ///< unit vector that it looks along
  double range_mm = 10.0;           ///< > 0: what it reads when nothing is nearer
  double resolution_mm = 0.0;       ///< >= 0: readings are whole multiples; 0: no steps
  double spot_mm = 0.0;             ///< >= 0, diameter of what it averages; 0: a ray
  double noise_mm = 0.0;            ///< >= 0, standard deviation
};

/// The parts as displacement sensors see them, none null.  Immutable: sensors on any number of
/// threads share it, and the meshes with a probe.
using SeenParts = std::vector<std::shared_ptr<const ContactMesh>>;

/// Displacement sensors that ride with the spindle and read how far away the parts are.
///
/// A reading is the distance from the sensor along its direction to the nearest surface; over a
/// spot the mean of 48 rays, each at most the range, whose mean square distance from the middle is
/// that of the disc.  The noise belongs to the moment: looking twice at one time reads the same.
class DisplacementSensors {
 public:
  /// @param parts  null: nothing is there
  /// @param seed  of the noise
  DisplacementSensors(std::vector<DisplacementSetup> sensors,
                      std::shared_ptr<const SeenParts> parts, std::uint64_t seed);

  /// Where the sensor of an input is, mm from the gauge point; nullopt: there is none.
  [[nodiscard]] std::optional<Point> place(int input) const;

  /// mm, from 0 to the range, noise apart.  @pre the input has a sensor
  /// @param at  the linear axes that bring the sensor where it is, and how it is turned about
  /// itself
  /// @param now_s  since the start of the program
  [[nodiscard]] double reading(int input, const machine::Waypoint& at, double now_s) const;

 private:
  [[nodiscard]] const DisplacementSetup* find(int input) const;
  [[nodiscard]] double distance(const Point& from, const Point& along, double range_mm) const;
  [[nodiscard]] double distance_over_spot(const DisplacementSetup& sensor,
                                          const machine::Waypoint& at) const;

  std::vector<DisplacementSetup> sensors_;
  std::shared_ptr<const SeenParts> parts_;
  std::uint64_t seed_;
};

}  // namespace g31::probe
