#include "parts/solids/solid_shape.h"

#include <array>
#include <cmath>
#include <utility>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <fmt/format.h>

#include "parts/import/step_shape.h"

namespace g31::parts {
namespace {

using Solids = Result<SourceSolids, std::string>;

/// Coordinates of mesh files are no better (float32).
constexpr double kMeshToleranceMm = 1e-5;

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  return map.Extent();
}

std::string too_many(const std::string& name, std::size_t faces) {
  return fmt::format("{}: it has {} faces; a part of up to {} can be planned", name, faces,
                     kMostFaces);
}

/// What a closed shell encloses.
TopoDS_Solid solid_in(const TopoDS_Shell& shell) {
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape joined(const TopoDS_Shape& shape, double tolerance_mm) {
  ShapeUpgrade_UnifySameDomain unify(shape);
  if (tolerance_mm > 0.0) {
    unify.SetLinearTolerance(tolerance_mm);
    unify.SetAngularTolerance(tolerance_mm);
  }
  unify.Build();
  return unify.Shape();
}

Solids from_step(const SolidSource& source) {
  STEPControl_Reader reader;
  const auto read = read_step_shape(source.step_path, reader);
  if (!read) {
    return source.name + ": " + read.error();
  }
  const TopoDS_Compound bodies = bodies_in(read.value());
  if (bodies.IsNull()) {
    return source.name + ": it holds no solid; expected a body, not surfaces, lines or points";
  }
  TopoDS_Compound solids;
  const BRep_Builder builder;
  builder.MakeCompound(solids);
  for (TopoDS_Iterator each(bodies); each.More(); each.Next()) {
    const TopoDS_Shape& body = each.Value();
    builder.Add(solids, body.ShapeType() == TopAbs_SHELL ? solid_in(TopoDS::Shell(body)) : body);
  }
  const int faces = count_of(solids, TopAbs_FACE);
  if (faces > kMostFaces) {
    return too_many(source.name, static_cast<std::size_t>(faces));
  }
  std::vector<StepDimension> dimensions = dimensions_of(reader);
  if (!BRepCheck_Analyzer(solids).IsValid()) {
    ShapeFix_Shape fix(solids);
    fix.Perform();
    return SourceSolids{joined(fix.Shape(), 0.0), std::move(dimensions)};
  }
  return SourceSolids{joined(solids, 0.0), std::move(dimensions)};
}

Solids from_mesh(const SolidSource& source) {
  if (source.mesh.triangles.size() > static_cast<std::size_t>(kMostFaces)) {
    return too_many(source.name, source.mesh.triangles.size());
  }
  BRepBuilderAPI_Sewing sewing(kMeshToleranceMm);
  for (const auto& triangle : source.mesh.triangles) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const auto vertex : triangle) {
      const Point& p = source.mesh.vertices[vertex];
      polygon.Add(gp_Pnt(p.x(), p.y(), p.z()));
    }
    polygon.Close();
    if (polygon.IsDone()) {
      const BRepBuilderAPI_MakeFace face(polygon.Wire(), Standard_True);
      if (face.IsDone()) {
        sewing.Add(face.Face());
      }
    }
  }
  sewing.Perform();
  TopoDS_Compound solids;
  BRep_Builder builder;
  builder.MakeCompound(solids);
  bool is_closed = false;
  for (TopExp_Explorer each(sewing.SewedShape(), TopAbs_SHELL); each.More(); each.Next()) {
    const TopoDS_Shell& shell = TopoDS::Shell(each.Current());
    is_closed = BRep_Tool::IsClosed(shell);
    if (!is_closed) {
      break;
    }
    builder.Add(solids, solid_in(shell));
  }
  if (!is_closed) {
    return source.name + ": its surface is not closed; expected that of a solid";
  }
  return SourceSolids{joined(solids, kMeshToleranceMm), {}};
}

}  // namespace

Solids solids_of(const SolidSource& source) {
  return source.step_path.empty() ? from_mesh(source) : from_step(source);
}

Box box_around(const TopoDS_Shape& shape) {
  Bnd_Box bounds;
  BRepBndLib::AddOptimal(shape, bounds, Standard_False, Standard_False);
  bounds.SetGap(0.0);
  Box box;
  bounds.Get(box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z());
  Box of_vertices;
  for (TopExp_Explorer each(shape, TopAbs_VERTEX); each.More(); each.Next()) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(each.Current()));
    of_vertices.include(Point(p.X(), p.Y(), p.Z()));
  }
  // The bounds are wide by some 1e-7 mm, vertices are exact.
  constexpr double kWideMm = 1e-5;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(box.min[axis] - of_vertices.min[axis]) < kWideMm) {
      box.min[axis] = of_vertices.min[axis];
    }
    if (std::abs(box.max[axis] - of_vertices.max[axis]) < kWideMm) {
      box.max[axis] = of_vertices.max[axis];
    }
  }
  return box;
}

}  // namespace g31::parts
