#include "probe/metrology/least_squares_circle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace g31::metrology {
namespace {

double angle_about(const Eigen::Vector2d& centre, const Eigen::Vector2d& point) {
  const Eigen::Vector2d q = point - centre;
  return std::atan2(q.y(), q.x());
}

void add_turn(const PlaneSamples& samples, const CircleTurn& turn, const Eigen::Vector2d& centre,
              CircleStep& step) {
  const auto angle = [&](std::size_t i) { return angle_about(centre, samples.at(i)); };
  double from_last = 0.0;
  double here = angle(turn.begin);
  for (std::size_t i = turn.begin; i < turn.end; ++i) {
    samples.look();
    const double next = i + 1 < turn.end ? angle(i + 1) : here;
    const double to_next = std::abs(shorter_way(next - here));
    step.add(samples.at(i), 0.5 * (from_last + to_next));
    from_last = to_next;
    here = next;
  }
}

}  // namespace

void CircleStep::add(const Eigen::Vector2d& point, double weight) {
  const Eigen::Vector2d q = point - from_.centre;
  const double r = q.norm();
  if (r == 0.0) {
    return;
  }
  const Eigen::Vector3d row(q.x() / r, q.y() / r, 1.0);
  normal_ += weight * row * row.transpose();
  right_ += row * (weight * (r - from_.radius));
}

Circle CircleStep::taken() const {
  const Eigen::Vector3d step = normal_.ldlt().solve(right_);
  if (!step.allFinite()) {
    return from_;
  }
  return {from_.centre + step.head<2>(), from_.radius + step[2]};
}

Circle least_squares_circle(const PlaneSamples& samples, std::span<const CircleTurn> turns,
                            const Circle& near) {
  constexpr int kMostRounds = 20;
  constexpr double kAtRest = 1e-14;
  Circle circle = near;
  for (int round = 0; round < kMostRounds; ++round) {
    CircleStep step(circle);
    for (const CircleTurn& turn : turns) {
      add_turn(samples, turn, circle.centre, step);
    }
    const Circle better = step.taken();
    const double moved =
        (better.centre - circle.centre).norm() + std::abs(better.radius - circle.radius);
    circle = better;
    if (moved <= kAtRest * circle.radius) {
      break;
    }
  }
  return circle;
}

}  // namespace g31::metrology
