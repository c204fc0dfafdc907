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
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "machine/base/result.h"
#include "parts/import/step_shape.h"
#include "parts/import/vertex_weld.h"

namespace g31::parts {
namespace {

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
    mesh.triangles.push_back(corners);
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

Result<Mesh, std::string> read_faces(const std::string& path, double sagitta_mm,
                                     std::vector<RoundWall>& walls) {
  STEPControl_Reader reader;
  const auto read = read_step_shape(path, reader);
  if (!read) {
    return read.error();
  }
  const TopoDS_Shape& shape = read.value();
  IMeshTools_Parameters fine;
  fine.Deflection = sagitta_mm;
  fine.Angle = 0.5;  // rad between facets
  // The other one takes a time that grows with the square of the points of a face: a plate with 150
  // holes took 12 s.
  fine.MeshAlgo = IMeshTools_MeshAlgoType_Delabella;
  const BRepMesh_IncrementalMesh mesher(shape, fine);
  Mesh mesh;
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

bool g31_read_step(const char* path, double sagitta_mm, g31::parts::Mesh* mesh,
                   std::vector<g31::parts::RoundWall>* walls, std::string* error) {
  try {
    auto read = g31::parts::read_faces(path, sagitta_mm, *walls);
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
