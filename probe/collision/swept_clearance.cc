#include "probe/collision/swept_clearance.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::probe {
namespace {

/// The vertex that lies least far in a direction.
const Point& first_along(const ContactTriangle& triangle, const Point& direction) {
  return *std::ranges::min_element(triangle.vertices, {},
                                   [&](const Point& vertex) { return vertex.dot(direction); });
}

/// From about the point that is nearest to p of all that the section goes over, to p.
Point out_of_way(const SweptBody& body, const Point& p_M) {
  const ProbeSection& section = *body.swept().section;
  const Eigen::Quaterniond& turn = body.swept().from.turn;
  const Point& way = body.way();
  const auto out_at = [&](double share) {
    const Point p = p_M - body.swept().from.p_M - share * way;
    return Point(p - turn * nearest_of(section, turn.conjugate() * p));
  };
  // The distance is least where the way out stands across the way: the zero of `along` by false
  // position, with half the weight for an end that stays (Illinois).
  constexpr int kMostRounds = 24;
  constexpr double kAcross = 1e-3;  // cosine
  const double length = way.norm();
  double begin = 0.0;
  double end = 1.0;
  Point out = out_at(begin);
  double along_at_begin = out.dot(way);
  if (along_at_begin <= 0.0) {
    return out;
  }
  const Point out_at_end = out_at(end);
  double along_at_end = out_at_end.dot(way);
  if (along_at_end >= 0.0) {
    return out_at_end;
  }
  double along_before = 0.0;
  for (int round = 0; round < kMostRounds; ++round) {
    const double middle = begin + (end - begin) * along_at_begin / (along_at_begin - along_at_end);
    out = out_at(middle);
    const double along = out.dot(way);
    double& staying = along > 0.0 ? along_at_end : along_at_begin;
    staying *= along * along_before > 0.0 ? 0.5 : 1.0;
    (along > 0.0 ? begin : end) = middle;
    (along > 0.0 ? along_at_begin : along_at_end) = along;
    along_before = along;
    if (std::abs(along) <= kAcross * out.norm() * length) {
      break;
    }
  }
  return out - out.dot(way) / way.squaredNorm() * way;
}

}  // namespace

SweptClearance::SweptClearance(const SweptSection& swept) : body_(swept) {
  const Point& way = body_.way();
  const Point axis = swept.from.turn * Point::UnitZ();
  const Point aside = axis.cross(way);
  for (const Point& direction : {aside, way, axis}) {
    add(direction);
    add(-direction);
  }
}

void SweptClearance::shorten_to(const SweptSection& swept) {
  body_ = SweptBody(swept);
  for (std::size_t i = 0; i < count_; ++i) {
    planes_[i] = plane_across(planes_[i].normal);
  }
}

void SweptClearance::add(const Point& direction) {
  G31_EXPECTS(count_ == staying_ && count_ < kMostStaying);
  if (!direction.isZero(0.0)) {
    planes_[count_++] = plane_across(direction.normalized());
    oldest_found_ = staying_ = count_;
  }
}

bool SweptClearance::is_clear_of(const ContactTriangle& triangle) {
  for (const parts::Plane& plane : planes()) {
    if (first_along(triangle, plane.normal).dot(plane.normal) > plane.limit) {
      return true;
    }
  }
  // By turns the point of the section nearest to one of the triangle, and the other way round.
  constexpr int kRounds = 3;
  Point p_M = (triangle.vertices[0] + triangle.vertices[1] + triangle.vertices[2]) / 3.0;
  for (int round = 0; round < kRounds; ++round) {
    const Point out = out_of_way(body_, p_M);
    if (out.isZero(0.0)) {
      return false;
    }
    const parts::Plane plane = plane_across(out.normalized());
    if (first_along(triangle, plane.normal).dot(plane.normal) > plane.limit) {
      keep(plane);
      return true;
    }
    p_M = nearest_of(triangle, p_M - out).point;
  }
  return false;
}

parts::Plane SweptClearance::plane_across(const Point& normal) const {
  const Point furthest = body_.swept().from.p_M + body_.furthest(normal);
  return {normal, furthest.dot(normal) + kClearMm};
}

void SweptClearance::keep(const parts::Plane& plane) {
  if (count_ < kMostPlanes) {
    planes_[count_++] = plane;
    return;
  }
  planes_[oldest_found_] = plane;
  oldest_found_ = oldest_found_ + 1 < kMostPlanes ? oldest_found_ + 1 : staying_;
}

}  // namespace g31::probe
