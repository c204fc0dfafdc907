#include "probe/collision/swept_section.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include <ccd/ccd.h>

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
  const SweptSection* swept = nullptr;
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

Point furthest_of(const SweptSection& swept, const Point& direction) {
  Point p = furthest_of(*swept.section, direction);
  if (direction.dot(swept.way) > 0.0) {
    p += swept.way;
  }
  const double norm = direction.norm();
  return swept.growth() > 0.0 && norm > 0.0 ? Point(p + swept.growth() / norm * direction) : p;
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
  const Point p = furthest_of(*body.swept, d);
  body.last->swept_reach = p.dot(d);
  set(answer, p);
}

void support_of_triangle(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* answer) {
  const Body& body = *static_cast<const Body*>(object);
  const Point d = point_of(direction);
  const Point p = furthest_of(*body.triangle, body.swept->p_M_from, d);
  body.last->triangle_reach = p.dot(d);
  set(answer, p);
}

void from_middle_to_middle(const void* swept_body, const void* triangle_body, ccd_vec3_t* answer) {
  const SweptSection& swept = *static_cast<const Body*>(swept_body)->swept;
  const auto& vertices = static_cast<const Body*>(triangle_body)->triangle->vertices;
  const double z = 0.5 * (swept.section->z_bottom + swept.section->z_top);
  const Point middle = Point(0.0, 0.0, z) + 0.5 * swept.way;
  const Point triangle_middle = (vertices[0] + vertices[1] + vertices[2]) / 3.0 - swept.p_M_from;
  const Point between = triangle_middle - middle;
  set(answer, between.norm() > 0.0 ? between : Point(1.0, 0.0, 0.0));
}

/// Whether the plane across a direction keeps the bodies apart.
bool separates(const SweptSection& swept, const ContactTriangle& triangle, const Point& direction) {
  const double gap = furthest_of(swept, direction).dot(direction) +
                     furthest_of(triangle, swept.p_M_from, -direction).dot(-direction);
  return gap < 0.0;
}

}  // namespace

parts::Box SweptSection::start_box() const {
  const double radius = std::max(section->radius_bottom, section->radius_top) + growth();
  parts::Box box;
  box.include(p_M_from + Point(-radius, -radius, section->z_bottom - growth()));
  box.include(p_M_from + Point(radius, radius, section->z_top + growth()));
  return box;
}

SweptSection SweptSection::piece(double begin, double end) const {
  SweptSection part = *this;
  part.p_M_from += begin * way;
  part.way *= end - begin;
  return part;
}

bool meets(const SweptSection& swept, const ContactTriangle& triangle) {
  // The triangle's face and the sides of the way decide most cases, and exactly where face comes to
  // face.
  const Point aside(-swept.way.y(), swept.way.x(), 0.0);
  for (const Point& direction : {triangle.normal, aside}) {
    if (separates(swept, triangle, direction) || separates(swept, triangle, -direction)) {
      return false;
    }
  }
  LastQuestion last;
  const Body swept_body{&swept, nullptr, &last};
  const Body triangle_body{&swept, &triangle, &last};
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
  const Point middle(0.0, 0.0, 0.5 * (section.z_bottom + section.z_top));
  NearestPair pair;
  pair.p_M_section = swept.p_M_from + middle;
  for (int i = 0; i < kRounds; ++i) {
    pair.p_M_triangle = nearest_of(triangle, pair.p_M_section).point;
    pair.p_M_section = swept.p_M_from + nearest_of(section, pair.p_M_triangle - swept.p_M_from);
  }
  const Point out = pair.p_M_triangle - pair.p_M_section;
  const double distance = out.norm();
  if (distance > 0.0) {
    pair.p_M_section += std::min(1.0, section.rounding / distance) * out;
  }
  return pair;
}

}  // namespace g31::probe
