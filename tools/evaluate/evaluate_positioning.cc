#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "machine/units/axis_positions.h"
#include "probe/metrology/positioning.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_readings.h"

namespace g31::evaluate {
namespace {

using metrology::PositioningEvaluation;

/// The axis whose rows are evaluated: the one asked for, else the only one.
Result<std::string, DataError> axis_of(const DataFile& file, const DataTable& table,
                                       const Request& request) {
  const std::vector<std::string>& axes = table.texts("axis");
  const std::string axis = request.axis.value_or(axes.front());
  const auto is_it = [&](const std::string& name) { return name == axis; };
  if (request.axis && std::ranges::none_of(axes, is_it)) {
    return data_error(DataErrorId::CannotEvaluate, file, {},
                      {fmt::format("there are no rows of axis {}", axis)});
  }
  const auto other = std::ranges::find_if_not(axes, is_it);
  if (!request.axis && other != axes.end()) {
    const auto row = static_cast<std::size_t>(other - axes.begin());
    return data_error(DataErrorId::NotOneOf, file, place_of_line(file, table.line(row)),
                      {"axis", *other, axis},
                      fmt::format("--axis {} takes the rows of that axis alone", axis));
  }
  return axis;
}

/// A, B and C turn about X, Y and Z; a control with several of a kind numbers them.
bool is_rotary(const std::string& axis) {
  return !axis.empty() && is_rotary_axis(axis_index(axis.front())) &&
         axis.find_first_not_of("0123456789", 1) == std::string::npos;
}

/// The axis must be linear: ISO 230-2 states rotary ones in degrees or seconds of arc.
std::optional<DataError> why_not_linear(const DataFile& file, const DataTable& table,
                                        const std::string& axis) {
  if (!is_rotary(axis)) {
    return std::nullopt;
  }
  const std::vector<std::string>& axes = table.texts("axis");
  const auto row = static_cast<std::size_t>(std::ranges::find(axes, axis) - axes.begin());
  return data_error(DataErrorId::RotaryAxis, file, place_of_line(file, table.line(row)), {axis});
}

std::vector<Quantity> results_of(const PositioningEvaluation& p) {
  return {
      {"A", um(p.A), "um"},           {"A_up", um(p.A_up), "um"}, {"A_down", um(p.A_down), "um"},
      {"R", um(p.R), "um"},           {"R_up", um(p.R_up), "um"}, {"R_down", um(p.R_down), "um"},
      {"B", um(p.B), "um"},           {"E", um(p.E), "um"},       {"E_up", um(p.E_up), "um"},
      {"E_down", um(p.E_down), "um"}, {"M", um(p.M), "um"}};
}

/// Means and the limits two standard deviations beside them, by target.
std::vector<Curve> curves_of(const PositioningEvaluation& p) {
  std::vector<Curve> curves;
  for (const bool is_up : {true, false}) {
    const std::string name = is_up ? "up" : "down";
    Curve mean{"mean_" + name, {}};
    Curve above{"mean_" + name + "_plus_2s", {}};
    Curve below{"mean_" + name + "_minus_2s", {}};
    for (const metrology::TargetStatistics& target : p.targets) {
      if (const auto& one = is_up ? target.up : target.down) {
        mean.points.push_back({target.target, one->mean});
        above.points.push_back({target.target, one->mean + 2.0 * one->s});
        below.points.push_back({target.target, one->mean - 2.0 * one->s});
      }
    }
    curves.insert(curves.end(), {std::move(mean), std::move(above), std::move(below)});
  }
  return curves;
}

/// The mean of both directions at each target, as ISO 230-2 has it; of one where only that was
/// driven.
Curve mean_deviations(const PositioningEvaluation& p) {
  Curve mean{"mean", {}};
  for (const metrology::TargetStatistics& target : p.targets) {
    const auto& one = target.up ? target.up : target.down;
    const auto& other = target.down ? target.down : target.up;
    mean.points.push_back({target.target, 0.5 * (one->mean + other->mean)});
  }
  return mean;
}

/// That targets were not approached equally often, as the standard has it: means and deviations of
/// fewer say less.
std::optional<std::string> uneven_approaches(const PositioningEvaluation& p) {
  std::size_t most = 0;
  for (const metrology::TargetStatistics& target : p.targets) {
    for (const auto& side : {target.up, target.down}) {
      most = std::max(most, side ? side->approaches : 0);
    }
  }
  for (const metrology::TargetStatistics& target : p.targets) {
    for (const auto& [side, name] : {std::pair(target.up, "positive"), {target.down, "negative"}}) {
      if (side && side->approaches < most) {
        return fmt::format(
            "target {} mm was approached {} times in the {} direction, others {} times: the "
            "standard has the same number for all",
            target.target, side->approaches, name, most);
      }
    }
  }
  return std::nullopt;
}

/// Why results have no value: targets that were not approached from one side; and what makes them
/// uneven.
std::vector<std::string> notes_of(const PositioningEvaluation& p) {
  std::vector<std::string> notes;
  if (auto uneven = uneven_approaches(p)) {
    notes.push_back(*std::move(uneven));
  }
  for (const bool is_up : {true, false}) {
    const auto lacks = [is_up](const metrology::TargetStatistics& target) {
      return !(is_up ? target.up : target.down);
    };
    const auto first = std::ranges::find_if(p.targets, lacks);
    if (first == p.targets.end()) {
      continue;
    }
    const auto count = std::ranges::count_if(p.targets, lacks);
    notes.push_back(fmt::format(
        "{1} of {2} targets {3} not approached in the {0} direction, first {4} mm: A_{5}, R_{5} "
        "and E_{5} need every target from that side, A, R, B, E and M from both",
        is_up ? "positive" : "negative", count, p.targets.size(), count == 1 ? "was" : "were",
        first->target, is_up ? "up" : "down"));
  }
  return notes;
}

/// The rows of an axis; each target is approached once in a cycle from a side.
Result<std::vector<metrology::Approach>, DataError> approaches_of(const DataFile& file,
                                                                  const DataTable& table,
                                                                  const std::string& axis) {
  std::vector<metrology::Approach> approaches;
  std::map<std::tuple<double, double, double>, std::size_t> lines;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto not_one_of = [&](const char* column, double number, const std::string& expected) {
      return data_error(DataErrorId::NotOneOf, file, place_of_line(file, table.line(row)),
                        {column, fmt::format("{}", number), expected});
    };
    const double direction = table.numbers("direction")[row];
    if (direction != 1.0 && direction != -1.0) {
      return not_one_of("direction", direction, "+1 or -1");
    }
    const double cycle = table.numbers("cycle")[row];
    if (cycle != std::floor(cycle)) {
      return not_one_of("cycle", cycle, "a whole number");
    }
    if (table.texts("axis")[row] != axis) {
      continue;
    }
    const double target = table.numbers("target")[row];
    const auto [first, is_new] = lines.try_emplace({target, direction, cycle}, table.line(row));
    if (!is_new) {
      return not_one_of(
          "cycle", cycle,
          fmt::format("another than in line {}, which has the same target and direction",
                      first->second));
    }
    approaches.push_back({target, table.numbers("position")[row], direction > 0.0});
  }
  return approaches;
}

}  // namespace

