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
  const machine::Contact contact = contact_of(hit, part->name);
  if (hit.status == SweepStatus::StartInContact) {
    return machine::SkipTrigger{0.0, true, 0.0, contact};
  }
  const double length = (ball_centre(sweep.q_M_to) - ball_centre(sweep.q_M_from)).norm();
  return trigger_at(hit.s, length, contact, event);
}

std::optional<machine::SkipTrigger> TouchProbe::first_trigger_along(
    std::span<const machine::Waypoint> way) {
  const std::uint64_t event = triggers_asked_++;
  const double length = (ball_centre(way.back().q_M) - ball_centre(way.front().q_M)).norm();
  if (length == 0.0) {
    return std::nullopt;
  }
  bool moved = false;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const machine::Waypoint& from = way[i - 1];
    const machine::Waypoint& to = way[i];
    const double piece = (ball_centre(to.q_M) - ball_centre(from.q_M)).norm();
    if (piece == 0.0) {
      continue;
    }
    const auto [hit, part] = first_hit({from.q_M, to.q_M}, &MeshSweeper::sweep);
    if (part != nullptr) {
      const machine::Contact contact = contact_of(hit, part->name);
      const bool in_contact = hit.status == SweepStatus::StartInContact;
      if (in_contact && !moved) {
        return machine::SkipTrigger{0.0, true, 0.0, contact};
      }
      const double part_of_piece = in_contact ? 0.0 : hit.s / piece;
      const double fraction = from.fraction + part_of_piece * (to.fraction - from.fraction);
      return trigger_at(fraction * length, length, contact, event);
    }
    moved = true;
  }
  return std::nullopt;
}

machine::SkipTrigger TouchProbe::trigger_at(double distance_mm, double length_mm,
                                            const machine::Contact& contact,
                                            std::uint64_t event) const {
  double shift = 0.0;
  if (setup_.repeatability_mm > 0.0) {
    shift = setup_.repeatability_mm * standard_normal({seed_, kRepeatabilityStream}, event);
  }
  machine::SkipTrigger trigger;
  trigger.fraction = std::clamp((distance_mm + shift) / length_mm, 0.0, 1.0);
  trigger.delay_s = setup_.trigger_delay_s;
  trigger.contact = contact;
  return trigger;
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
