#include "probe/metrology/circle_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace g31::metrology {
namespace {

constexpr int kTerms = 8;
constexpr int kMostSteps = 12;
using Row = Eigen::Matrix<double, kTerms, 1>;
using Normal = Eigen::Matrix<double, kTerms, kTerms>;

constexpr Eigen::Index index_of(CircleTerm term) {
  return static_cast<Eigen::Index>(term);
}

double sign_of(double value) {
  return value < 0.0 ? -1.0 : 1.0;
}

struct Sums {
  Normal normal = Normal::Zero();
  Row right = Row::Zero();
  double square = 0.0;
  std::size_t count = 0;
};

/// The equations of one Gauss-Newton step.  Lengths are in radii, so that all terms are alike.
class Equations {
 public:
  Equations(const CircleTask& task, const CircleErrors& errors) : task_(task), errors_(errors) {}

  void add(const PlaneSamples& samples, const CircleTurn& turn, const FittedRange& range,
           Sums& sums) const {
    const CircleResidual residual(errors_, turn);
    const double swing = turn.omega * kSecondsPerUnit;
    for (std::size_t i = range.begin; i < range.end; i += task_.stride) {
      const Eigen::Vector2d e = residual.corrected(samples.at(i));
      const double r = e.norm();
      const Row row = row_at(e / r, residual.direction(), swing);
      const double off = (r - errors_.radius) / errors_.radius;
      sums.normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
      sums.right += row * off;
      sums.square += off * off;
      ++sums.count;
    }
  }

  /// A mismatch counts in ms beside lengths in radii.
  static constexpr double kSecondsPerUnit = 1e-3;

 private:
  /// What a unit of each error moves the path outwards at a place.
  [[nodiscard]] Row row_at(const Eigen::Vector2d& n, double direction, double swing) const {
    const double both = n.x() * n.y();
    const double xx = n.x() * n.x();
    const double yy = n.y() * n.y();
    Row row;
    row[index_of(CircleTerm::CentreX)] = n.x();
    row[index_of(CircleTerm::CentreY)] = n.y();
    row[index_of(CircleTerm::Size)] = task_.radius ? xx : 1.0;
    row[index_of(CircleTerm::Shape)] = task_.radius ? yy : xx - yy;
    row[index_of(CircleTerm::Squareness)] = both;
    row[index_of(CircleTerm::BacklashX)] = 0.5 * direction * sign_of(n.y()) * n.x();
    row[index_of(CircleTerm::BacklashY)] = -0.5 * direction * sign_of(n.x()) * n.y();
    row[index_of(CircleTerm::Mismatch)] = swing * both;
    return row;
  }

  const CircleTask& task_;
  const CircleErrors& errors_;
};

/// The errors that a row of the solution stands for.
CircleErrors as_errors(const Row& row, const CircleTask& task, double radius) {
  const double size = row[index_of(CircleTerm::Size)];
  const double shape = row[index_of(CircleTerm::Shape)];
  CircleErrors errors;
  errors.centre = radius * row.head<2>();
  errors.radius = task.radius ? 0.0 : radius * size;
  errors.scale = task.radius ? std::array{size, shape} : std::array{shape, -shape};
  errors.squareness = row[index_of(CircleTerm::Squareness)];
  errors.mismatch = row[index_of(CircleTerm::Mismatch)] * Equations::kSecondsPerUnit;
  errors.backlash = {radius * row[index_of(CircleTerm::BacklashX)],
                     radius * row[index_of(CircleTerm::BacklashY)]};
  return errors;
}

CircleErrors sum_of(CircleErrors sum, const CircleErrors& step) {
  sum.centre += step.centre;
  sum.radius += step.radius;
  sum.squareness += step.squareness;
  sum.mismatch += step.mismatch;
  for (std::size_t axis : {0U, 1U}) {
    sum.scale.at(axis) += step.scale.at(axis);
    sum.backlash.at(axis) += step.backlash.at(axis);
  }
  return sum;
}

/// The inverse of the normal matrix without the terms that are not asked for; nullopt: singular.
std::optional<Normal> inverse_of(const Sums& sums, int terms) {
  const Eigen::MatrixXd full = sums.normal.selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd part = full.topLeftCorner(terms, terms);
  const Eigen::VectorXd scale = part.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * part * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
  if (!(solver.eigenvalues().minCoeff() > 1e-6 * solver.eigenvalues().maxCoeff())) {
    return std::nullopt;
  }
  const Eigen::MatrixXd inverse = solver.eigenvectors() *
                                  solver.eigenvalues().cwiseInverse().asDiagonal() *
                                  solver.eigenvectors().transpose();
  Normal whole = Normal::Zero();
  whole.topLeftCorner(terms, terms) = scale.asDiagonal() * inverse * scale.asDiagonal();
  return whole;
}

/// How much larger the variance of sums of neighbours is than that of single residuals: 1 where
/// they know nothing of each other.
double togetherness(const PlaneSamples& samples, const std::vector<CircleTurn>& turns,
                    std::span<const FittedRange> ranges, const CircleErrors& errors,
                    double degrees) {
  double of_sums = 0.0;
  double of_singles = 0.0;
  for (const FittedRange& range : ranges) {
    const CircleTurn& turn = turns[range.turn];
    const CircleResidual residual(errors, turn);
    const double by_angle = turn.angle * 180.0 / std::numbers::pi / degrees;
    const auto length = static_cast<std::size_t>(
        std::max(1.0, static_cast<double>(turn.end - turn.begin) / by_angle));
    for (std::size_t i = range.begin; i < range.end;) {
      const std::size_t end = std::min(i + length, range.end);
      double sum = 0.0;
      for (; i < end; ++i) {
        const double off = residual.at(samples.at(i));
        sum += off;
        of_singles += off * off;
      }
      of_sums += sum * sum;
    }
  }
  return of_singles > 0.0 ? std::max(1.0, of_sums / of_singles) : 1.0;
}

}  // namespace

