#include "probe/contact/sweep_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"
#include "probe/contact/smooth_normal.h"

namespace g31::probe {
namespace {

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

/// A point as a triangle whose corners are one.
std::shared_ptr<const ContactMesh> mesh_of_point(const Point& p) {
  return std::make_shared<const ContactMesh>(parts::Mesh{{p}, {{0, 0, 0}}});
}

}  // namespace

MeshSweeper::MeshSweeper(const parts::Mesh& mesh_M, double ball_radius)
    : MeshSweeper(std::make_shared<const ContactMesh>(mesh_M), ball_radius) {}

MeshSweeper::MeshSweeper(std::shared_ptr<const ContactMesh> mesh, double ball_radius)
    : skin_(mesh->sphere() ? mesh->sphere()->radius : 0.0),
      radius_(ball_radius + skin_),
      mesh_(mesh->sphere() ? mesh_of_point(mesh->sphere()->centre) : std::move(mesh)),
      offsets_(std::make_unique<OffsetsOnce>()) {
  G31_EXPECTS(std::isfinite(ball_radius) && ball_radius > 0.0);
}

SweepHit MeshSweeper::sweep(const Point& p_M_from, const Point& p_M_to) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  const std::optional<Touch> start = mesh_->nearest_within(p_M_from, radius_ + kTouchBandMm);
  if (start && start->distance < radius_ - kTouchBandMm) {
    return hit_at(SweepStatus::StartInContact, path, {0.0, start->slot});
  }
  if (path.length == 0.0) {
    return {};
  }
  if (!start) {
    const std::optional<Meeting> first = first_meeting(path);
    return first ? hit_at(SweepStatus::Contact, path, *first) : SweepHit{};
  }
  std::optional<Meeting> first = first_meeting_leaving(path, start->distance, kLeaveExactly);
  if (!first) {
    return {};
  }
  // In touch from the start and going in: the contact is here, not where the band is used up.
  const ContactTriangle& triangle = mesh_->triangles()[first->slot];
  if (nearest_of(triangle, p_M_from).distance <= radius_ + kTouchBandMm) {
    first->s = 0.0;
  }
  return hit_at(SweepStatus::Contact, path, *first);
}

SweepHit MeshSweeper::first_contact_leaving(const Point& p_M_from, const Point& p_M_to) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  if (path.length == 0.0) {
    return {};
  }
  const std::optional<Touch> start = mesh_->nearest_within(p_M_from, radius_ + kTouchBandMm);
  const std::optional<Meeting> first =
      start ? first_meeting_leaving(path, start->distance, kLeaveFreely) : first_meeting(path);
  return first ? hit_at(SweepStatus::Contact, path, *first) : SweepHit{};
}

double MeshSweeper::free_share(const Point& p_M_from, const Point& p_M_to, double slack) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  const double radius = radius_ + slack;
  parts::Path rest = path;
  bool met = false;
  if (!comes_near(path, slack)) {
    return 1.0;
  }
  offsets().visit_along(path, slack + kBoxMarginMm, [&](const PatchOwner& patch) {
    // All of the triangle: the way beside this one may meet a feature that this one passes by.
    const ContactTriangle& triangle = mesh_->triangles()[patch.triangle];
    const bool at_once = nearest_of(triangle, path.from).distance <= radius;
    const double s = at_once ? 0.0 : sweep_triangle(rest, triangle, radius);
    if (s <= rest.length) {
      met = true;
      rest.length = s;
    }
    return rest.length;
  });
  if (!met) {
    return 1.0;
  }
  return path.length > 0.0 ? rest.length / path.length : 0.0;
}

std::optional<double> MeshSweeper::distance_if_touching(const Point& p_M_centre) const {
  const std::optional<Touch> touch = mesh_->nearest_within(p_M_centre, radius_ + kTouchBandMm);
  return touch ? std::optional(touch->distance - skin_) : std::nullopt;
}

