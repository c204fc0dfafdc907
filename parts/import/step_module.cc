// The faces of a STEP file as triangles, in the module g31_step.

#include "parts/import/step_module.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <fmt/format.h>

#include "machine/base/result.h"
#include "parts/import/face_mesher.h"
#include "parts/import/step_shape.h"
#include "parts/import/vertex_weld.h"

namespace g31::parts {
namespace {

std::uint64_t face_count(const TopoDS_Shape& shape) {
  std::uint64_t count = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    ++count;
  }
  return count;
}

/// Adds the triangles of a face that was meshed before; a face without any adds nothing.
void add_face(const TopoDS_Face& face, Mesh& mesh, VertexWeld& weld) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
  if (triangles.IsNull()) {
    return;
  }
  const bool is_turned = face.Orientation() == TopAbs_REVERSED;
  for (int i = 1; i <= triangles->NbTriangles(); ++i) {
    std::array<int, 3> nodes{};
    triangles->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const gp_Pnt p = triangles->Node(nodes[corner]).Transformed(location.Transformation());
      corners[is_turned ? 2 - corner : corner] = weld.vertex_at({p.X(), p.Y(), p.Z()});
    }
    // What has two corners in one place, as at the apex of a cone, is no facet.
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      mesh.triangles.push_back(corners);
    }
  }
}

/// Notes the triangles of a face from `first` on, where it is an upright cylinder.
void note_round_wall(const TopoDS_Face& face, std::size_t first, const Mesh& mesh,
                     std::vector<RoundWall>& walls) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  if (surface.GetType() != GeomAbs_Cylinder) {
    return;
  }
  constexpr double kUpright = 1e-12;
  const gp_Ax1 axis = surface.Cylinder().Axis();
  if (std::hypot(axis.Direction().X(), axis.Direction().Y()) < kUpright) {
    const gp_Pnt at = axis.Location();
    walls.push_back(
        {{at.X(), at.Y(), at.Z()}, surface.Cylinder().Radius(), first, mesh.triangles.size()});
  }
}

/// The first face that the mesher did not get whole, and what to do; "": none.
std::string unmeshed_face(const TopoDS_Shape& shape, double sagitta_mm) {
  int number = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    ++number;
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    if (is_meshed_whole(face, sagitta_mm)) {
      continue;
    }
    const TopExp_Explorer corner(face, TopAbs_VERTEX);
    const gp_Pnt at =
        corner.More() ? BRep_Tool::Pnt(TopoDS::Vertex(corner.Current())) : gp_Pnt(0.0, 0.0, 0.0);
    return fmt::format(
        "Open CASCADE does not cover its face {} ({} X{:.3f} Y{:.3f} Z{:.3f}) with facets that are "
        "off by at most {:g} mm: where its outline crosses itself, mend that in the CAD system; "
        "else give another step_sagitta, or save the part as STL, OBJ, PLY or 3MF",
        number, corner.More() ? "with a corner at" : "without corners, at", at.X() + 0.0,
        at.Y() + 0.0, at.Z() + 0.0, sagitta_mm);
  }
  return "";
}

/// Gives the faces triangles: surely where the quick way fails.
/// @returns what is wrong, or ""
std::string mesh_all_faces(const TopoDS_Shape& shape, const StepReading& reading) {
  mesh_faces(shape, reading.sagitta_mm, reading.mesher);
  std::string wrong = unmeshed_face(shape, reading.sagitta_mm);
  if (wrong.empty() || reading.mesher == FaceMesher::Sure) {
    return wrong;
  }
  mesh_faces(shape, reading.sagitta_mm, FaceMesher::Sure);
  return unmeshed_face(shape, reading.sagitta_mm);
}

Result<Mesh, std::string> read_faces(const StepReading& reading, std::vector<RoundWall>& walls) {
  STEPControl_Reader reader;
  const auto read = read_step_shape(reading.path, reader);
  if (!read) {
    return read.error();
  }
  const TopoDS_Compound bodies = bodies_in(read.value());
  const TopoDS_Shape& shape = bodies.IsNull() ? read.value() : bodies;
  if (std::string wrong = mesh_all_faces(shape, reading); !wrong.empty()) {
    return wrong;
  }
  Mesh mesh;
  mesh.faces_left_out = face_count(read.value()) - face_count(shape);
  VertexWeld weld(mesh);
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    const std::size_t first = mesh.triangles.size();
    add_face(TopoDS::Face(faces.Current()), mesh, weld);
    note_round_wall(TopoDS::Face(faces.Current()), first, mesh, walls);
  }
  if (mesh.triangles.empty()) {
    return std::string("it holds no faces; expected a body or a surface, not lines or points");
  }
  return mesh;
}

}  // namespace

}  // namespace g31::parts

bool g31_read_step(const g31::parts::StepReading& reading, g31::parts::Mesh* mesh,
                   std::vector<g31::parts::RoundWall>* walls, std::string* error) {
  try {
    auto read = g31::parts::read_faces(reading, *walls);
    if (read) {
      *mesh = std::move(read.value());
      return true;
    }
    *error = read.error();
  } catch (const Standard_Failure& failure) {
    *error = "not understood as STEP (" + std::string(failure.GetMessageString()) + ")";
  }
  return false;
}
