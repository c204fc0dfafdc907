#include "interpreter/dialects/fanuc/state/pitch_errors.h"

#include <cmath>
#include <optional>

namespace g31::fanuc {
namespace {

/// As 3620 to 3623 have them.
enum class Which { Reference, Lowest, Highest, Magnification };

double number_of(const Parameters& parameters, Which which, int axis) {
  return std::round(
      parameters.get_for_axis(ParameterId::PitchPoints, static_cast<int>(which), axis));
}

machine::CompensationTable table_of(const Parameters& parameters, const PitchGrid& grid, int axis) {
  const double unit_mm = kDetectionUnitMm * number_of(parameters, Which::Magnification, axis);
  machine::CompensationTable table;
  table.compensated = axis;
  machine::CompensationTable::Factor& corrections = table.factors.emplace_back();
  corrections.axis = axis;
  double sum = 0.0;
  double at_zero = 0.0;
  for (int n = grid.lowest - 1; n <= grid.highest; ++n) {
    if (n >= grid.lowest) {
      sum += unit_mm * parameters.get(ParameterId::PitchErrors, n);
    }
    if (n <= grid.reference) {
      at_zero = sum;
    }
    corrections.points.emplace_back(grid.end_of(n), sum);
  }
  for (auto& [place, correction] : corrections.points) {
    correction -= at_zero;
  }
  return table;
}

}  // namespace

std::optional<PitchGrid> pitch_grid(const Parameters& parameters, int axis) {
  const double reference = number_of(parameters, Which::Reference, axis);
  const double lowest = number_of(parameters, Which::Lowest, axis);
  const double highest = number_of(parameters, Which::Highest, axis);
  const double interval = parameters.get_for_axis(ParameterId::PitchInterval, 0, axis);
  const ParameterInfo& errors = info(ParameterId::PitchErrors);
  const double most = errors.last - errors.first;
  if (!(lowest >= 0.0 && highest >= lowest && highest <= most && std::abs(reference) <= most) ||
      !(interval > 0.0)) {
    return std::nullopt;
  }
  return PitchGrid{static_cast<int>(reference), static_cast<int>(lowest), static_cast<int>(highest),
                   interval};
}

std::vector<machine::CompensationTable> pitch_error_tables(const Parameters& parameters) {
  std::vector<machine::CompensationTable> tables;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const auto grid = pitch_grid(parameters, axis);
    if (grid && number_of(parameters, Which::Magnification, axis) > 0.0) {
      tables.push_back(table_of(parameters, *grid, axis));
    }
  }
  return tables;
}

}  // namespace g31::fanuc
