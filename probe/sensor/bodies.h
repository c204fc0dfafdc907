#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "machine/port/surroundings.h"
#include "parts/geometry/mesh.h"
#include "parts/geometry/sphere.h"
#include "probe/collision/probe_section.h"
#include "probe/sensor/probe_setup.h"

namespace g31::probe {

/// What a body is there for.
enum class Role {
  Part,           ///< is measured and cut
  SensingTip,     ///< gives a signal where it touches a part: a stylus ball
  SensingTarget,  ///< gives a signal where a tool touches it: the plate of a tool probe
  Cutter,         ///< cuts parts
  Rigid,          ///< touches nothing: stem, holder, clamp
};

/// What carries a body.  Bodies on the tool's side meet those on the work's side.
enum class Mount {
  Spindle,      ///< comes and goes with the tool
  TurretPlace,  ///< the same on a lathe
  Table,        ///< goes along with the part
  WorkSpindle,  ///< the same on a lathe
  Bed,          ///< what the turning tables stand on: what of the machine no linear axis moves
  Link,         ///< a link of the chain of axes: a body of the machine
};

constexpr bool is_on_tool_side(Mount mount) {
  return mount == Mount::Spindle || mount == Mount::TurretPlace;
}

/// What it means that two bodies meet.
enum class Encounter {
  Free,
  Signal,    ///< of the input of what senses
  Obstacle,  ///< a collision
};

/// Who may touch whom (encounters.def).
Encounter encounter_of(Role a, Role b, machine::Travel travel);

struct Ball {
  Point p_S_centre = Point::Zero();  ///< mm, from the gauge point at spindle angle 0
  double radius_mm = 0.0;            ///< > 0
};

/// A body on the tool's side.
struct ToolBody {
  std::string name;
  Role role = Role::Rigid;
  std::variant<Ball, ProbeSection> shape;  ///< a section stands at its place from the first ball
  Mount mount = Mount::Spindle;
  bool gives_way = false;  ///< with the tip that it holds, when that is pushed in
};

/// A body on the work's side, where it stands.
struct ProbedPart {
  std::string name;
  parts::Mesh mesh_M;  ///< mm, machine frame; what axes carry, where these stand at 0
  Role role = Role::Part;
  Mount mount = Mount::Table;
  std::size_t link = 0;  ///< of the chain of axes, mounted there
  bool is_solid = true;  ///< its mesh is the surface of a solid: there is an inside
  /// What balls and sensors meet instead of the mesh, which stands for it (contact_mesh.h).
  std::optional<parts::Sphere> sphere_M = std::nullopt;
};

/// A touch probe as what it is made of: its balls, the main one first, what holds them, and what is
/// above.
std::vector<ToolBody> bodies_of(const ProbeSetup& setup);

}  // namespace g31::probe
