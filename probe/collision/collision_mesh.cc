#include "probe/collision/collision_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "probe/collision/swept_clearance.h"

namespace g31::probe {
namespace {

/// The way of a section as a tree of boxes sees it: a box about a point that goes along a path.
struct BoxWay {
  parts::Path path;
  Point reach;

  explicit BoxWay(const SweptSection& swept) {
    const Point way = swept.way();
    const double length = way.norm();
    const parts::Box box = swept.start_box();
    path = {0.5 * (box.min + box.max), length > 0.0 ? Point(way / length) : Point(Point::UnitX()),
            length};
    reach = 0.5 * (box.max - box.min) + Point::Constant(kSweptBandMm);
  }
};

/// The fraction up to which the section is free of a triangle that it meets on the whole way.
double free_until(const SweptSection& swept, const ContactTriangle& triangle) {
  constexpr double kFinestMm = 1e-9;
  if (meets(swept.piece(0.0, 0.0), triangle)) {
    return 0.0;
  }
  const double length = swept.longest_way();
  double free = 0.0;
  double met = 1.0;
  while ((met - free) * length > kFinestMm) {
    const double middle = 0.5 * (free + met);
    // Only what is new: short sweeps lose fewer digits.
    (meets(swept.piece(free, middle), triangle) ? met : free) = middle;
  }
  return free;
}

}  // namespace

CollisionMesh::CollisionMesh(const parts::Mesh& mesh_M)
    : CollisionMesh(std::make_shared<const ContactMesh>(mesh_M)) {}

CollisionMesh::CollisionMesh(std::shared_ptr<const ContactMesh> mesh) : mesh_(std::move(mesh)) {}

std::optional<SectionTouch> CollisionMesh::first_touch(const SweptSection& swept) const {
  double fraction = 1.0;
  const ContactTriangle* first = nullptr;
  const BoxWay way(swept);
  SweptSection to_go = swept.piece(0.0, 1.0);
  std::optional<SweptClearance> clearance;  // made when the way comes near
  const auto planes = [&] { return (clearance ? *clearance : clearance.emplace(to_go)).planes(); };
  mesh_->tree().visit_along(way.path, way.reach, planes, [&](std::uint32_t slot) {
    const ContactTriangle& triangle = mesh_->triangles()[slot];
    if ((first == nullptr || fraction > 0.0) && !clearance->is_clear_of(triangle) &&
        meets(to_go, triangle)) {
      fraction *= free_until(to_go, triangle);
      to_go = swept.piece(0.0, fraction);
      clearance->shorten_to(to_go);
      first = &triangle;
    }
    return fraction * way.path.length;
  });
  if (first == nullptr) {
    return std::nullopt;
  }
  const SweptSection at_rest = swept.piece(fraction, fraction);
  const ContactTriangle& met = most_opposed(swept, fraction, *first);
  const NearestPair pair = nearest_pair(at_rest, met);
  SectionTouch touch;
  touch.fraction = fraction;
  touch.p_M_point = pair.p_M_triangle;
  touch.n_M = met.is_sliver() ? Point(Point::UnitZ()) : met.normal;
  const SectionPlace& place = at_rest.from;
  const Point p_met = place.turn.conjugate() * (touch.p_M_point - place.p_M);
  const Point moved =
      swept.to.p_M + swept.to.turn * p_met - swept.from.p_M - swept.from.turn * p_met;
  const double towards = -touch.n_M.dot(moved);
  const ProbeSection& section = *swept.section;
  const Point on_axis(0.0, 0.0, std::clamp(p_met.z(), section.z_bottom, section.z_top));
  const double aside = touch.n_M.dot(place.p_M + place.turn * on_axis - touch.p_M_point);
  if (towards != 0.0 ? towards < 0.0 : aside < 0.0) {
    touch.n_M = -touch.n_M;
  }
  return touch;
}

const ContactTriangle& CollisionMesh::most_opposed(const SweptSection& swept, double fraction,
                                                   const ContactTriangle& first) const {
  SweptSection at_rest = swept.piece(fraction, fraction);
  at_rest.margin += 2.0 * kSectionTouchErrorMm;
  const ContactTriangle* best = &first;
  const Point way = swept.way();
  SweptClearance clearance(at_rest);
  for (const Point& direction : {way, first.normal, Point(-first.normal)}) {
    clearance.add(direction);
  }
  const BoxWay at_place(at_rest);
  const auto planes = [&] { return clearance.planes(); };
  mesh_->tree().visit_along(at_place.path, at_place.reach, planes, [&](std::uint32_t slot) {
    const ContactTriangle& triangle = mesh_->triangles()[slot];
    const bool is_better = std::abs(triangle.normal.dot(way)) > std::abs(best->normal.dot(way));
    if (is_better && !clearance.is_clear_of(triangle) && meets(at_rest, triangle)) {
      best = &triangle;
    }
    return at_place.path.length;
  });
  return *best;
}

}  // namespace g31::probe
