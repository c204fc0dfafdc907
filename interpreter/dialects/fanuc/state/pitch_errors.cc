#include "interpreter/dialects/fanuc/state/pitch_errors.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace g31::fanuc {
namespace {

constexpr double kDetectionUnitMm = 0.001;

/// The points of an axis.
struct Points {
  int reference = 0;
  int lowest = 0;
  int highest = 0;
  double unit_mm = 0.0;
  double interval_mm = 0.0;
};

/// nullopt: the axis is not compensated.
std::optional<Points> points_of(const Parameters& parameters, int axis) {
  enum Which { Reference, Lowest, Highest, Magnification };
  const auto value = [&](Which which) {
    return std::round(parameters.get_for_axis(ParameterId::PitchPoints, which, axis));
  };
  const ParameterInfo& errors = info(ParameterId::PitchErrors);
  const double most = errors.last - errors.first;
  const double interval = parameters.get_for_axis(ParameterId::PitchInterval, 0, axis);
  const bool has_points = value(Lowest) >= 0.0 && value(Highest) >= value(Lowest) &&
                          value(Highest) <= most && std::abs(value(Reference)) <= most;
  if (!has_points || !(interval > 0.0) || !(value(Magnification) > 0.0)) {
    return std::nullopt;
  }
  return Points{static_cast<int>(value(Reference)), static_cast<int>(value(Lowest)),
                static_cast<int>(value(Highest)), kDetectionUnitMm * value(Magnification),
                interval};
}

machine::CompensationTable table_of(const Parameters& parameters, const Points& points, int axis) {
  machine::CompensationTable table;
  table.compensated = axis;
  machine::CompensationTable::Factor& corrections = table.factors.emplace_back();
  corrections.axis = axis;
  double sum = 0.0;
  double at_zero = 0.0;
  for (int n = points.lowest - 1; n <= points.highest; ++n) {
    if (n >= points.lowest) {
      sum += points.unit_mm * parameters.get(ParameterId::PitchErrors, n);
    }
    if (n <= points.reference) {
      at_zero = sum;
    }
    corrections.points.emplace_back((n - points.reference) * points.interval_mm, sum);
  }
  for (auto& [place, correction] : corrections.points) {
    correction -= at_zero;
  }
  return table;
}

}  // namespace

std::vector<machine::CompensationTable> pitch_error_tables(const Parameters& parameters) {
  std::vector<machine::CompensationTable> tables;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    if (const auto points = points_of(parameters, axis)) {
      tables.push_back(table_of(parameters, *points, axis));
    }
  }
  return tables;
}

}  // namespace g31::fanuc
