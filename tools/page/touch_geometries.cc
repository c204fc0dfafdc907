#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/page/run_report.h"
#include "tools/picture/stylus_shape.h"

namespace g31::page {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

}  // namespace

TouchGeometries geometries_of(const RunPage& run) {
  const auto& touches = run.recorder.touches();
  TouchGeometries geometries(touches.size());
  std::vector<Point> along(touches.size(), Point::Zero());
  std::size_t next = 0;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    while (next < run.ways.size() && run.ways[next].time_to_s < touches[i].time_s) {
      ++next;
    }
    // Without a way of its own the axes did not move: the signal was there already.
    if (next < run.ways.size() && run.ways[next].time_to_s == touches[i].time_s &&
        run.ways[next].kind == picture::PathKind::Skip) {
      const std::vector<Point>& points = run.ways[next].points;
      along[i] = points.back() - points.front();
      geometries[i].p_M_ball = points.back();
    }
  }
  // Each touch with a contact has left a mark, unless the budget was spent with it.
  auto mark = run.contacts.begin();
  for (std::size_t i = 0; i < touches.size() && mark != run.contacts.end(); ++i) {
    if (!touches[i].contact) {
      continue;
    }
    TouchGeometry& geometry = geometries[i];
    geometry.p_M_ball = mark->stylus.p_M;
    geometry.touching = mark->ball;
    geometry.p_M_contact = mark->p_M;
    geometry.n_M = mark->n_M;
    if (!along[i].isZero(0.0)) {
      const double cosine = std::clamp(-mark->n_M.dot(along[i].normalized()), -1.0, 1.0);
      geometry.angle_deg = std::acos(cosine) * kDegreesPerRadian;
      geometry.deviation_mm = picture::latched_depth_mm(*mark);
    }
    ++mark;
  }
  return geometries;
}

}  // namespace g31::page