CircleResidual::CircleResidual(const CircleErrors& errors, const CircleTurn& turn)
    : centre_(errors.centre),
      radius_(errors.radius),
      direction_(turn.direction),
      half_backlash_(0.5 * direction_ * errors.backlash[0],
                     -0.5 * direction_ * errors.backlash[1]) {
  const double half = 0.5 * turn.omega * errors.mismatch;
  Eigen::Matrix2d lag;
  lag << std::cos(half), std::sin(half), std::sin(half), std::cos(half);
  Eigen::Matrix2d axes;
  axes << 1.0 + errors.scale[0], errors.squareness, 0.0, 1.0 + errors.scale[1];
  back_ = (axes * lag).inverse();
}

Eigen::Vector2d CircleResidual::corrected(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - centre_;
  return back_ * Eigen::Vector2d(q.x() - half_backlash_.x() * sign_of(q.y()),
                                 q.y() - half_backlash_.y() * sign_of(q.x()));
}

std::optional<CircleFit> fit_circle(const PlaneSamples& samples,
                                    const std::vector<CircleTurn>& turns,
                                    std::span<const FittedRange> ranges, const CircleTask& task) {
  const auto has = [&](int direction) {
    return std::ranges::any_of(
        ranges, [&](const FittedRange& r) { return turns[r.turn].direction == direction; });
  };
  CircleFit fit;
  fit.has_mismatch = has(1) && has(-1);
  const int terms = fit.has_mismatch ? kTerms : kTerms - 1;
  fit.errors = task.start;
  fit.errors.radius = task.radius.value_or(task.start.radius);
  std::optional<Normal> inverse;
  Sums sums;
  for (int step = 0; step < kMostSteps; ++step) {
    sums = Sums();
    const Equations equations(task, fit.errors);
    for (const FittedRange& range : ranges) {
      equations.add(samples, turns[range.turn], range, sums);
    }
    inverse = inverse_of(sums, terms);
    if (!inverse || sums.count < 2 * kTerms) {
      return std::nullopt;
    }
    const Row row = *inverse * sums.right;
    fit.errors = sum_of(fit.errors, as_errors(row, task, fit.errors.radius));
    if (!(row.cwiseAbs().maxCoeff() > 1e-12)) {
      break;
    }
  }
  const double freedom = static_cast<double>(sums.count) - terms;
  const double variance = sums.square / freedom;
  fit.noise = fit.errors.radius * std::sqrt(variance);
  const double factor = std::max(togetherness(samples, turns, ranges, fit.errors, 3.0),
                                 togetherness(samples, turns, ranges, fit.errors, 15.0));
  const Row u = (variance * factor * inverse->diagonal()).cwiseMax(0.0).cwiseSqrt();
  const double omega = std::abs(turns[ranges.front().turn].omega);
  const double hidden = task.resolution / std::sqrt(12.0) / fit.errors.radius;
  Row floor = Row::Constant(hidden);
  floor[index_of(CircleTerm::Mismatch)] = hidden / (omega * Equations::kSecondsPerUnit);
  fit.u = as_errors((u.cwiseAbs2() + floor.cwiseAbs2()).cwiseSqrt(), task, fit.errors.radius);
  fit.u.scale = {std::abs(fit.u.scale[0]), std::abs(fit.u.scale[1])};
  return fit;
}

}  // namespace g31::metrology
