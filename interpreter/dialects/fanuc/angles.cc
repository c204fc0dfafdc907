#include "interpreter/dialects/fanuc/angles.h"

#include <cmath>
#include <numbers>

namespace g31::fanuc {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// Sine of -45..45 degrees.
double small_sine(double degrees) {
  if (degrees == 30.0 || degrees == -30.0) {
    return degrees / 60.0;
  }
  return std::sin(degrees * kRadians);
}

/// Sine of degrees + 90 * quarter, degrees in -45..45.
double by_quarter(double degrees, int quarter) {
  switch (quarter & 3) {
    case 0:
      return small_sine(degrees);
    case 1:
      return std::cos(degrees * kRadians);
    case 2:
      return -small_sine(degrees);
    default:
      return -std::cos(degrees * kRadians);
  }
}

double sine_from(double degrees, int quarters) {
  const double reduced = std::abs(degrees) < 360.0 ? degrees : std::fmod(degrees, 360.0);
  const double quarter = std::round(reduced / 90.0);
  const double rest = reduced - 90.0 * quarter;
  const int turn = static_cast<int>(quarter) + quarters;
  // + 0.0 turns a negative zero into a plain one.
  return by_quarter(rest, turn) + 0.0;
}

}  // namespace

double sine_deg(double degrees) {
  return sine_from(degrees, 0);
}

double cosine_deg(double degrees) {
  return sine_from(degrees, 1);
}

}  // namespace g31::fanuc