Result<Evaluation, DataError> evaluate_positioning(const DataFile& file, const Request& request) {
  const auto table = read_table(file,
                                {{"axis", ColumnKind::Text},
                                 {"target", ColumnKind::Length},
                                 {"direction", ColumnKind::Number},
                                 {"cycle", ColumnKind::Number},
                                 {"position", ColumnKind::Length}},
                                request.columns);
  if (!table) {
    return table.error();
  }
  const auto axis = axis_of(file, table.value(), request);
  if (!axis) {
    return axis.error();
  }
  if (auto wrong = why_not_linear(file, table.value(), axis.value())) {
    return *wrong;
  }
  const auto taken = approaches_of(file, table.value(), axis.value());
  if (!taken) {
    return taken.error();
  }
  const std::vector<metrology::Approach>& approaches = taken.value();
  const auto positioning = metrology::evaluate_positioning(approaches);
  if (!positioning) {
    return data_error(DataErrorId::CannotEvaluate, file, {}, {positioning.error()});
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Positioning;
  evaluation.samples = approaches.size();
  evaluation.results = results_of(positioning.value());
  evaluation.curves = curves_of(positioning.value());
  evaluation.notes = notes_of(positioning.value());
  evaluation.machine_error = {"E" + axis.value() + axis.value(),
                              mean_deviations(positioning.value())};
  if (request.wants_drawing) {
    evaluation.svg = positioning_chart(evaluation, axis.value(), request);
  }
  return evaluation;
}

}  // namespace g31::evaluate
