#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "machine/port/surroundings.h"
#include "parts/geometry/mesh.h"
#include "probe/contact/sweep_mesh.h"
#include "probe/sensor/probe_setup.h"

namespace g31::probe {

/// A part on the machine table, where it stands.
struct ProbedPart {
  std::string name;
  parts::Mesh mesh_M;  ///< mm, machine frame
};

/// A touch probe in the spindle among parts: answers the machine with its stylus ball.
///
/// The ball centre stands at the linear axes + (eccentricity X, eccentricity Y, -length).  Only
/// linear axes move it; of the stylus only the ball is solid.
///
/// The signal opens where the ball truly touches, shifted along the move by a normal random number
/// of standard deviation `repeatability_mm`, but never out of the move.  The n-th question for a
/// trigger takes the n-th random number, whether it touches or not: the same seed and program give
/// the same touches.
///
/// Accuracy: the contact as MeshSweeper finds it, kContactErrorMm.
class TouchProbe final : public machine::Surroundings {
 public:
  /// @param seed  of every random model; with repeatability 0 it does not matter
  TouchProbe(const ProbeSetup& setup, const std::vector<ProbedPart>& parts, std::uint64_t seed);

  /// The contact in the answer is the true one; `fraction` carries the random shift.
  std::optional<machine::SkipTrigger> first_trigger(const machine::Sweep& sweep) override;

  std::optional<machine::SkipTrigger> first_trigger_along(
      std::span<const machine::Waypoint> way) override;

  /// The ball touching a part.  Leaving a contact is free, pushing deeper into it is not.
  std::optional<machine::Obstacle> first_collision(const machine::Sweep& sweep) override;

  /// Accuracy: kCurveErrorMm.
  std::optional<machine::Obstacle> first_collision_on_curve(
      const machine::CurvedSweep& sweep) override;

 private:
  struct Part {
    std::string name;
    MeshSweeper sweeper;
  };
  struct PartHit {
    SweepHit hit;
    const Part* part = nullptr;  ///< none: no part was met
  };
  using Question = SweepHit (MeshSweeper::*)(const Point&, const Point&) const;

  /// The random shift of a trigger along the move, mm.
  [[nodiscard]] double trigger_shift(std::uint64_t event) const;
  [[nodiscard]] Point ball_centre(const AxisPositions& q_M) const;
  [[nodiscard]] PartHit first_hit(const machine::Sweep& sweep, Question question) const;

  ProbeSetup setup_;
  std::vector<Part> parts_;
  std::uint64_t seed_;
  std::uint64_t triggers_asked_ = 0;
};

}  // namespace g31::probe
