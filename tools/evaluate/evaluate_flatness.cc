#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "probe/metrology/form_zones.h"
#include "probe/metrology/two_point.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_readings.h"
#include "tools/evaluate/sensor_rows.h"

namespace g31::evaluate {
namespace {

using Points = Eigen::MatrixX3d;

Result<Points, DataError> read_points(const DataFile& file, const Request& request) {
  const auto table = read_table(file,
                                {{"x", ColumnKind::Length, "X"},
                                 {"y", ColumnKind::Length, "Y"},
                                 {"z", ColumnKind::Length, "Z"}},
                                request.columns);
  if (!table) {
    return table.error();
  }
  Points points(static_cast<Eigen::Index>(table.value().size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    points.row(i) << table.value().numbers("x")[row], table.value().numbers("y")[row],
        table.value().numbers("z")[row];
  }
  return points;
}

Result<Points, DataError> read_lines(const DataFile& file, const Request& request) {
  const auto lines = read_sensor_lines(file, request, {"y", ColumnKind::Length});
  if (!lines) {
    return lines.error();
  }
  const auto steps = static_cast<Eigen::Index>(lines.value().front().rows.a.size());
  Points points(steps * static_cast<Eigen::Index>(lines.value().size()), 3);
  const double level = lines.value().front().rows.a.front();
  Eigen::Index next = 0;
  for (const SensorLine& line : lines.value()) {
    const auto shapes = metrology::separate_two_points(line.rows.a, line.rows.b);
    for (Eigen::Index k = 0; k < steps; ++k) {
      const double work = shapes.work[static_cast<std::size_t>(k)];
      points.row(next++) << (line.rows.first + static_cast<double>(k)) * *request.step, line.key,
          work + line.rows.a.front() - level;
    }
  }
  return points;
}

/// How far points reach from their middle, and across the line to the farthest of them.
struct Reach {
  double length = 0.0;
  double width = 0.0;
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
};

Reach reach_of(const Eigen::MatrixX2d& points) {
  const Eigen::MatrixX2d off = points.rowwise() - points.colwise().mean().eval();
  Eigen::Index farthest = 0;
  Reach reach;
  reach.length = off.rowwise().norm().maxCoeff(&farthest);
  reach.along = off.row(farthest).transpose().normalized();
  const Eigen::Vector2d across(-reach.along.y(), reach.along.x());
  reach.width = (off * across).cwiseAbs().maxCoeff();
  return reach;
}

/// Points above one line in x and y are a face only where they spread about as a face does: what a
/// row of touches is out of straight makes a plane of its own, in which nothing deviates.
bool is_one_row(const Points& points) {
  constexpr double kOnALine = 1e-3;  // of the length
  constexpr double kRoughness = 0.05;
  const Reach seen_from_above = reach_of(points.leftCols<2>());
  if (seen_from_above.width > kOnALine * seen_from_above.length) {
    return false;
  }
  Eigen::MatrixX2d upright(points.rows(), 2);
  upright.col(0) = points.leftCols<2>() * seen_from_above.along;
  upright.col(1) = points.col(2);
  const Reach seen_across = reach_of(upright);
  return seen_across.width < kRoughness * seen_across.length;
}

/// The deviations of points with the same y, along x.
std::vector<Curve> lines_of(const Points& points, const Eigen::VectorXd& deviations,
                            const DataFile& file) {
  std::map<double, Curve> lines;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    file.look();
    Curve& line = lines[points(i, 1)];
    line.points.push_back({points(i, 0), deviations[i]});
  }
  std::vector<Curve> curves;
  curves.reserve(lines.size());
  for (auto& [y, line] : lines) {
    file.look();
    std::ranges::sort(line.points);
    line.name = fmt::format("y_{}", y);
    curves.push_back(std::move(line));
  }
  return curves;
}

/// Lines along x where points stand in lines, else a map: a line of one point shows nothing.
std::string drawing_of(const Points& points, const Eigen::VectorXd& deviations,
                       const Evaluation& evaluation, const Request& request) {
  const auto count = static_cast<std::size_t>(points.rows());
  if (2 * evaluation.curves.size() <= count) {
    return deviation_chart(evaluation, {plot::Word::TitleFlatness, plot::Word::PlaceX}, request);
  }
  std::vector<MapPoint> seen;
  seen.reserve(count);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    seen.push_back({points(i, 0), points(i, 1), deviations[i]});
  }
  return deviation_map(evaluation, seen, request);
}

}  // namespace

Result<Evaluation, DataError> evaluate_flatness(const DataFile& file, const Request& request) {
  const auto points = request.step ? read_lines(file, request) : read_points(file, request);
  if (!points) {
    return points.error();
  }
  if (is_one_row(points.value())) {
    return data_error(
        DataErrorId::CannotEvaluate, file, {},
        {"the points lie on one line in x and y, and in z within a twentieth of its length; a "
         "narrow upright face is taken from its side with --columns y=z,z=y"});
  }
  const auto flat = metrology::flatness_of(points.value(), file.watch);
  if (!flat) {
    return data_error(DataErrorId::CannotEvaluate, file, {},
                      {"the points lie on one line, within a thousandth of its length"});
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Flatness;
  evaluation.samples = static_cast<std::size_t>(points.value().rows());
  evaluation.results = {{"flatness_least_squares", um(flat->zones.least_squares), "um"},
                        {"flatness_minimum_zone", um(flat->zones.minimum_zone), "um"}};
  evaluation.curves = lines_of(points.value(), flat->deviations, file);
  if (request.wants_drawing) {
    evaluation.svg = drawing_of(points.value(), flat->deviations, evaluation, request);
  }
  return evaluation;
}

}  // namespace g31::evaluate
