#include "tools/evaluate/fanuc_compensation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "tools/evaluate/even_table.h"

namespace g31::evaluate {
namespace {

constexpr double kUnitsPerMm = 1000.0;
constexpr double kMostNumber = 1023.0;  // of compensation points
constexpr std::int64_t kMostPitchError = 7;
constexpr std::int64_t kMostMagnification = 100;
constexpr double kMostStraightness = 32767.0;  // of a value

/// Numbers of the points of a moving axis: how far apart they are, and which is before coordinate
/// 0.
struct PitchPoints {
  double interval = 0.0;  ///< mm
  std::int64_t reference = 0;
  std::int64_t lowest = 0;
  std::int64_t highest = 0;
};

/// A part of the smallest distance of two places, in whole detection units, mm.
double interval_of(const Curve& curve, double parts = 1.0) {
  const double units = std::round(smallest_distance(curve) * kUnitsPerMm / parts);
  return std::max(1.0, units) / kUnitsPerMm;
}

/// Whether more points are needed than there are.
bool is_too_fine(const Curve& curve, double interval) {
  const double low = curve.points.front()[0];
  const double high = curve.points.back()[0];
  const double reach = std::max(std::abs(low), std::abs(high));
  return (high - low + reach) / interval > kMostNumber;
}

constexpr double kSameSection = 1e-6;  // of an interval

/// Which section begins at or before a place, 0 being the one behind coordinate 0.
std::int64_t section_from(double place, double interval) {
  return std::llround(std::floor(place / interval + kSameSection));
}

/// @param table  on multiples of the interval
PitchPoints points_of(const EvenTable& table) {
  PitchPoints points{table.step};
  const std::int64_t first = section_from(table.first, table.step);
  const std::int64_t last = first + std::ssize(table.values) - 2;
  points.reference = std::max<std::int64_t>(1, 1 - first);
  points.lowest = points.reference + std::min<std::int64_t>(0, first + 1);
  points.highest = points.reference + std::max<std::int64_t>(0, last + 1);
  return points;
}

/// The point of the section that ends at a place, where its correction is whole.
std::int64_t point_at(const PitchPoints& points, double place) {
  return points.reference + std::llround(place / points.interval);
}

std::string parameter(int number, int axis, std::int64_t value) {
  return fmt::format("N{} P{} R{}\n", number, axis, value);
}

int axis_number(char axis) {
  return axis - 'X' + 1;
}

std::string points_text(const PitchPoints& points, int axis) {
  return parameter(3620, axis, points.reference) + parameter(3621, axis, points.lowest) +
         parameter(3622, axis, points.highest);
}

/// What the correction gains in every section, in detection units; their sum never leaves the
/// correction by more than half of one.
std::vector<std::int64_t> gains_of(const EvenTable& table, std::int64_t magnification) {
  const double units = kUnitsPerMm / static_cast<double>(magnification);
  std::vector<std::int64_t> gains;
  for (std::size_t n = 1; n < table.values.size(); ++n) {
    gains.push_back(std::llround(-table.values[n] * units) -
                    std::llround(-table.values[n - 1] * units));
  }
  return gains;
}

std::int64_t largest(const std::vector<std::int64_t>& gains) {
  std::int64_t most = 0;
  for (const std::int64_t gain : gains) {
    most = std::max(most, std::abs(gain));
  }
  return most;
}

/// The smallest with which no gain is more than a point can have; nullopt: there is none.
std::optional<std::int64_t> magnification_of(const EvenTable& table) {
  for (std::int64_t magnification = 1; magnification <= kMostMagnification; ++magnification) {
    if (largest(gains_of(table, magnification)) <= kMostPitchError) {
      return magnification;
    }
  }
  return std::nullopt;
}

/// The points of a moving axis, and what they leave.
struct PitchErrors {
  EvenTable table = {};
  std::int64_t magnification = 1;
  double left = 0.0;  ///< of the curve at its places, beside what is the same everywhere, mm

