#include "probe/collision/swept_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include <ccd/ccd.h>

#include "probe/collision/swept_body.h"

namespace g31::probe {
namespace {

static_assert(std::is_same_v<ccd_real_t, double>);

/// libccd takes what is nearer than some 1e-8 of its units as touching.
constexpr double kUnitsPerMm = 1024.0;

/// The last direction that libccd asked both bodies about, and how far each reaches in it.
struct LastQuestion {
  double swept_reach = 0.0;     ///< of the swept section along the direction
  double triangle_reach = 0.0;  ///< of the triangle against the direction
};

/// Either body of a question, in coordinates that begin at the sweep's start.
struct Body {
  const SweptBody* swept = nullptr;
  const ContactTriangle* triangle = nullptr;
  LastQuestion* last = nullptr;
};

Point point_of(const ccd_vec3_t* v) {
  return {ccdVec3X(v), ccdVec3Y(v), ccdVec3Z(v)};
}

void set(ccd_vec3_t* v, const Point& p) {
  const Point scaled = kUnitsPerMm * p;
  ccdVec3Set(v, scaled.x(), scaled.y(), scaled.z());
}

Point furthest_of(const ContactTriangle& triangle, const Point& p_M_origin,
                  const Point& direction) {
  Point best = triangle.vertices[0] - p_M_origin;
  for (const Point& vertex : triangle.vertices) {
    const Point p = vertex - p_M_origin;
    if (p.dot(direction) > best.dot(direction)) {
      best = p;
    }
  }
  return best;
}

void support_of_swept(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* answer) {
  const Body& body = *static_cast<const Body*>(object);
  const Point d = point_of(direction);
  const Point p = body.swept->furthest(d);
  body.last->swept_reach = p.dot(d);
  set(answer, p);
}

void support_of_triangle(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* answer) {
  const Body& body = *static_cast<const Body*>(object);
  const Point d = point_of(direction);
  const Point p = furthest_of(*body.triangle, body.swept->swept().from.p_M, d);
  body.last->triangle_reach = p.dot(d);
  set(answer, p);
}

void from_middle_to_middle(const void* swept_body, const void* triangle_body, ccd_vec3_t* answer) {
  const SweptSection& swept = static_cast<const Body*>(swept_body)->swept->swept();
  const auto& vertices = static_cast<const Body*>(triangle_body)->triangle->vertices;
  const double z = 0.5 * (swept.section->z_bottom + swept.section->z_top);
  const Point middle = swept.from.turn * Point(0.0, 0.0, z) + 0.5 * swept.way();
  const Point triangle_middle = (vertices[0] + vertices[1] + vertices[2]) / 3.0 - swept.from.p_M;
  const Point between = triangle_middle - middle;
  set(answer, between.norm() > 0.0 ? between : Point(1.0, 0.0, 0.0));
}

/// Whether the plane across a direction keeps the bodies apart.
bool separates(const SweptBody& body, const ContactTriangle& triangle, const Point& direction) {
  const double gap = body.furthest(direction).dot(direction) +
                     furthest_of(triangle, body.swept().from.p_M, -direction).dot(-direction);
  return gap < 0.0;
}

}  // namespace

Eigen::Quaterniond turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to,
                                double fraction) {
  return from.coeffs() == to.coeffs() ? from : from.slerp(fraction, to);
}

double sag_of_turn(double radius, const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  if (from.coeffs() == to.coeffs()) {
    return 0.0;
  }
  const double angle_rad = from.angularDistance(to);
  return radius * angle_rad * angle_rad / 8.0;
}

double SweptSection::longest_way() const {
  return way().norm() + (turns() ? reach_of(*section) * from.turn.angularDistance(to.turn) : 0.0);
}

parts::Box SweptSection::start_box() const {
  const SweptBody body(*this);
  const Point shift = way();
  Point low;
  Point high;
  for (int axis = 0; axis < 3; ++axis) {
    const Point unit = Point::Unit(axis);
    // The sweep's own reach, less the way where the way makes it longer.
    high[axis] = body.furthest(unit)[axis] - std::max(0.0, shift[axis]);
    low[axis] = body.furthest(-unit)[axis] - std::min(0.0, shift[axis]);
  }
  if (turns()) {
    // What turns may be widest at the other end of the way.
    low -= shift.cwiseAbs();
    high += shift.cwiseAbs();
  }
  parts::Box box;
  box.include(from.p_M + low);
  box.include(from.p_M + high);
  return box;
}

SectionPlace SweptSection::at(double fraction) const {
  return {from.p_M + fraction * way(), turn_between(from.turn, to.turn, fraction)};
}

SweptSection SweptSection::piece(double begin, double end) const {
  return {section, at(begin), at(end), margin};
}

bool meets(const SweptSection& swept, const ContactTriangle& triangle) {
  // The triangle's face and the sides of the way decide most cases, and exactly where face comes to
  // face.
  const SweptBody body(swept);
  const Point aside(-body.way().y(), body.way().x(), 0.0);
  for (const Point& direction : {triangle.normal, aside}) {
    if (separates(body, triangle, direction) || separates(body, triangle, -direction)) {
      return false;
    }
  }
  LastQuestion last;
  const Body swept_body{&body, nullptr, &last};
  const Body triangle_body{&body, &triangle, &last};
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.first_dir = from_middle_to_middle;
  ccd.support1 = support_of_swept;
  ccd.support2 = support_of_triangle;
  ccd.max_iterations = 200;
  if (ccdGJKIntersect(&swept_body, &triangle_body, &ccd) != 0) {
    return true;
  }
  // libccd also says "apart" when it gives up: then the last plane does not part the bodies.
  return last.swept_reach + last.triangle_reach >= 0.0;
}

NearestPair nearest_pair(const SweptSection& swept, const ContactTriangle& triangle) {
  constexpr int kRounds = 64;
  const ProbeSection& section = *swept.section;
  const SectionPlace& place = swept.from;
  const Point middle(0.0, 0.0, 0.5 * (section.z_bottom + section.z_top));
  NearestPair pair;
  pair.p_M_section = place.p_M + place.turn * middle;
  for (int i = 0; i < kRounds; ++i) {
    pair.p_M_triangle = nearest_of(triangle, pair.p_M_section).point;
    const Point p = place.turn.conjugate() * (pair.p_M_triangle - place.p_M);
    pair.p_M_section = place.p_M + place.turn * nearest_of(section, p);
  }
  const Point out = pair.p_M_triangle - pair.p_M_section;
  const double distance = out.norm();
  if (distance > 0.0) {
    pair.p_M_section += std::min(1.0, section.rounding / distance) * out;
  }
  return pair;
}

}  // namespace g31::probe
