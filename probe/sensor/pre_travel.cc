#include "probe/sensor/pre_travel.h"

#include <cmath>
#include <numbers>

namespace g31::probe {
namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// Whether the touch turns the switch of a mono probe.
bool reaches_mono_switch(const SwitchSetup& setup, const Point& n_S) {
  const double way = radians(setup.mono_direction_deg);
  const double against = -(n_S.x() * std::cos(way) + n_S.y() * std::sin(way));
  return against >= std::numbers::sqrt2 / 2.0 || n_S.z() >= std::numbers::sqrt2 / 2.0;
}

/// The cosine of the angle between the motion and the nearest weak direction; 1 without seats.
double cos_to_weak_direction(const SwitchSetup& setup, const Point& n_S) {
  if (setup.seats == Seats::Even) {
    return 1.0;
  }
  constexpr double kThirdOfATurn = 2.0 * std::numbers::pi / 3.0;
  const double motion = std::atan2(-n_S.y(), -n_S.x());
  return std::cos(std::remainder(motion - radians(setup.weak_direction_deg), kThirdOfATurn));
}

}  // namespace

std::optional<double> deflection_to_trigger(const SwitchSetup& setup, const Point& n_S) {
  if (setup.type == ProbeType::Mono && !reaches_mono_switch(setup, n_S)) {
    return std::nullopt;
  }
  const double sine = std::hypot(n_S.x(), n_S.y());
  if (setup.trigger_force_n == 0.0 || sine == 0.0) {
    const bool held_down = setup.seats == Seats::Tripod && n_S.z() < 0.0;
    return held_down && sine == 0.0 ? std::nullopt : std::optional(setup.pre_travel_mm);
  }
  const double cosine = setup.seats == Seats::Even ? std::fabs(n_S.z()) : n_S.z();
  const double ease = sine * cos_to_weak_direction(setup, n_S) / setup.trigger_force_n +
                      cosine / setup.axial_force_n;
  if (ease <= 0.0) {
    return std::nullopt;
  }
  return setup.pre_travel_mm + sine * sine / (ease * setup.stem_stiffness_n_mm);
}

}  // namespace g31::probe