std::vector<SweepHit> MeshSweeper::contacts_at(const Point& p_M_centre) const {
  std::vector<Touch> touches;
  mesh_->visit_within(p_M_centre, radius_ + kTouchBandMm,
                      [&](std::uint32_t slot, const Nearest& nearest) {
                        touches.push_back({slot, nearest.distance});
                      });
  std::ranges::sort(touches, {}, &Touch::distance);
  std::vector<SweepHit> contacts;
  for (const Touch& touch : touches) {
    const Nearest nearest = nearest_of(mesh_->triangles()[touch.slot], p_M_centre);
    const bool is_known = std::ranges::any_of(contacts, [&](const SweepHit& contact) {
      return contact.n_M.dot(nearest.normal) >= kCreaseCosine;
    });
    if (!is_known && mesh_->rests_at(p_M_centre, nearest)) {
      contacts.push_back(
          hit_at(SweepStatus::StartInContact, {p_M_centre, Point::Zero(), 0.0}, {0.0, touch.slot}));
    }
  }
  return contacts;
}

bool MeshSweeper::can_touch_only(const Point& n_M, const Point& p_M_centre, double reach) const {
  const double within = radius_ + reach + kBoxMarginMm;
  bool only = true;
  mesh_->tree().visit_near(p_M_centre, within, [&](std::uint32_t slot) {
    const Nearest nearest = nearest_of(mesh_->triangles()[slot], p_M_centre);
    // The way to the nearest point of a triangle changes by no more than the centre moves.
    const double along = nearest.distance * nearest.normal.dot(n_M) - reach;
    only = only && (nearest.distance > within || along >= radius_ * kCreaseCosine);
    return only ? within : 0.0;
  });
  return only;
}

StraightLeaving MeshSweeper::leave(const Point& p_M_from, const Point& p_M_to,
                                   double start_distance, const LeavingRule& rule) const {
  const parts::Path path = path_between(p_M_from, p_M_to);
  if (path.length == 0.0) {
    return {{}, 1.0};
  }
  const Leaving leaving = leave_contact(*mesh_, path, radius_, start_distance + skin_, rule);
  if (leaving.stop) {
    return {hit_at(SweepStatus::Contact, path, *leaving.stop), leaving.stop->s / path.length};
  }
  return {{}, std::min(1.0, leaving.free_from / path.length)};
}

std::optional<Meeting> MeshSweeper::first_meeting(const parts::Path& path) const {
  std::optional<Meeting> first;
  if (!comes_near(path, 0.0)) {
    return first;
  }
  parts::Path rest = path;
  offsets().visit_along(path, kBoxMarginMm, [&](const PatchOwner& patch) {
    const double s =
        sweep_triangle(rest, mesh_->triangles()[patch.triangle], patch.features, radius_);
    if (s < rest.length || (!first && s == rest.length)) {
      first = Meeting{s, patch.triangle};
      rest.length = s;
    }
    return rest.length;
  });
  return first;
}

std::optional<Meeting> MeshSweeper::first_meeting_leaving(const parts::Path& path,
                                                          double start_distance,
                                                          const LeavingRule& rule) const {
  const Leaving leaving = leave_contact(*mesh_, path, radius_, start_distance, rule);
  if (leaving.stop || leaving.free_from >= path.length) {
    return leaving.stop;
  }
  const double s = leaving.free_from;
  std::optional<Meeting> first =
      first_meeting({path.from + s * path.direction, path.direction, path.length - s});
  if (first) {
    first->s += s;
  }
  return first;
}

SweepHit MeshSweeper::hit_at(SweepStatus status, const parts::Path& path,
                             const Meeting& meeting) const {
  SweepHit hit;
  hit.status = status;
  hit.s = meeting.s;
  hit.p_M_centre = path.from + meeting.s * path.direction;
  const Nearest nearest = nearest_of(mesh_->triangles()[meeting.slot], hit.p_M_centre);
  hit.p_M_point = nearest.point;
  hit.n_M = nearest.normal;
  hit.triangle = mesh_->index_of(meeting.slot);
  if (skin_ > 0.0) {
    hit.p_M_point += skin_ * nearest.normal;
    hit.triangle = kNoTriangle;
  }
  hit.cos_incidence = -path.direction.dot(nearest.normal);
  return hit;
}

bool MeshSweeper::comes_near(const parts::Path& path, double slack) const {
  return mesh_->tree().may_meet(path, radius_ + slack + kBoxMarginMm);
}

const OffsetTree& MeshSweeper::offsets() const {
  std::call_once(offsets_->made, [&] { offsets_->tree = OffsetTree(*mesh_, radius_); });
  return offsets_->tree;
}

std::size_t MeshSweeper::memory_bytes() const {
  return mesh_->memory_bytes() + offsets().memory_bytes();
}

}  // namespace g31::probe
