#include "interpreter/runtime/angles.h"

#include <cmath>
#include <numbers>

#include "machine/base/rounding.h"

namespace g31::runtime {
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

/// Below this whole turns are exact numbers, and so is the rest: both are multiples of the last
/// digit of `degrees`.
constexpr double kExactTurns = 1e15;

/// The same angle within about one turn, exactly: a product tells how many turns it has, near a
/// whole one perhaps one too many or too few.
double within_a_turn(double degrees) {
  constexpr double kTurns = 1.0 / 360.0;
  return std::abs(degrees) < kExactTurns ? degrees - 360.0 * truncated(degrees * kTurns)
                                         : std::fmod(degrees, 360.0);
}

double sine_from(double degrees, int quarters) {
  const double reduced = within_a_turn(degrees);
  const double quarter = rounded(reduced / 90.0);
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

}  // namespace g31::runtime
