#include "tools/plan/plan_touches.h"

#include <algorithm>

#include "parts/import/step_file.h"
#include "probe/planning/plan_inspection.h"
#include "probe/planning/reach.h"
#include "probe/planning/round_features.h"
#include "probe/sensor/touch_probe.h"

namespace g31::plan {
namespace {

/// A probe of the same shape that is there, on, and gives its signal where it touches.
probe::ProbeSetup perfect(const probe::ProbeSetup& setup) {
  probe::ProbeSetup probe = setup;
  probe.switching = {};
  probe.at_switch = {};
  probe.repeatability_mm = 0.0;
  probe.trigger_delay_s = 0.0;
  probe.state = probe::ProbeState::Ready;
  return probe;
}

/// The highest point of all that stands on the table and of the stock, product frame.
double top_of(const std::vector<probe::ProbedPart>& parts, const Point& p_M_product,
              const parts::Box& stock_P) {
  double top = stock_P.max.z();
  for (const probe::ProbedPart& part : parts) {
    if (part.mount == probe::Mount::Link) {
      continue;
    }
    for (const Point& p_M : part.mesh_M.vertices) {
      top = std::max(top, p_M.z() - p_M_product.z());
    }
  }
  return top;
}

/// What no plan can be made for.
std::optional<session::Refusal> wrong_setup(const setup::Job& job) {
  if (!job.probe || job.probe->in_turret) {
    return session::bad_setup(
        "a plan needs a [probe] in the spindle, and the sheet has none there");
  }
  if (job.parts.back().rotate_deg != Point::Zero()) {
    return session::bad_setup(
        "a plan needs a work offset that is not turned, and G54 of the sheet is");
  }
  const auto shape = job.control.offset_shapes.find("G54");
  const bool is_plain =
      shape == job.control.offset_shapes.end() ||
      (shape->second.mirrored.empty() && shape->second.scale == runtime::OffsetShape{}.scale);
  return is_plain ? std::nullopt
                  : std::optional(session::bad_setup(
                        "a plan needs a work offset that is neither mirrored nor scaled, and G54 "
                        "of the sheet is"));
}

}  // namespace

Result<PlannedTouches, session::Refusal> plan_touches(const setup::Job& job,
                                                      const session::BuiltParts& built,
                                                      const PlannedPart& part,
                                                      std::optional<double> tolerance_mm) {
  const parts::PartSetup& product = job.parts.back();
  if (auto wrong = wrong_setup(job)) {
    return *std::move(wrong);
  }
  const probe::ProbeSetup setup = perfect(*job.probe);
  probe::TouchProbe world(setup, built.parts, 0);
  probe::PlanningOptions options;
  options.ball_radius_mm = setup.ball_diameter_mm / 2;
  // Both walls of a hole are off by as much, and each facet may be by twice its sagitta.
  options.surface_error_mm =
      parts::is_step_file(product.file) ? 2.0 * product.step_sagitta_mm : 0.0;
  if (tolerance_mm) {
    options.tolerance = probe::Tolerance{-*tolerance_mm, *tolerance_mm};
  }
  probe::ProbeWay way;
  way.p_M_product = product.p_M_at;
  way.p_S_ball = {setup.eccentricity_mm[0], setup.eccentricity_mm[1], -setup.length_mm};
  way.ball_radius_mm = options.ball_radius_mm;
  way.clear_z_P = top_of(built.parts, product.p_M_at, part.part.stock_P) + options.ball_radius_mm +
                  options.distances.approach_z;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const machine::AxisSetup& setup_of_axis = job.machine.axes[static_cast<std::size_t>(axis)];
    way.q_M_least[axis] = setup_of_axis.travel_min;
    way.q_M_most[axis] = setup_of_axis.travel_max;
  }
  probe::Reach reach(world, way);
  const auto unreachable = [&reach](const probe::PlannedPoint& point, double error) {
    return reach.problem(point, error);
  };
  PlannedTouches touches{probe::plan_inspection(part.part, part.product_P, options, unreachable),
                         options.ball_radius_mm, way.clear_z_P};
  touches.plan.rounds =
      probe::round_features(part.part, touches.plan, options.ball_radius_mm, way.clear_z_P,
                            [&reach](const Point& from, const Point& to) {
                              return reach.obstacle(from, to, machine::Travel::Feed);
                            });
  return touches;
}

}  // namespace g31::plan
