#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "machine/units/point.h"
#include "probe/metrology/form_zones.h"
#include "probe/metrology/two_point.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_readings.h"
#include "tools/evaluate/sensor_rows.h"

namespace g31::evaluate {
namespace {

constexpr double kFullTurn = 360.0;

/// The first and the last of what was read along a work.
struct Ends {
  double first = 0.0;
  double last = 0.0;
};

DataError cannot(const DataFile& file, const std::string& why) {
  return data_error(DataErrorId::CannotEvaluate, file, {}, {why});
}

/// The diameters at the first and the last step.
Result<Ends, DataError> read_diameters(const Request& request, std::size_t steps) {
  const DataFile& file = *request.diameters;
  const auto table = read_table(file, {{"K", ColumnKind::Number}, {"d", ColumnKind::Length}},
                                {{}, request.columns.mm_per_unit});
  if (!table) {
    return table.error();
  }
  const std::vector<double>& places = table.value().numbers("K");
  const auto [low, high] = std::ranges::minmax_element(places);
  const double length = static_cast<double>(steps - 1);
  if (*high - *low != length) {
    return cannot(file, fmt::format("diameters are needed at both ends of the work, K {} and {}",
                                    *low, *low + length));
  }
  const std::vector<double>& d = table.value().numbers("d");
  return Ends{d[static_cast<std::size_t>(low - places.begin())],
              d[static_cast<std::size_t>(high - places.begin())]};
}

/// The line of an angle, whichever turn it counts; nullptr: there is none.
const SensorLine* line_at(const std::vector<SensorLine>& lines, double degrees) {
  const auto found = std::ranges::find_if(lines, [&](const SensorLine& line) {
    return std::abs(std::remainder(line.key - degrees, kFullTurn)) < 1e-6;
  });
  return found == lines.end() ? nullptr : &*found;
}

/// The radius along one line: the two-point shape between ends whose radius equation 11 gives.
std::vector<double> radii_along(const SensorLine& line, const SensorLine& at_0,
                                const SensorLine& at_180, const Ends& diameters) {
  const auto radius = [&](double diameter, auto end) {
    return metrology::radius_at(diameter, end(at_0.rows.a), end(at_180.rows.a), end(line.rows.a));
  };
  const double first = radius(diameters.first, [](const auto& a) { return a.front(); });
  const double last = radius(diameters.last, [](const auto& a) { return a.back(); });
  const auto shapes = metrology::separate_two_points(line.rows.a, line.rows.b);
  const double n = static_cast<double>(shapes.work.size() - 1);
  std::vector<double> radii;
  for (std::size_t k = 0; k < shapes.work.size(); ++k) {
    const double share = static_cast<double>(k) / n;
    radii.push_back(first + (last - first) * share + shapes.work[k] - share * shapes.work.back());
  }
  return radii;
}

Point on_surface(double degrees, double radius, double z) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace

Result<Evaluation, DataError> evaluate_cylindricity(const DataFile& file, const Request& request) {
  const auto lines = read_sensor_lines(file, request, {"theta", ColumnKind::Number, "C"});
  if (!lines) {
    return lines.error();
  }
  const SensorLine* const at_0 = line_at(lines.value(), 0.0);
  const SensorLine* const at_180 = line_at(lines.value(), 180.0);
  if (at_0 == nullptr || at_180 == nullptr) {
    return cannot(file, "readings at theta 0 and 180 are needed: the diameter lies between them");
  }
  const std::size_t steps = at_0->rows.a.size();
  const auto diameters = read_diameters(request, steps);
  if (!diameters) {
    return diameters.error();
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Cylindricity;
  Eigen::MatrixX3d points(static_cast<Eigen::Index>(steps * lines.value().size()), 3);
  Eigen::Index next = 0;
  double sum = 0.0;
  for (const SensorLine& line : lines.value()) {
    const auto radii = radii_along(line, *at_0, *at_180, diameters.value());
    Curve curve{fmt::format("theta_{}", line.key), {}};
    for (std::size_t k = 0; k < steps; ++k) {
      const double z = static_cast<double>(k) * *request.step;
      points.row(next++) = on_surface(line.key, radii[k], z).transpose();
      curve.points.push_back({z, 0.0});
      sum += radii[k];
    }
    evaluation.curves.push_back(std::move(curve));
  }
  const double mean = sum / static_cast<double>(points.rows());
  const auto round = metrology::cylindricity_of(points, file.watch);
  if (!round) {
    return cannot(file, "too few angles and steps to determine a cylinder");
  }
  // Where the work stands beside the axis that it turns about is no form of it.
  next = 0;
  for (Curve& curve : evaluation.curves) {
    for (auto& point : curve.points) {
      point[1] = round->deviations[next++];
    }
  }
  evaluation.samples = static_cast<std::size_t>(points.rows());
  evaluation.results = {{"cylindricity_least_squares", um(round->zones.least_squares), "um"},
                        {"cylindricity_minimum_zone", um(round->zones.minimum_zone), "um"},
                        {"radius", mean, "mm"}};
  if (request.wants_drawing) {
    std::vector<double> angles;
    for (const SensorLine& line : lines.value()) {
      angles.push_back(line.key);
    }
    evaluation.svg = stacked_chart(
        evaluation, angles, {plot::Word::TitleCylindricity, plot::Word::PlaceAlongWork}, request);
  }
  return evaluation;
}

}  // namespace g31::evaluate