  [[nodiscard]] double unit() const { return static_cast<double>(magnification) / kUnitsPerMm; }
};

/// nullopt: a gain is more than any magnification reaches.
std::optional<PitchErrors> pitch_errors_at(const Curve& curve, double interval) {
  PitchErrors errors{table_on_multiples(curve, interval)};
  const auto magnification = magnification_of(errors.table);
  if (!magnification) {
    return std::nullopt;
  }
  errors.magnification = *magnification;
  EvenTable written = errors.table;
  for (double& value : written.values) {
    value = errors.unit() * std::round(value / errors.unit());
  }
  errors.left = left_at_places(curve, written);
  return errors;
}

/// With points as far apart as the nearest two places or a whole part of that: the widest with
/// which the rounding to units is all that is left, or those of all that leave least.
std::optional<PitchErrors> pitch_errors_of(const Curve& curve) {
  constexpr double kRounding = 0.5 + 1e-6;  // of a unit
  std::optional<PitchErrors> best;
  for (double parts = 1.0; parts <= kMostNumber; ++parts) {
    const double interval = interval_of(curve, parts);
    if (is_too_fine(curve, interval)) {
      break;
    }
    const auto errors = pitch_errors_at(curve, interval);
    if (errors && (!best || errors->left < best->left)) {
      best = errors;
    }
    if (errors && errors->left <= kRounding * errors->unit()) {
      break;
    }
  }
  return best;
}

/// What the machine will be off where the error was measured.
std::string what_is_left(const PitchErrors& errors, const Curve& curve) {
  std::string text = fmt::format("(POINTS {} MM APART LEAVE {:.1f} UM AT THE PLACES MEASURED)\n",
                                 errors.table.step, kUmPerMm * errors.left);
  if (errors.table.step < interval_of(curve)) {
    text += "(NEARER THAN THOSE: 3624 IS RAPID TRAVERSE IN MM/MIN / 7500 AT LEAST)\n";
  }
  const double everywhere = std::round(error_table(curve).at(0.0) / errors.unit());
  if (everywhere != 0.0) {
    text += fmt::format("(AND {} UM EVERYWHERE: AT COORDINATE 0 THEY CORRECT NOTHING)\n",
                        everywhere * static_cast<double>(errors.magnification));
  }
  return text;
}

/// @pre why_no_fanuc_compensation() has nothing to say
std::string pitch_errors(const MachineError& error, int axis) {
  const PitchErrors errors = *pitch_errors_of(error.deviations);
  const PitchPoints points = points_of(errors.table);
  std::string text =
      fmt::format("(PITCH ERRORS OF {}, UNITS OF {} UM)\n", error.name[2], errors.magnification) +
      what_is_left(errors, error.deviations) + points_text(points, axis) +
      parameter(3623, axis, errors.magnification) +
      parameter(3624, axis, std::llround(points.interval * kUnitsPerMm));
  std::int64_t n = 10000 + points.reference + section_from(errors.table.first, points.interval);
  for (const std::int64_t gain : gains_of(errors.table, errors.magnification)) {
    text += fmt::format("N{} R{}\n", ++n, gain);
  }
  return text;
}

/// What a straightness parameter says for a deviation, in detection units.
std::int64_t correction_in_units(double deviation) {
  return std::llround(-deviation * kUnitsPerMm);
}

/// Of four points of a table, first and last among them, those whose lines leave least of the
/// curve.
struct FourPoints {
  std::array<std::size_t, 4> at = {};
  double left = std::numeric_limits<double>::infinity();  ///< mm
};

double left_by(const Curve& curve, const EvenTable& table, const std::array<std::size_t, 4>& at) {
  Curve lines;
  for (const std::size_t n : at) {
    if (lines.points.empty() || table.place(n) > lines.points.back()[0]) {
      const auto written = static_cast<double>(correction_in_units(table.values[n]));
      lines.points.push_back({table.place(n), -written / kUnitsPerMm});
    }
  }
  const errors::ErrorTable straight = error_table(lines);
  double most = 0.0;
  for (const auto& [place, deviation] : curve.points) {
    most = std::max(most, std::abs(deviation - straight.at(place)));
  }
  return most;
}

FourPoints best_four(const Curve& curve, const EvenTable& table) {
  constexpr std::size_t kTried = 60;  // inner places: more would take seconds
  const std::size_t last = table.values.size() - 1;
  const std::size_t stride = std::max<std::size_t>(1, last / kTried);
  FourPoints best;
  // Fewer than four points serve twice.
  const std::size_t apart = last >= 3 ? 1 : 0;
  for (std::size_t b = apart; b + 2 * apart <= last; b += stride) {
    for (std::size_t c = b + apart; c + apart <= last; c += stride) {
      const std::array<std::size_t, 4> at = {0, b, c, last};
      const double left = left_by(curve, table, at);
      if (left < best.left) {
        best = {at, left};
      }
    }
  }
  return best;
}

std::string straightness(const MachineError& error, int moving, int compensated) {
  const EvenTable table = table_on_multiples(error.deviations, interval_of(error.deviations));
  PitchPoints points = points_of(table);
  points.lowest = std::min(points.lowest, point_at(points, table.first));
  const FourPoints four = best_four(error.deviations, table);
  const char moving_axis = error.name[2];
  std::string text =
      fmt::format("(STRAIGHTNESS OF {} BY THE PLACE OF {}, UNITS OF 1 UM)\n", error.name[1],
                  moving_axis) +
      fmt::format("(FOUR PLACES LEAVE {:.1f} UM OF THE CURVE)\n", kUmPerMm * four.left) +
      fmt::format("(POINTS ARE THOSE OF THE PITCH ERRORS OF {}: WHERE IT HAS SOME, ADAPT THEM)\n",
                  moving_axis) +
      points_text(points, moving) +
      parameter(3624, moving, std::llround(points.interval * kUnitsPerMm)) +
      fmt::format("N5711 R{}\nN5721 R{}\n", moving, compensated);
  for (std::size_t n = 0; n < four.at.size(); ++n) {
    text += fmt::format("N{} R{}\n", 5731 + n, point_at(points, table.place(four.at[n])));
  }
  for (std::size_t n = 0; n < four.at.size(); ++n) {
    text += fmt::format("N{} R{}\n", 5761 + n, correction_in_units(table.values[four.at[n]]));
  }
  return text;
}

}  // namespace

std::optional<std::string> why_no_fanuc_compensation(const MachineError& error) {
  const Curve& curve = error.deviations;
  const double interval = interval_of(curve);
  if (is_too_fine(curve, interval)) {
    return fmt::format(
        "a Fanuc has points 0 to 1023, and places {} mm apart would need more: leave out rows",
        interval);
  }
  if (error.name[1] == error.name[2] && !pitch_errors_of(curve)) {
    return fmt::format("a Fanuc corrects {} um from one point to the next at most",
                       kMostPitchError * kMostMagnification);
  }
  for (const auto& [place, deviation] : curve.points) {
    if (std::abs(deviation) * kUnitsPerMm > kMostStraightness) {
      return fmt::format("a Fanuc corrects {} um at most", kMostStraightness);
    }
  }
  return std::nullopt;
}

std::string fanuc_compensation(const MachineError& error) {
  const int compensated = axis_number(error.name[1]);
  const int moving = axis_number(error.name[2]);
  const std::string body = moving == compensated ? pitch_errors(error, moving)
                                                 : straightness(error, moving, compensated);
  return "%\nO0001 (COMPENSATION)\n(AXES X Y Z ARE 1 2 3.  L50 IN PLACE OF L52 ON 16I, 18I, 0I-D)\n"
         "G10 L52\n" +
         body + "G11\nM30\n%\n";
}

}  // namespace g31::evaluate
