#include "probe/metrology/circle_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/QR>

#include "probe/metrology/circle_terms.h"

namespace g31::metrology {
namespace {

constexpr int kMostNewtonSteps = 12;
using Normal =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostCircleTerms, kMostCircleTerms>;

struct Sums {
  Normal normal;
  CircleRow right;
  double square = 0.0;
  std::size_t count = 0;
};

/// The equations of one Gauss-Newton step.
Sums equations(const PlaneSamples& samples, const std::vector<CircleTurn>& turns,
               std::span<const FittedRange> ranges, const CircleTask& task,
               const CircleColumns& columns, const CircleErrors& errors) {
  Sums sums{Normal::Zero(columns.count(), columns.count()), CircleRow::Zero(columns.count())};
  CircleRow row;
  for (const FittedRange& range : ranges) {
    const CircleTurn& turn = turns[range.turn];
    const CircleResidual residual(errors, turn);
    for (std::size_t i = range.begin; i < range.end; i += task.stride) {
      samples.look();
      const Eigen::Vector2d e = residual.corrected(samples.at(i));
      columns.fill(row, residual.axes_at(samples.at(i)), e.normalized(), turn);
      const double off = residual.outside(e) / errors.radius;
      sums.normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
      sums.right += row * off;
      sums.square += off * off;
      ++sums.count;
    }
  }
  return sums;
}

CircleErrors sum_of(CircleErrors sum, const CircleErrors& step) {
  sum.centre += step.centre;
  sum.radius += step.radius;
  sum.squareness += step.squareness;
  sum.mismatch += step.mismatch;
  for (std::size_t axis : {0U, 1U}) {
    sum.scale.at(axis) += step.scale.at(axis);
    sum.backlash.at(axis) += step.backlash.at(axis);
    sum.cyclic.at(axis).sine += step.cyclic.at(axis).sine;
    sum.cyclic.at(axis).cosine += step.cyclic.at(axis).cosine;
  }
  for (std::size_t i = 0; i < sum.lobes.size(); ++i) {
    sum.lobes.at(i).sine += step.lobes.at(i).sine;
    sum.lobes.at(i).cosine += step.lobes.at(i).cosine;
  }
  return sum;
}

/// The inverse of the normal matrix; nullopt: singular.
std::optional<Normal> inverse_of(const Sums& sums) {
  constexpr double kSingular = 1e-6;
  const Eigen::MatrixXd part = sums.normal.selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd scale = part.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(scale.asDiagonal() * part *
                                                     scale.asDiagonal());
  solver.setThreshold(kSingular);
  if (!solver.isInvertible()) {
    return std::nullopt;
  }
  Normal inverse(part.rows(), part.cols());
  for (Eigen::Index i = 0; i < part.cols(); ++i) {
    const Eigen::VectorXd column = solver.solve(Eigen::VectorXd::Unit(part.rows(), i));
    inverse.col(i) = scale[i] * scale.cwiseProduct(column);
  }
  return inverse;
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

void add_uncertainties(const CircleTask& task, const CircleColumns& columns, const Normal& inverse,
                       double omega, CircleFit& fit) {
  const double radius = fit.errors.radius;
  const auto spread = [&](const CircleRow& row) {
    CircleErrors errors = columns.as_errors(row, radius);
    errors.scale = {std::abs(errors.scale[0]), std::abs(errors.scale[1])};
    return errors;
  };
  const CircleRow by_mm = inverse.diagonal().cwiseMax(0.0).cwiseSqrt() / radius;
  const double step = task.resolution / std::sqrt(12.0) / radius;
  CircleRow hidden = CircleRow::Constant(columns.count(), step);
  if (fit.has_mismatch) {
    hidden[columns.column_of(CircleTerm::Mismatch)] =
        step / (omega * CircleColumns::kSecondsPerUnit);
  }
  fit.by_scatter = spread(by_mm);
  fit.hidden = spread(hidden);
  fit.u = spread(((fit.scatter * by_mm).cwiseAbs2() + hidden.cwiseAbs2()).cwiseSqrt());
}

/// Sums over a range, from its means: of time by time and of time by angle.
Eigen::Vector2d time_products(const PlaneSamples& samples, const FittedRange& range,
                              const CircleResidual& residual) {
  double count = 0.0;
  double angle = 0.0;  // unwrapped, from the first sample
  double before = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();      // of time and angle
  Eigen::Vector2d product = Eigen::Vector2d::Zero();  // time by time and time by angle
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Eigen::Vector2d e = residual.corrected(samples.at(i));
    const double now = std::atan2(e.y(), e.x());
    angle += count > 0.0 ? shorter_way(now - before) : 0.0;
    before = now;
    const double time = samples.t[i] - samples.t[range.begin];
    sum += Eigen::Vector2d(time, angle);
    product += time * Eigen::Vector2d(time, angle);
    count += 1.0;
  }
  return product - sum * (sum.x() / count);
}

}  // namespace

std::optional<CircleFit> fit_circle(const PlaneSamples& samples,
                                    const std::vector<CircleTurn>& turns,
                                    std::span<const FittedRange> ranges, const CircleTask& task) {
  const auto has = [&](int direction) {
    return std::ranges::any_of(
        ranges, [&](const FittedRange& r) { return turns[r.turn].direction == direction; });
  };
  CircleFit fit;
  fit.has_mismatch = has(1) && has(-1);
  const CircleColumns columns(
      {task.radius.has_value(), fit.has_mismatch, task.start.pitches, task.has_lobes});
  const double terms = static_cast<double>(columns.count());
  fit.errors = task.start;
  fit.errors.radius = task.radius.value_or(task.start.radius);
  std::optional<Normal> inverse;
  Sums sums;
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    sums = equations(samples, turns, ranges, task, columns, fit.errors);
    inverse = inverse_of(sums);
    if (!inverse || static_cast<double>(sums.count) < 2.0 * terms) {
      return std::nullopt;
    }
    const CircleRow row = *inverse * sums.right;
    fit.errors = sum_of(fit.errors, columns.as_errors(row, fit.errors.radius));
    if (!(row.cwiseAbs().maxCoeff() > 1e-12)) {
      break;
    }
  }
  fit.noise =
      fit.errors.radius * std::sqrt(sums.square / (static_cast<double>(sums.count) - terms));
  const double factor = std::max(togetherness(samples, turns, ranges, fit.errors, 3.0),
                                 togetherness(samples, turns, ranges, fit.errors, 15.0));
  fit.scatter = fit.noise * std::sqrt(factor);
  add_uncertainties(task, columns, *inverse, std::abs(turns[ranges.front().turn].omega), fit);
  return fit;
}

void refine_speeds(const PlaneSamples& samples, std::span<const FittedRange> ranges,
                   const CircleErrors& errors, std::vector<CircleTurn>& turns) {
  std::vector<Eigen::Vector2d> sums(turns.size(), Eigen::Vector2d::Zero());
  for (const FittedRange& range : ranges) {
    sums[range.turn] += time_products(samples, range, CircleResidual(errors, turns[range.turn]));
  }
  for (std::size_t k = 0; k < turns.size(); ++k) {
    if (sums[k].x() > 0.0) {
      turns[k].omega = sums[k].y() / sums[k].x();
    }
  }
}

}  // namespace g31::metrology
