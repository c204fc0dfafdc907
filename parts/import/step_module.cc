// What the module g31_step is made of, the one file that knows Open CASCADE.

#include "parts/import/step_module.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "machine/base/result.h"
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

Result<Mesh, std::string> read_faces(const std::string& path, double sagitta_mm) {
  // Open CASCADE reports on standard output, where a program's own output goes.
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0) {
    return std::string("not understood as STEP; expected a whole file with at least one body");
  }
  const TopoDS_Shape shape = reader.OneShape();
  constexpr double kWidestAngleRad = 0.5;
  const BRepMesh_IncrementalMesh mesher(shape, sagitta_mm, Standard_False, kWidestAngleRad);
  Mesh mesh;
  VertexWeld weld(mesh);
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    add_face(TopoDS::Face(faces.Current()), mesh, weld);
  }
  if (mesh.triangles.empty()) {
    return std::string("it holds no faces; expected a body or a surface, not lines or points");
  }
  return mesh;
}

}  // namespace

}  // namespace g31::parts

bool g31_read_step(const char* path, double sagitta_mm, g31::parts::Mesh* mesh,
                   std::string* error) {
  try {
    auto read = g31::parts::read_faces(path, sagitta_mm);
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
