#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace g31::testing {

/// A machine drawn by its seed, a circle on it, and what an evaluation should find.  mm, s, rad.
struct DrawnMachine {
  double radius = 0.0;
  double feed_mm_s = 0.0;
  std::array<double, 2> centre = {};
  std::array<double, 2> backlash = {};
  std::array<double, 2> scale = {};  ///< slope of the positioning errors by least squares
  std::array<double, 2> lag_s = {};
  double c0y = 0.0;   ///< rad
  double form = 0.0;  ///< the most that a way bends, beside its line of least squares
  std::uint64_t seed = 0;
};

DrawnMachine drawn_machine(std::uint64_t seed);

/// Its set-up sheet, and the program of a circle in both directions.
std::string sheet_of(const DrawnMachine& machine);
std::string circle_of(const DrawnMachine& machine);

/// What `g31 evaluate circle` should find, in its units, in closed form from the sheet.
struct NamedTruth {
  std::string name;
  double value = 0.0;
};
std::vector<NamedTruth> circle_truth(const DrawnMachine& machine);

/// An axis over a bed, both bent, and two sensors; all drawn.
struct DrawnBench {
  std::vector<double> motion;  ///< EZX at every step, mm
  std::vector<double> bed;     ///< the same of the bed's profile, one place more
  double tip = 0.0;            ///< B reads more than A by this, mm
  double noise = 0.0;          ///< of a reading, mm
};

inline constexpr double kBenchStep = 100.0;

DrawnBench drawn_bench(std::uint64_t seed);
std::string sheet_of(const DrawnBench& bench);

}  // namespace g31::testing
