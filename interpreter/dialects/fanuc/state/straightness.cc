#include "interpreter/dialects/fanuc/state/straightness.h"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/state/pitch_errors.h"

namespace g31::fanuc {
namespace {

constexpr int kPairs = 3;
constexpr int kPointsOfPair = 4;
constexpr int kNumbersOfPair = 10;  // from 5731 to 5741

/// Storage index of an axis by its number; nullopt: no linear axis has it.
std::optional<int> axis_of(double number) {
  const double index = std::round(number) - 1.0;
  return index >= 0.0 && index < kLinearAxisCount ? std::optional(static_cast<int>(index))
                                                  : std::nullopt;
}

Failure wrong_parameter(int number, const std::string& why) {
  Failure failure;
  failure.id = AlarmId::BadStraightness;
  failure.detail = fmt::format("parameter {}: {}", number, why);
  return failure;
}

Result<machine::CompensationTable, Failure> table_of(const Parameters& parameters, int pair) {
  const auto moving = axis_of(parameters.get(ParameterId::StraightnessMoving, pair));
  const auto moved = axis_of(parameters.get(ParameterId::StraightnessMoved, pair));
  if (!moving) {
    return wrong_parameter(5711 + pair, "the number of a linear axis, 1 to 3");
  }
  if (!moved || *moved == *moving) {
    return wrong_parameter(5721 + pair, "the number of another linear axis, 1 to 3");
  }
  const auto grid = pitch_grid(parameters, *moving);
  if (!grid) {
    return wrong_parameter(5711 + pair, "the moving axis has no points, 3620 to 3624");
  }
  machine::CompensationTable table;
  table.compensated = *moved;
  machine::CompensationTable::Factor& corrections = table.factors.emplace_back();
  corrections.axis = *moving;
  double before = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPointsOfPair; ++i) {
    const int at = kNumbersOfPair * pair + i;
    const double point = std::round(parameters.get(ParameterId::StraightnessPoints, at));
    if (point < before || point < grid->lowest || point > grid->highest) {
      return wrong_parameter(5731 + at, fmt::format("points do not fall, and are {} to {} here",
                                                    grid->lowest, grid->highest));
    }
    // A point that is there twice has its first value.
    if (point > before) {
      const double value = parameters.get(ParameterId::StraightnessValues, at);
      corrections.points.emplace_back(grid->end_of(static_cast<int>(point)),
                                      kDetectionUnitMm * value);
    }
    before = point;
  }
  return table;
}

}  // namespace

Result<std::vector<machine::CompensationTable>, Failure> straightness_tables(
    const Parameters& parameters) {
  std::vector<machine::CompensationTable> tables;
  for (int pair = 0; pair < kPairs; ++pair) {
    if (parameters.get(ParameterId::StraightnessMoving, pair) == 0.0 &&
        parameters.get(ParameterId::StraightnessMoved, pair) == 0.0) {
      continue;
    }
    auto table = table_of(parameters, pair);
    if (!table) {
      return table.error();
    }
    tables.push_back(std::move(table.value()));
  }
  return tables;
}

}  // namespace g31::fanuc
