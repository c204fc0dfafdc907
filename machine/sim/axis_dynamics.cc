#include "machine/sim/axis_dynamics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

constexpr double kSecondsPerMinute = 60.0;

/// What each axis has at most of the unit vector that points to the middle of an arc, which begins
/// in one direction and ends in another.
/// @param before, behind  unit vectors, neither the same nor opposite
AxisPositions steepest_between(const AxisPositions& before, const AxisPositions& behind) {
  const double cosine = before.dot(behind);
  const AxisPositions across = (behind - cosine * before).normalized();
  const double sine = across.dot(behind);
  const double turn = std::atan2(sine, cosine);
  AxisPositions most = AxisPositions::Zero();
  for (Eigen::Index i = 0; i < most.size(); ++i) {
    // After a turn by t: cos(t) across - sin(t) before; its peak may lie within the turn.
    const double peak = std::atan2(-before[i], across[i]);
    const bool peaks = (peak > 0.0 ? peak : peak + std::numbers::pi) < turn;
    most[i] = peaks
                  ? std::hypot(across[i], before[i])
                  : std::max(std::abs(across[i]), std::abs(cosine * across[i] - sine * before[i]));
  }
  return most;
}

}  // namespace

AxisDynamics::AxisDynamics(const MachineSetup& setup) {
  // An absent axis never moves, so it never limits: 0 / infinity is 0.
  rapid_per_s_.setConstant(std::numeric_limits<double>::infinity());
  acceleration_per_s2_ = rapid_per_s_;
  contour_acceleration_per_s2_ = rapid_per_s_;
  corner_jump_per_s_ = rapid_per_s_;
  jerk_per_s3_ = rapid_per_s_;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const AxisSetup& axis = setup.axes[i];
    if (axis.present) {
      G31_EXPECTS(axis.rapid_per_min > 0.0 && std::isfinite(axis.rapid_per_min));
      G31_EXPECTS(axis.acceleration_per_s2 > 0.0 && std::isfinite(axis.acceleration_per_s2));
      const auto row = static_cast<Eigen::Index>(i);
      rapid_per_s_[row] = axis.rapid_per_min / kSecondsPerMinute;
      acceleration_per_s2_[row] = axis.acceleration_per_s2;
      const double contour = axis.contour_acceleration_per_s2;
      G31_EXPECTS(contour >= 0.0 && std::isfinite(contour));
      contour_acceleration_per_s2_[row] = contour > 0.0 ? contour : axis.acceleration_per_s2;
      corner_jump_per_s_[row] = axis.corner_jump_per_min
                                    ? *axis.corner_jump_per_min / kSecondsPerMinute
                                    : kCornerS * axis.acceleration_per_s2;
      G31_EXPECTS(axis.jerk_per_s3 >= 0.0 && std::isfinite(axis.jerk_per_s3));
      if (axis.jerk_per_s3 > 0.0) {
        jerk_per_s3_[row] = axis.jerk_per_s3;
        limits_jerk_ = true;
      }
    }
  }
  own_corner_jump_per_s_ = corner_jump_per_s_;
}

void AxisDynamics::set_corner_jumps(const AxisPositions& per_s) {
  corner_jump_per_s_ = (per_s.array() >= 0.0).select(per_s, own_corner_jump_per_s_);
}

void AxisDynamics::set_jerks(const AxisPositions& per_s3) {
  G31_EXPECTS((per_s3.array() >= 0.0).all() && per_s3.allFinite());
  for (Eigen::Index i = 0; i < per_s3.size(); ++i) {
    jerk_per_s3_[i] = per_s3[i] > 0.0 ? per_s3[i] : std::numeric_limits<double>::infinity();
  }
  limits_jerk_ = !per_s3.isZero(0.0);
}

AxisPositions AxisDynamics::jerks() const {
  return jerk_per_s3_.array().isFinite().select(jerk_per_s3_, 0.0);
}

