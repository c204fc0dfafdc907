#include "probe/contact/sweep_mesh.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "probe/contact/offset_patches.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {
namespace {

/// The tree is asked for this much beyond the radius: far more than roundoff, hardly any work.
constexpr double kBoxMarginMm = 1e-8;

/// A shorter move has no direction; only the overlap at its start counts.
constexpr double kShortestMoveMm = 1e-12;

/// What a Patch can number.
constexpr std::size_t kMostTriangles = 1U << 28U;

parts::Path path_between(const Point& from, const Point& to) {
  const Point travel = to - from;
  const double length = travel.norm();
  if (length < kShortestMoveMm) {
    return {from, Point::Zero(), 0.0};
  }
  return {from, travel / length, length};
}

std::vector<parts::Box> boxes_of(const std::vector<OffsetPatch>& patches) {
  std::vector<parts::Box> boxes;
  boxes.reserve(patches.size());
  for (const OffsetPatch& patch : patches) {
    boxes.push_back(patch.box);
  }
  return boxes;
}

}  // namespace

MeshSweeper::MeshSweeper(const parts::Mesh& mesh_M, double ball_radius)
    : radius_(ball_radius), tree_(parts::triangle_boxes(mesh_M)) {
  G31_EXPECTS(std::isfinite(ball_radius) && ball_radius > 0.0);
  G31_EXPECTS(mesh_M.triangles.size() < kMostTriangles);
  triangles_.reserve(mesh_M.triangles.size());
  parts::Mesh in_slot_order{mesh_M.vertices, {}};
  in_slot_order.triangles.reserve(mesh_M.triangles.size());
  for (const std::uint32_t index : tree_.order()) {
    const auto& corners = mesh_M.triangles[index];
    in_slot_order.triangles.push_back(corners);
    triangles_.emplace_back(mesh_M.vertices[corners[0]], mesh_M.vertices[corners[1]],
                            mesh_M.vertices[corners[2]]);
  }
  const std::vector<OffsetPatch> patches = offset_patches(in_slot_order, triangles_, radius_);
  patch_tree_ = parts::Bvh(boxes_of(patches));
  patches_.reserve(patches.size());
  for (const std::uint32_t index : patch_tree_.order()) {
    patches_.emplace_back(patches[index].features, patches[index].triangle);
  }
}

SweepHit MeshSweeper::sweep(const Point& p_M_from, const Point& p_M_to) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  const std::optional<Touch> start = touch_at(p_M_from);
  if (start && start->distance < radius_ - kTouchBandMm) {
    return hit_at(SweepStatus::StartInContact, path, {0.0, start->slot});
  }
  std::optional<Meeting> first = start ? first_meeting_leaving(path) : first_meeting(path);
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
  const std::optional<Meeting> first =
      touch_at(p_M_from) ? first_meeting_leaving(path) : first_meeting(path);
  return first ? hit_at(SweepStatus::Contact, path, *first) : SweepHit{};
}

std::optional<MeshSweeper::Touch> MeshSweeper::touch_at(const Point& p_M_centre) const {
  std::optional<Touch> deepest;
  double reach = radius_ + kTouchBandMm;
  tree_.visit_near(p_M_centre, reach + kBoxMarginMm, [&](std::uint32_t slot) {
    const double distance = nearest_of(triangles_[slot], p_M_centre).distance;
    if (distance < reach || (!deepest && distance == reach)) {
      deepest = Touch{slot, distance};
      reach = distance;
    }
    return reach + kBoxMarginMm;
  });
  return deepest;
}

double MeshSweeper::free_radius(std::uint32_t slot, const Point& p_M_from) const {
  const double distance = nearest_of(triangles_[slot], p_M_from).distance;
  return distance <= radius_ + kTouchBandMm ? std::min(distance, radius_) - kTouchBandMm : radius_;
}

std::optional<MeshSweeper::Meeting> MeshSweeper::first_meeting(const parts::Path& path) const {
  std::optional<Meeting> first;
  if (path.length == 0.0) {
    return first;
  }
  parts::Path rest = path;
  patch_tree_.visit_along(path, kBoxMarginMm, [&](std::uint32_t i) {
    const Patch patch = patches_[i];
    const double s = sweep_triangle(rest, triangles_[patch.slot()], patch.features(), radius_);
    if (s < rest.length || (!first && s == rest.length)) {
      first = Meeting{s, patch.slot()};
      rest.length = s;
    }
    return rest.length;
  });
  return first;
}

std::optional<MeshSweeper::Meeting> MeshSweeper::first_meeting_leaving(
    const parts::Path& path) const {
  std::optional<Meeting> first;
  if (path.length == 0.0) {
    return first;
  }
  parts::Path rest = path;
  tree_.visit_along(path, radius_ + kBoxMarginMm, [&](std::uint32_t slot) {
    const double radius = free_radius(slot, path.from);
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
