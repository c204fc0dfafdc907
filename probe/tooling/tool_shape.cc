#include "probe/tooling/tool_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "machine/base/contract.h"
#include "machine/units/turn_from_z.h"

namespace g31::probe {
namespace {

double corner_radius_of(const ToolSetup& tool, double radius) {
  const double wanted = tool.kind == ToolKind::BallMill ? radius
                        : tool.kind == ToolKind::Mill || tool.kind == ToolKind::BullMill
                            ? tool.corner_radius_mm
                            : 0.0;
  return std::min(wanted, radius);
}

/// Where the edges end above: the gauge line, or the rear side of a side mill.
double top_of_edges(const ToolSetup& tool) {
  return tool.cutting_length_mm > 0.0 ? tool.cutting_length_mm - tool.length_mm : 0.0;
}

/// A cylinder from z = top down to z = -length, its edges rounded.
ProbeSection rounded_cylinder(double radius, double top, double length, double rounding) {
  ProbeSection section;
  section.z_bottom = -length + rounding;
  section.z_top = std::max(section.z_bottom, top - rounding);
  section.radius_bottom = section.radius_top = radius - rounding;
  section.rounding = rounding;
  return section;
}

/// Down to where the cone of a drill begins, and the cone.
std::vector<ConvexShape> round_pieces(const ToolSetup& tool) {
  const double radius = 0.5 * tool.diameter_mm;
  const double cone = cone_height(tool, radius);
  const double rounding = corner_radius_of(tool, radius);
  std::vector<ConvexShape> pieces = {
      rounded_cylinder(radius, top_of_edges(tool), tool.length_mm - cone, rounding)};
  if (cone > 0.0) {
    ProbeSection tip;
    tip.z_bottom = -tool.length_mm;
    tip.z_top = -tool.length_mm + cone;
    tip.radius_top = radius;
    pieces.emplace_back(tip);
  }
  return pieces;
}

/// The body of revolution that one tooth cuts.
std::vector<ConvexShape> envelope_of(const Tooth& tooth, const ToolSetup& tool) {
  ToolSetup round = tool;
  round.diameter_mm = 2.0 * tooth.radius_mm;
  if (tool.cutting_length_mm > 0.0) {
    round.cutting_length_mm += tooth.length_mm - tool.length_mm;
  }
  round.length_mm = tooth.length_mm;
  return round_pieces(round);
}

/// The middle of the tip radius, as seen from the theoretical tip, in tip radii: X, Z.
std::array<double, 2> centre_from_tip(int edge_position) {
  constexpr std::array<std::array<double, 2>, 9> kCentres = {
      {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {0, -1}, {-1, 0}, {0, 1}, {1, 0}, {0, 0}}};
  G31_EXPECTS(edge_position >= 1 && edge_position <= 9);
  return kCentres[static_cast<std::size_t>(edge_position - 1)];
}

Point tip_of(const ToolSetup& tool) {
  if (tool.kind != ToolKind::Turning) {
    return {0.0, 0.0, -tool.length_mm};
  }
  const auto& [l1, l2, l3] = tool.insert.lengths_mm;
  return {-l1, -l3, -l2};
}

ProbeSection nose_of(const Insert& insert, const Point& p_T_tip) {
  const auto [x, z] = centre_from_tip(insert.edge_position);
  ProbeSection nose;
  nose.rounding = insert.tip_radius_mm;
  nose.p_S = p_T_tip + insert.tip_radius_mm * Point(x, 0.0, z);
  return nose;
}

/// The direction of its middle from the tip: Z, X.
double orientation_of(const Insert& insert) {
  const auto [x, z] = centre_from_tip(insert.edge_position);
  return insert.orientation_deg ? kRadPerDeg * *insert.orientation_deg : std::atan2(x, z);
}

/// Its edges touch the tip radius.
InsertPlate plate_of(const Insert& insert, const Point& p_T_tip_centre) {
  InsertPlate plate;
  plate.p_tip_centre = p_T_tip_centre;
  plate.tip_radius = insert.tip_radius_mm;
  for (const double side : {-1.0, 1.0}) {
    const double angle = orientation_of(insert) + side * 0.5 * kRadPerDeg * insert.angle_deg;
    const Point along(std::sin(angle), 0.0, std::cos(angle));
    const Point outwards(side * std::cos(angle), 0.0, -side * std::sin(angle));
    plate.edge_ends.at(side > 0.0 ? 1 : 0) =
        p_T_tip_centre + insert.tip_radius_mm * outwards + insert.edge_length_mm * along;
  }
  return plate;
}

ConvexShape rod_between(const Point& from, const Point& to) {
  constexpr double kThin = 0.005;  // mm
  const Point way = to - from;
  ProbeSection rod;
  rod.z_top = way.norm();
  rod.rounding = kThin;
  rod.turn_S = turn_from_z(way);
  rod.p_S = from;
  return rod;
}

/// All around it, as thin as meshes can be asked about: its edges and its back, for nothing comes
/// into the plate in its plane but past them.
std::vector<ConvexShape> edges_of(const InsertPlate& plate) {
  const auto& [first, second] = plate.edge_ends;
  return {rod_between(plate.p_tip_centre, first), rod_between(plate.p_tip_centre, second),
          rod_between(first, second)};
}

double reach_of(const ConvexShape& shape, const Point& p_T_tip) {
  double reach = 0.0;
  for (const Point& direction :
       {Point(Point::UnitX()), Point(-Point::UnitX()), Point(Point::UnitY()),
        Point(-Point::UnitY()), Point(Point::UnitZ()), Point(-Point::UnitZ())}) {
    const double across = std::abs(direction.dot(furthest_of(shape, direction) - p_T_tip));
    reach = std::hypot(reach, across);
  }
  return reach;
}

/// The height of the lower edge of a tooth at a radius, or at the axis where that is higher.
double lower_edge_at(const Blade& blade, double radius) {
  const double beside = radius - blade.rounded_centre.x();
  const double corner = blade.rounded_centre.y() - blade.rounded_radius;
  const double inner = blade.corners.front().y();
  if (beside <= 0.0) {
    const double share = blade.rounded_centre.x() > 0.0 ? radius / blade.rounded_centre.x() : 1.0;
    return std::max(inner, inner + share * (corner - inner));
  }
  return std::max(inner, blade.rounded_centre.y() -
                             std::sqrt(std::max(0.0, blade.rounded_radius * blade.rounded_radius -
                                                         beside * beside)));
}

/// A cylinder that ends where it is behind the lower edges of all teeth.
ProbeSection core_of(const ToolSetup& tool) {
  ProbeSection core;
  core.radius_bottom = core.radius_top = 0.5 * tool.core_diameter_mm;
  core.z_bottom = -tool.length_mm;
  for (const Tooth& tooth : tool.teeth) {
    core.z_bottom =
        std::max(core.z_bottom, lower_edge_at(profile_of(tooth, tool), core.radius_bottom));
  }
  core.z_top = std::max(core.z_bottom, top_of_edges(tool));
  return core;
}

}  // namespace

double cone_height(const ToolSetup& tool, double radius) {
  return tool.kind == ToolKind::Drill ? radius / std::tan(kRadPerDeg * 0.5 * tool.tip_angle_deg)
                                      : 0.0;
}

Blade blade_of(const Tooth& tooth, const ToolSetup& tool) {
  const double angle = kRadPerDeg * tooth.angle_deg;
  Blade blade = profile_of(tooth, tool);
  blade.direction = {std::cos(angle), std::sin(angle)};
  return blade;
}

Blade profile_of(const Tooth& tooth, const ToolSetup& tool) {
  static const double kDish = std::tan(kRadPerDeg * kDishDeg);
  const double bottom = -tooth.length_mm;
  const double cone = cone_height(tool, tooth.radius_mm);
  Blade blade;
  blade.rounded_radius = corner_radius_of(tool, tooth.radius_mm);
  const double flat = tooth.radius_mm - blade.rounded_radius;
  const double dish = tool.kind == ToolKind::Drill ? 0.0 : flat * kDish;
  blade.rounded_centre = {flat, bottom + cone + blade.rounded_radius};
  const double top = std::max(top_of_edges(tool), blade.rounded_centre.y());
  blade.corners = {Blade::Radial(0.0, bottom + dish), Blade::Radial(0.0, top),
                   Blade::Radial(tooth.radius_mm, top), blade.rounded_centre};
  return blade;
}

std::vector<ProbeSection> round_sections_of(const std::vector<ConvexShape>& pieces,
                                            const Point& p_T_tip) {
  std::vector<ProbeSection> sections;
  for (const ConvexShape& piece : pieces) {
    if (const auto* const section = std::get_if<ProbeSection>(&piece)) {
      sections.push_back(*section);
      sections.back().p_S -= p_T_tip;
    }
  }
  return sections;
}

Tooth outline_of(const ToolSetup& tool) {
  G31_EXPECTS(!tool.teeth.empty());
  Tooth outline = tool.teeth.front();
  for (const Tooth& tooth : tool.teeth) {
    outline.radius_mm = std::max(outline.radius_mm, tooth.radius_mm);
    outline.length_mm = std::max(outline.length_mm, tooth.length_mm);
  }
  return outline;
}

TeethProfiles profiles_of(const ToolSetup& tool) {
  TeethProfiles profiles;
  for (const Tooth& tooth : tool.teeth) {
    profiles.of_teeth.push_back(profile_of(tooth, tool));
  }
  profiles.outline = profile_of(outline_of(tool), tool);
  return profiles;
}

ToolShape shape_of(const ToolSetup& tool) {
  G31_EXPECTS(tool.kind != ToolKind::Probe);
  ToolShape shape;
  shape.p_T_tip = tip_of(tool);
  if (tool.kind == ToolKind::Turning) {
    const ProbeSection nose = nose_of(tool.insert, shape.p_T_tip);
    shape.still = {nose};
    if (tool.insert.angle_deg > 0.0) {
      const InsertPlate plate = plate_of(tool.insert, nose.p_S);
      shape.still.emplace_back(plate);
      shape.edges = edges_of(plate);
    }
    shape.envelope = shape.still;
  } else if (tool.teeth.empty()) {
    shape.still = round_pieces(tool);
    shape.envelope = shape.still;
  } else {
    for (const Tooth& tooth : tool.teeth) {
      shape.still.emplace_back(blade_of(tooth, tool));
    }
    if (tool.core_diameter_mm > 0.0) {
      shape.still.emplace_back(core_of(tool));
    }
    shape.envelope = envelope_of(outline_of(tool), tool);
    shape.profiles = profiles_of(tool);
  }
  for (ProbeSection body : tool.bodies) {
    body.p_S += shape.p_T_tip;
    shape.bodies.emplace_back(body);
  }
  for (const auto* const pieces : {&shape.still, &shape.envelope, &shape.bodies}) {
    for (const ConvexShape& piece : *pieces) {
      shape.reach_mm = std::max(shape.reach_mm, reach_of(piece, shape.p_T_tip));
    }
  }
  return shape;
}

}  // namespace g31::probe
