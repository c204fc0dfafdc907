#include "probe/contact/sweep_mesh.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {
namespace {

/// The tree is asked for this much beyond the radius: far more than roundoff, hardly any work.
constexpr double kBoxMarginMm = 1e-8;

/// A shorter move has no direction; only the overlap at its start counts.
constexpr double kShortestMoveMm = 1e-12;

parts::Path path_between(const Point& from, const Point& to) {
  const Point travel = to - from;
  const double length = travel.norm();
  if (length < kShortestMoveMm) {
    return {from, Point::Zero(), 0.0};
  }
  return {from, travel / length, length};
}

}  // namespace

MeshSweeper::MeshSweeper(const parts::Mesh& mesh_M, double ball_radius)
    : radius_(ball_radius), tree_(parts::triangle_boxes(mesh_M)) {
  G31_EXPECTS(std::isfinite(ball_radius) && ball_radius > 0.0);
  triangles_.reserve(mesh_M.triangles.size());
  for (const std::uint32_t index : tree_.order()) {
    const auto& corners = mesh_M.triangles[index];
    triangles_.emplace_back(mesh_M.vertices[corners[0]], mesh_M.vertices[corners[1]],
                            mesh_M.vertices[corners[2]]);
  }
}

SweepHit MeshSweeper::sweep(const Point& p_M_from, const Point& p_M_to) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  const std::optional<Touch> start = touch_at(p_M_from);
  if (start && start->distance < radius_ - kTouchBandMm) {
    return hit_at(SweepStatus::StartInContact, path, {0.0, start->slot});
  }
  std::optional<Meeting> first = first_meeting(path, start.has_value());
  if (!first) {
    return {};
  }
  // In touch from the start and going in: the contact is here, not where the band is used up.
  if (start && free_radius(first->slot, p_M_from) < radius_) {
    first->s = 0.0;
  }
  return hit_at(SweepStatus::Contact, path, *first);
}

SweepHit MeshSweeper::first_contact_leaving(const Point& p_M_from, const Point& p_M_to) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  const std::optional<Meeting> first = first_meeting(path, touch_at(p_M_from).has_value());
  return first ? hit_at(SweepStatus::Contact, path, *first) : SweepHit{};
}

std::optional<MeshSweeper::Touch> MeshSweeper::touch_at(const Point& p_M_centre) const {
  std::optional<Touch> deepest;
  tree_.visit_near(p_M_centre, radius_ + kBoxMarginMm, [&](std::uint32_t slot) {
    const double distance = nearest_of(triangles_[slot], p_M_centre).distance;
    if (distance <= radius_ + kTouchBandMm && (!deepest || distance < deepest->distance)) {
      deepest = Touch{slot, distance};
    }
  });
  return deepest;
}

double MeshSweeper::free_radius(std::uint32_t slot, const Point& p_M_from) const {
  const double distance = nearest_of(triangles_[slot], p_M_from).distance;
  return distance <= radius_ + kTouchBandMm ? std::min(distance, radius_) - kTouchBandMm : radius_;
}

std::optional<MeshSweeper::Meeting> MeshSweeper::first_meeting(const parts::Path& path,
                                                               bool starts_in_touch) const {
  std::optional<Meeting> first;
  if (path.length == 0.0) {
    return first;
  }
  parts::Path rest = path;
  tree_.visit_along(path, radius_ + kBoxMarginMm, [&](std::uint32_t slot) {
    const double radius = starts_in_touch ? free_radius(slot, path.from) : radius_;
    const double s = radius > 0.0 ? sweep_triangle(rest, triangles_[slot], radius) : kNoContact;
    if (s < rest.length || (!first && s == rest.length)) {
      first = Meeting{s, slot};
      rest.length = s;
    }
    return rest.length;
  });
  return first;
}

SweepHit MeshSweeper::hit_at(SweepStatus status, const parts::Path& path,
                             const Meeting& meeting) const {
  SweepHit hit;
  hit.status = status;
  hit.s = meeting.s;
  hit.p_M_centre = path.from + meeting.s * path.direction;
  const Nearest nearest = nearest_of(triangles_[meeting.slot], hit.p_M_centre);
  hit.p_M_point = nearest.point;
  hit.n_M = nearest.normal;
  hit.triangle = tree_.order()[meeting.slot];
  hit.cos_incidence = -path.direction.dot(nearest.normal);
  return hit;
}

}  // namespace g31::probe
