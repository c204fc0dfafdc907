#include "tools/picture/stylus_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "probe/sensor/bodies.h"
#include "probe/tooling/tool_shape.h"
#include "tools/picture/tip.h"

namespace g31::picture {
namespace {

/// Half a circle from its lowest point to its highest one, or a part of it.
void add_arc(std::vector<Eigen::Vector2d>& profile, const Eigen::Vector2d& middle, double radius,
             double from_rad, double to_rad) {
  constexpr int kPieces = 12;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / kPieces;
    profile.emplace_back(std::max(0.0, middle.x() + radius * std::cos(angle)),
                         middle.y() + radius * std::sin(angle));
  }
}

constexpr double kQuarter = std::numbers::pi / 2.0;

parts::Mesh ball_of(double radius) {
  std::vector<Eigen::Vector2d> profile;
  add_arc(profile, {0.0, 0.0}, radius, -kQuarter, kQuarter);
  return turned_body(profile);
}

/// In its own frame.
parts::Mesh mesh_of(const probe::ProbeSection& section) {
  const Eigen::Vector2d bottom(section.radius_bottom, section.z_bottom);
  const Eigen::Vector2d top(section.radius_top, section.z_top);
  std::vector<Eigen::Vector2d> profile;
  if (section.rounding > 0.0) {
    profile.emplace_back(0.0, section.z_bottom - section.rounding);
    add_arc(profile, bottom, section.rounding, -kQuarter, 0.0);
    add_arc(profile, top, section.rounding, 0.0, kQuarter);
    profile.emplace_back(0.0, section.z_top + section.rounding);
  } else {
    profile = {{0.0, section.z_bottom}, bottom, top, {0.0, section.z_top}};
  }
  return turned_body(profile);
}

parts::Mesh moved(parts::Mesh mesh, const Eigen::Quaterniond& turn, const Point& by) {
  const Eigen::Matrix3d R = turn.toRotationMatrix();
  for (Point& p : mesh.vertices) {
    p = R * p + by;
  }
  return mesh;
}

const probe::ToolSetup* tool_of(const setup::Job& job, int tool) {
  const auto found = std::ranges::find(job.tools, tool, &probe::ToolSetup::number);
  const bool is_tool = tool != 0 && found != job.tools.end();
  return is_tool && found->kind != probe::ToolKind::Probe ? &*found : nullptr;
}

/// The plate of an insert from both of its faces: as far as it reaches in each direction.
parts::Mesh faces_of(const probe::InsertPlate& plate, const Point& p_T_tip) {
  constexpr int kDirections = 144;
  parts::Mesh mesh;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kDirections;
    const Point p = probe::furthest_of(plate, Point(std::cos(angle), 0.0, std::sin(angle)));
    if (mesh.vertices.empty() || (p - p_T_tip - mesh.vertices.back()).norm() > 1e-9) {
      mesh.vertices.push_back(p - p_T_tip);
    }
  }
  for (std::uint32_t i = 1; i + 1 < mesh.vertices.size(); ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({0, i + 1, i});
  }
  return mesh;
}

/// What it takes up while it turns; of an insert its tip radius and its plate.
void add_tool(const probe::ToolSetup& tool, std::vector<StylusPiece>& pieces) {
  const probe::ToolShape shape = probe::shape_of(tool);
  for (const probe::ProbeSection& section :
       probe::round_sections_of(shape.envelope, tip_of(tool))) {
    if (std::max({section.radius_bottom, section.radius_top, section.rounding}) > 0.0) {
      pieces.push_back({fmt::format("tool {}", tool.number), false,
                        moved(mesh_of(section), section.turn_S, section.p_S)});
    }
  }
  for (const probe::ConvexShape& piece : shape.envelope) {
    if (const auto* const plate = std::get_if<probe::InsertPlate>(&piece)) {
      pieces.push_back(
          {fmt::format("tool {}", tool.number), false, faces_of(*plate, tip_of(tool))});
    }
  }
  for (const probe::ProbeSection& body : tool.bodies) {
    pieces.push_back({body.name, false, moved(mesh_of(body), body.turn_S, body.p_S)});
  }
}

}  // namespace