double AxisDynamics::jerk_along(double length, const AxisPositions& way) const {
  const double slowest = way.cwiseQuotient(jerk_per_s3_).maxCoeff();
  return slowest > 0.0 ? length / slowest : 0.0;
}

[[gnu::hot]] PathLimits AxisDynamics::limits(const StraightPath& path,
                                             const LinearMove& move) const {
  G31_EXPECTS(path.moves());
  const AxisPositions way = path.displacement().cwiseAbs();
  const double fastest = path.length() / way.cwiseQuotient(rapid_per_s_).maxCoeff();
  const AxisPositions& most =
      accelerations(move.traverse == Traverse::Feed ? move.contour_control : ContourControl::Off);
  const double acceleration = path.length() / way.cwiseQuotient(most).maxCoeff();
  const double speed = move.traverse == Traverse::Rapid
                           ? fastest
                           : std::min(fastest, move.feed_mm_min / kSecondsPerMinute);
  const bool limits_jerk = limits_jerk_ && move.smoothness.limits_jerk;
  return {speed, acceleration, limits_jerk ? jerk_along(path.length(), way) : 0.0};
}

MotionProfile AxisDynamics::profile(const StraightPath& path, const LinearMove& move) const {
  const PathLimits most = limits(path, move);
  return MotionProfile(path.length(), most.speed, most.acceleration, most.jerk);
}

std::optional<IndependentPath> AxisDynamics::independent_path(const StraightPath& straight,
                                                              const LinearMove& move) const {
  if (move.traverse != Traverse::Rapid || move.rapid_path == RapidPath::Straight ||
      (straight.displacement().array() != 0.0).count() < 2) {
    return std::nullopt;
  }
  IndependentPath::Profiles profiles;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double way = std::abs(straight.displacement()[axis]);
    if (way > 0.0) {
      const double jerk = jerk_per_s3_[axis];
      profiles[i].emplace(way, rapid_per_s_[axis], acceleration_per_s2_[axis],
                          move.smoothness.limits_jerk && std::isfinite(jerk) ? jerk : 0.0);
    }
  }
  return IndependentPath(straight.from(), straight.to(), profiles);
}

double AxisDynamics::jerk_on(const ArcPath& path, const AxisPositions& helix) const {
  const double in_plane =
      std::min(jerk_per_s3_[path.first_axis()], jerk_per_s3_[path.second_axis()]) /
      std::numbers::sqrt2;
  const double along_helix = jerk_along(path.length(), helix);
  const double jerk = along_helix > 0.0 ? std::min(in_plane, along_helix) : in_plane;
  return std::isfinite(jerk) ? jerk : 0.0;
}

[[gnu::hot]] PathLimits AxisDynamics::limits(const ArcPath& path, double feed_mm_min,
                                             ContourControl contour_control,
                                             const Smoothness& smoothness) const {
  G31_EXPECTS(path.length() > 0.0);
  const int first = path.first_axis();
  const int second = path.second_axis();
  const AxisPositions& most = accelerations(contour_control);
  const double in_plane = std::min(most[first], most[second]) / std::numbers::sqrt2;

  double helix_speed = std::numeric_limits<double>::infinity();
  double helix_acceleration = helix_speed;
  const AxisPositions helix = with_two(path.displacement().cwiseAbs(), first, 0.0, second, 0.0);
  if (!helix.isZero(0.0)) {
    helix_speed = path.length() / helix.cwiseQuotient(rapid_per_s_).maxCoeff();
    helix_acceleration = path.length() / helix.cwiseQuotient(most).maxCoeff();
  }

  const double speed =
      std::min({feed_mm_min / kSecondsPerMinute, rapid_per_s_[first], rapid_per_s_[second],
                std::sqrt(in_plane * path.radius()), helix_speed});
  return {speed, std::min(in_plane, helix_acceleration),
          limits_jerk_ && smoothness.limits_jerk ? jerk_on(path, helix) : 0.0};
}

