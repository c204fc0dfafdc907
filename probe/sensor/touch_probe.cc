#include "probe/sensor/touch_probe.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "machine/base/random.h"
#include "probe/contact/sweep_curve.h"

namespace g31::probe {
namespace {

/// The random stream of the trigger's repeatability; other models take other numbers.
constexpr std::uint32_t kRepeatabilityStream = 1;

machine::Contact contact_of(const SweepHit& hit, const std::string& part) {
  return {hit.p_M_point, hit.n_M, part};
}

machine::Obstacle obstacle_at(double fraction, const SweepHit& hit, const std::string& part) {
  return {std::clamp(fraction, 0.0, 1.0), "stylus ball touches " + part, contact_of(hit, part)};
}

}  // namespace

TouchProbe::TouchProbe(const ProbeSetup& setup, const std::vector<ProbedPart>& parts,
                       std::uint64_t seed)
    : setup_(setup), seed_(seed) {
  G31_EXPECTS(setup.ball_diameter_mm > 0.0);
  G31_EXPECTS(setup.trigger_delay_s >= 0.0);
  G31_EXPECTS(setup.repeatability_mm >= 0.0);
  parts_.reserve(parts.size());
  for (const ProbedPart& part : parts) {
    parts_.push_back({part.name, MeshSweeper(part.mesh_M, 0.5 * setup.ball_diameter_mm)});
  }
}

std::optional<machine::SkipTrigger> TouchProbe::first_trigger(const machine::Sweep& sweep) {
  const std::uint64_t event = triggers_asked_++;
  const auto [hit, part] = first_hit(sweep, &MeshSweeper::sweep);
  if (part == nullptr) {
    return std::nullopt;
  }
  machine::SkipTrigger trigger;
  trigger.contact = contact_of(hit, part->name);
  if (hit.status == SweepStatus::StartInContact) {
    trigger.on_at_start = true;
    return trigger;
  }
  trigger.delay_s = setup_.trigger_delay_s;
  const double length = (ball_centre(sweep.q_M_to) - ball_centre(sweep.q_M_from)).norm();
  trigger.fraction = std::clamp((hit.s + trigger_shift(event)) / length, 0.0, 1.0);
  return trigger;
}

std::optional<machine::SkipTrigger> TouchProbe::first_trigger_along(
    std::span<const machine::Waypoint> way) {
  const std::uint64_t event = triggers_asked_++;
  double gone = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double piece = machine::distance_mm(way[i - 1].q_M, way[i].q_M);
    if (piece == 0.0) {
      continue;
    }
    const auto [hit, part] = first_hit({way[i - 1].q_M, way[i].q_M}, &MeshSweeper::sweep);
    if (part != nullptr) {
      machine::SkipTrigger trigger;
      trigger.contact = contact_of(hit, part->name);
      trigger.on_at_start = hit.status == SweepStatus::StartInContact && gone == 0.0;
      if (!trigger.on_at_start) {
        trigger.delay_s = setup_.trigger_delay_s;
        trigger.fraction = machine::fraction_after(way, gone + hit.s + trigger_shift(event));
      }
      return trigger;
    }
    gone += piece;
  }
  return std::nullopt;
}

double TouchProbe::trigger_shift(std::uint64_t event) const {
  return setup_.repeatability_mm > 0.0
             ? setup_.repeatability_mm * standard_normal({seed_, kRepeatabilityStream}, event)
             : 0.0;
}

std::optional<machine::Obstacle> TouchProbe::first_collision(const machine::Sweep& sweep) {
  const auto [hit, part] = first_hit(sweep, &MeshSweeper::first_contact_leaving);
  if (part == nullptr) {
    return std::nullopt;
  }
  const double length = (ball_centre(sweep.q_M_to) - ball_centre(sweep.q_M_from)).norm();
  return obstacle_at(hit.s / length, hit, part->name);
}

std::optional<machine::Obstacle> TouchProbe::first_collision_on_curve(
    const machine::CurvedSweep& sweep) {
  const Curve curve{[&](double t) { return ball_centre(sweep.q_M_at(t)); }, sweep.bend};
  std::optional<machine::Obstacle> first;
  for (const Part& part : parts_) {
    const auto [t, hit] = first_contact_leaving_on_curve(part.sweeper, curve);
    if (hit.status != SweepStatus::Miss && (!first || t < first->fraction)) {
      first = obstacle_at(t, hit, part.name);
    }
  }
  return first;
}

Point TouchProbe::ball_centre(const AxisPositions& q_M) const {
  return linear_axes(q_M) +
         Point(setup_.eccentricity_mm[0], setup_.eccentricity_mm[1], -setup_.length_mm);
}

TouchProbe::PartHit TouchProbe::first_hit(const machine::Sweep& sweep, Question question) const {
  const Point p_M_from = ball_centre(sweep.q_M_from);
  const Point p_M_to = ball_centre(sweep.q_M_to);
  PartHit first;
  for (const Part& part : parts_) {
    const SweepHit hit = (part.sweeper.*question)(p_M_from, p_M_to);
    if (hit.status == SweepStatus::StartInContact) {
      return {hit, &part};
    }
    if (hit.status == SweepStatus::Contact && (first.part == nullptr || hit.s < first.hit.s)) {
      first = {hit, &part};
    }
  }
  return first;
}

}  // namespace g31::probe
