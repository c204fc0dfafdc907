#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "probe/metrology/form_zones.h"
#include "probe/metrology/two_point.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_readings.h"
#include "tools/evaluate/sensor_rows.h"

namespace g31::evaluate {
namespace {

using metrology::SeparatedShapes;

/// @param first  K of the first of them
/// @param from   the place of K = 0
std::vector<double> places_of(double first, std::size_t count, double step, double from) {
  std::vector<double> places;
  for (std::size_t row = 0; row < count; ++row) {
    places.push_back(from + (first + static_cast<double>(row)) * step);
  }
  return places;
}

void add_zones(const std::string& name, const std::vector<double>& places,
               const std::vector<double>& shape, machine::WorkWatch* watch,
               std::vector<Quantity>& results) {
  const metrology::StraightnessZones zones = metrology::straightness_of(places, shape, watch);
  results.push_back({name, um(zones.end_points), "um"});
  results.push_back({name + "_least_squares", um(zones.least_squares), "um"});
  results.push_back({name + "_minimum_zone", um(zones.minimum_zone), "um"});
}

Curve curve_of(const std::string& name, const std::vector<double>& places,
               const std::vector<double>& shape) {
  Curve curve{name, {}};
  for (std::size_t k = 0; k < shape.size(); ++k) {
    curve.points.push_back({places[k], shape[k]});
  }
  return curve;
}

/// What sums of readings are uncertain by, where that of one is known.
std::optional<double> um_of(const Request& request, double readings) {
  return request.uncertainty ? um(*request.uncertainty * readings) : std::nullopt;
}

void add_offsets(const SensorRows& rows, const SeparatedShapes& shapes, const Request& request,
                 Evaluation& evaluation) {
  // Each of n steps has two readings of its own.
  const auto n = static_cast<double>(rows.a.size() - 1);
  const std::optional<double> u = um_of(request, std::sqrt(2.0 / n));
  if (rows.c.size() < 3) {
    evaluation.results.push_back({"delta", um(shapes.delta), "um", u});
    return;
  }
  const double delta_1 = shapes.delta;
  const double delta_2 = metrology::separate_two_points(rows.b, rows.c).delta;
  const double delta = metrology::tip_offset_over_two(rows.a, rows.c, shapes.motion);
  evaluation.results.push_back(
      {"delta", um(delta), "um",
       um_of(request, metrology::tip_offset_over_two_uncertainty(rows.a.size() - 1))});
  evaluation.results.push_back({"delta_1", um(delta_1), "um", u});
  evaluation.results.push_back({"delta_2", um(delta_2), "um", u});
  evaluation.results.push_back({"delta_closure", um(delta - delta_1 - delta_2), "um"});
}

}  // namespace

Result<Evaluation, DataError> evaluate_straightness(const DataFile& file, const Request& request) {
  const auto read = read_sensor_rows(file, request);
  if (!read) {
    return read.error();
  }
  const SensorRows& rows = read.value();
  const SeparatedShapes shapes = metrology::separate_two_points(rows.a, rows.b);
  const double from = request.from.value_or(0.0);
  const std::vector<double> places = places_of(rows.first, rows.a.size(), *request.step, from);
  if (!(std::abs(places.front()) <= kLargestLength && std::abs(places.back()) <= kLargestLength)) {
    return data_error(
        DataErrorId::CannotEvaluate, file, {},
        {fmt::format("its places reach {} mm, further than {} mm",
                     std::max(std::abs(places.front()), std::abs(places.back())), kLargestLength)});
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Straightness;
  evaluation.samples = rows.a.size();
  add_offsets(rows, shapes, request, evaluation);
  // Where the first place lies is nothing to the zones: beside a large one small steps are lost.
  const std::vector<double> along = places_of(0.0, rows.a.size(), *request.step, 0.0);
  add_zones("motion_straightness", along, shapes.motion, file.watch, evaluation.results);
  add_zones("work_straightness", along, shapes.work, file.watch, evaluation.results);
  const std::size_t n = rows.a.size() - 1;
  evaluation.results.push_back({"parallelism", um(shapes.work.back()), "um",
                                um_of(request, metrology::work_uncertainty(n, n))});
  evaluation.curves = {curve_of("motion", places, shapes.motion),
                       curve_of("work", places, shapes.work)};
  evaluation.machine_error = {request.error, evaluation.curves.front()};
  evaluation.notes.push_back(fmt::format(
      "readings of standard uncertainty u make one of {:.3g} u of the motion in the "
      "middle of {} steps, and {:.3g} u of the work",
      metrology::motion_uncertainty(n / 2, n), n, metrology::work_uncertainty((n + 1) / 2, n)));
  if (request.wants_drawing) {
    evaluation.svg = deviation_chart(
        evaluation, {plot::Word::TitleStraightness, plot::Word::PlaceAlongWay}, request);
  }
  return evaluation;
}

}  // namespace g31::evaluate
