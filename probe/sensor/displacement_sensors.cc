#include "probe/sensor/displacement_sensors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "machine/base/contract.h"
#include "machine/base/random.h"
#include "probe/contact/first_surface.h"

namespace g31::probe {
namespace {

/// The first of the streams of random numbers that sensors take, one each.
constexpr std::uint32_t kFirstStream = 0x53454E00U;

constexpr int kRings = 4;
constexpr int kRaysOnRing = 12;

}  // namespace

DisplacementSensors::DisplacementSensors(std::vector<DisplacementSetup> sensors,
                                         std::shared_ptr<const SeenParts> parts, std::uint64_t seed)
    : sensors_(std::move(sensors)), parts_(std::move(parts)), seed_(seed) {}

const DisplacementSetup* DisplacementSensors::find(int input) const {
  const auto found = std::ranges::find(sensors_, input, &DisplacementSetup::input);
  return found != sensors_.end() ? &*found : nullptr;
}

std::optional<Point> DisplacementSensors::place(int input) const {
  const DisplacementSetup* const sensor = find(input);
  return sensor != nullptr ? std::optional(sensor->p_T_at) : std::nullopt;
}

double DisplacementSensors::distance(const Point& from, const Point& along, double range_mm) const {
  double nearest = range_mm;
  if (parts_ == nullptr) {
    return nearest;
  }
  for (const auto& part : *parts_) {
    nearest = first_surface(*part, {from, along, nearest}).value_or(nearest);
  }
  return nearest;
}

/// Rings of equal shares of the disc, each through the middle of its share: a mean over them is
/// exact for surfaces that are flat or bent evenly.
double DisplacementSensors::distance_over_spot(const DisplacementSetup& sensor,
                                               const machine::Waypoint& at) const {
  const Point from = linear_axes(at.q_M) + sensor.p_T_at;
  const Point tilted = at.tilt * sensor.along_T;
  const Point along =
      at.lean_rad.isZero(0.0) ? tilted : Point(tilted + at.lean_rad.cross(tilted)).normalized();
  if (sensor.spot_mm == 0.0) {
    return distance(from, along, sensor.range_mm);
  }
  const Point right = along.unitOrthogonal();
  const Point up = along.cross(right);
  double sum = 0.0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double radius = 0.5 * sensor.spot_mm * std::sqrt((ring + 0.5) / kRings);
    for (int ray = 0; ray < kRaysOnRing; ++ray) {
      const double angle = 2.0 * std::numbers::pi * (ray + 0.5 * (ring % 2)) / kRaysOnRing;
      const Point beside = radius * (std::cos(angle) * right + std::sin(angle) * up);
      sum += distance(from + beside, along, sensor.range_mm);
    }
  }
  return sum / (kRings * kRaysOnRing);
}

double DisplacementSensors::reading(int input, const machine::Waypoint& at, double now_s) const {
  const DisplacementSetup* const sensor = find(input);
  G31_EXPECTS(sensor != nullptr);
  double reading = distance_over_spot(*sensor, at);
  if (sensor->noise_mm > 0.0) {
    const Stream stream{seed_, kFirstStream + static_cast<std::uint32_t>(input)};
    reading += sensor->noise_mm * standard_normal(stream, std::bit_cast<std::uint64_t>(now_s));
  }
  if (sensor->resolution_mm > 0.0) {
    reading = sensor->resolution_mm * std::round(reading / sensor->resolution_mm);
  }
  return reading;
}

}  // namespace g31::probe