parts::Mesh turned_body(const std::vector<Eigen::Vector2d>& profile, int sides) {
  parts::Mesh mesh;
  const auto count = static_cast<std::uint32_t>(sides);
  for (const Eigen::Vector2d& p : profile) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      mesh.vertices.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = ring * count + i;
      const std::uint32_t b = ring * count + (i + 1) % count;
      // At an end on the axis one of the two has no area.
      if (profile[ring].x() > 0.0) {
        mesh.triangles.push_back({a, b, b + count});
      }
      if (profile[ring + 1].x() > 0.0) {
        mesh.triangles.push_back({a, b + count, a + count});
      }
    }
  }
  return mesh;
}

parts::Mesh standing_at(const parts::Mesh& mesh_S, const StylusPlace& place) {
  return moved(mesh_S, place.turn, place.p_M);
}

double tip_radius(const setup::Job& job, int tool) {
  if (const probe::ToolSetup* const setup = tool_of(job, tool)) {
    return setup->kind == probe::ToolKind::Turning ? setup->insert.tip_radius_mm
                                                   : 0.5 * setup->diameter_mm;
  }
  return tool == 0 && job.probe ? 0.5 * job.probe->ball_diameter_mm : 0.0;
}

std::optional<TouchingBall> touching_ball(const setup::Job& job, const Mark& mark) {
  if (tool_of(job, mark.stylus.tool) != nullptr || !job.probe) {
    const double radius = tip_radius(job, mark.stylus.tool);
    return radius > 0.0 ? std::optional(TouchingBall{mark.stylus.p_M, radius}) : std::nullopt;
  }
  std::optional<TouchingBall> nearest;
  double least = std::numeric_limits<double>::infinity();
  std::optional<Point> p_S_main;
  for (const probe::ToolBody& body : probe::bodies_of(*job.probe)) {
    const auto* const ball = std::get_if<probe::Ball>(&body.shape);
    if (ball == nullptr || ball->radius_mm <= 0.0) {
      continue;
    }
    p_S_main = p_S_main.value_or(ball->p_S_centre);
    const Point p_M = mark.stylus.p_M + mark.stylus.turn * (ball->p_S_centre - *p_S_main);
    const double away = (p_M - ball->radius_mm * mark.n_M - mark.p_M).norm();
    if (away < least) {
      nearest = {p_M, ball->radius_mm};
      least = away;
    }
  }
  return nearest;
}

std::optional<double> latched_depth_mm(const Mark& mark) {
  return mark.ball && mark.stylus.tool == 0
             ? std::optional(mark.ball->radius_mm - mark.n_M.dot(mark.ball->p_M - mark.p_M))
             : std::nullopt;
}

std::vector<StylusPiece> stylus_shape(const setup::Job& job, int tool) {
  std::vector<StylusPiece> pieces;
  if (const probe::ToolSetup* const setup = tool_of(job, tool)) {
    add_tool(*setup, pieces);
    return pieces;
  }
  if (!job.probe) {
    return pieces;
  }
  const std::vector<probe::ToolBody> bodies = probe::bodies_of(*job.probe);
  Point p_S_main = Point::Zero();  // from the gauge point
  for (const probe::ToolBody& body : bodies) {
    if (const auto* ball = std::get_if<probe::Ball>(&body.shape)) {
      p_S_main = pieces.empty() ? ball->p_S_centre : p_S_main;
      pieces.push_back({body.name, true,
                        moved(ball_of(ball->radius_mm), Eigen::Quaterniond::Identity(),
                              ball->p_S_centre - p_S_main),
                        ball->p_S_centre - p_S_main, ball->radius_mm});
    } else {
      const auto& section = std::get<probe::ProbeSection>(body.shape);
      pieces.push_back({body.name, false, moved(mesh_of(section), section.turn_S, section.p_S)});
    }
  }
  return pieces;
}

}  // namespace g31::picture