MotionProfile AxisDynamics::profile(const ArcPath& path, double feed_mm_min) const {
  const PathLimits most = limits(path, feed_mm_min);
  return MotionProfile(path.length(), most.speed, most.acceleration, most.jerk);
}

[[gnu::hot]] PathLimits AxisDynamics::limits(const LedPath& path, const LinearMove& move) const {
  G31_EXPECTS(path.length() > 0.0);
  const AxisPositions& most =
      accelerations(move.traverse == Traverse::Feed ? move.contour_control : ContourControl::Off);
  const int pieces = path.piece_count();
  const double piece = path.length() / pieces;
  AxisPositions steepest = AxisPositions::Zero();
  AxisPositions most_bent = AxisPositions::Zero();
  AxisPositions before = AxisPositions::Zero();
  AxisPositions q_M = path.from();
  for (int i = 1; i <= pieces; ++i) {
    const AxisPositions q_M_next = path.at(static_cast<double>(i) / pieces);
    const AxisPositions slope = (q_M_next - q_M) / piece;
    steepest = steepest.cwiseMax(slope.cwiseAbs());
    if (i > 1) {
      most_bent = most_bent.cwiseMax((slope - before).cwiseAbs() / piece);
    }
    before = slope;
    q_M = q_M_next;
  }
  const double fastest = 1.0 / steepest.cwiseQuotient(rapid_per_s_).maxCoeff();
  const double bent = 2.0 * most_bent.cwiseQuotient(most).maxCoeff();
  const double wanted = move.traverse == Traverse::Rapid ? std::numeric_limits<double>::infinity()
                                                         : move.feed_mm_min / kSecondsPerMinute;
  const double speed = std::min({fastest, wanted, 1.0 / std::sqrt(bent)});
  const double acceleration = 0.5 / steepest.cwiseQuotient(most).maxCoeff();
  const bool limits_jerk = limits_jerk_ && move.smoothness.limits_jerk;
  return {speed, acceleration, limits_jerk ? jerk_along(1.0, steepest) : 0.0};
}

[[gnu::hot]] double AxisDynamics::corner_speed(const AxisPositions& along_before,
                                               const AxisPositions& along_behind) const {
  const AxisPositions change = (along_behind - along_before).cwiseAbs();
  // All axes are divided at once, without a branch: which of them turn is not to be foretold.
  const AxisPositions times_s = change.cwiseQuotient(corner_jump_per_s_);
  double slowest = 0.0;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    slowest = std::max(slowest, change[i] > kSameDirection ? times_s[i] : 0.0);
  }
  return slowest > 0.0 ? 1.0 / slowest : std::numeric_limits<double>::infinity();
}

double AxisDynamics::curve_speed(const AxisPositions& along_before,
                                 const AxisPositions& along_behind, const CornerCurve& most) const {
  // The chord of the two unit directions is 2 sin(turn / 2), their sum 2 cos(turn / 2).
  const AxisPositions before = along_before.normalized();
  const AxisPositions behind = along_behind.normalized();
  const double opposite = (behind - before).norm();
  const double adjacent = (behind + before).norm();
  if (opposite < kSameDirection) {
    return std::numeric_limits<double>::infinity();
  }
  const double tangent = opposite / adjacent;
  const double cosine = adjacent / 2.0;
  // 1 - cos(t) = sin(t)^2 / (1 + cos(t)) keeps its digits where the turn is small.
  const double sine = opposite / 2.0;
  const double by_tolerance = most.tolerance * cosine * (1.0 + cosine) / (sine * sine);
  const double radius = std::min(by_tolerance, most.half_length / tangent);
  if (radius <= 0.0) {
    return 0.0;
  }
  const AxisPositions pointing = steepest_between(before, behind);
  return std::sqrt(radius / pointing.cwiseQuotient(contour_acceleration_per_s2_).maxCoeff());
}

}  // namespace g31::machine
