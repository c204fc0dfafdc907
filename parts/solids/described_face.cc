#include "parts/solids/described_face.h"

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Face.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IntTools_Context.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

namespace g31::parts {
namespace {

Point point_of(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}

void take_axis(const gp_Ax1& axis, RemovedFace& face) {
  face.axis_at_P = point_of(axis.Location());
  face.axis_P = {axis.Direction().X(), axis.Direction().Y(), axis.Direction().Z()};
}

void take_surface(const TopoDS_Face& shape, RemovedFace& face) {
  const BRepAdaptor_Surface surface(shape, Standard_False);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      face.surface = FaceSurface::Plane;
      break;
    case GeomAbs_Cylinder:
      face.surface = FaceSurface::Cylinder;
      face.radius_mm = surface.Cylinder().Radius();
      take_axis(surface.Cylinder().Axis(), face);
      break;
    case GeomAbs_Cone:
      face.surface = FaceSurface::Cone;
      take_axis(surface.Cone().Axis(), face);
      break;
    case GeomAbs_Sphere:
      face.surface = FaceSurface::Sphere;
      face.radius_mm = surface.Sphere().Radius();
      face.axis_at_P = point_of(surface.Sphere().Location());
      break;
    case GeomAbs_Torus:
      face.surface = FaceSurface::Torus;
      face.radius_mm = surface.Torus().MinorRadius();
      take_axis(surface.Torus().Axis(), face);
      break;
    case GeomAbs_BezierSurface:
    case GeomAbs_BSplineSurface:
    case GeomAbs_SurfaceOfRevolution:
    case GeomAbs_SurfaceOfExtrusion:
    case GeomAbs_OffsetSurface:
    case GeomAbs_OtherSurface:
      face.surface = FaceSurface::Other;
  }
}

void take_border(const TopoDS_Face& shape, RemovedFace& face) {
  constexpr int kPieces = 16;  // even: the middle is among the points
  for (TopExp_Explorer each(shape, TopAbs_EDGE); each.More(); each.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(each.Current());
    if (BRep_Tool::Degenerated(edge)) {
      continue;
    }
    const BRepAdaptor_Curve curve(edge);
    const int pieces = curve.GetType() == GeomAbs_Line ? 1 : kPieces;
    const double from = curve.FirstParameter();
    const double to = curve.LastParameter();
    for (int i = 0; i <= pieces; ++i) {
      face.border_P.push_back(point_of(curve.Value(from + (to - from) * i / pieces)));
    }
  }
}

}  // namespace

RemovedFace described(const TopoDS_Face& shape, bool is_open) {
  RemovedFace face;
  face.is_open = is_open;
  take_surface(shape, face);
  take_border(shape, face);
  gp_Pnt at;
  gp_Pnt2d uv;
  const Handle(IntTools_Context) context = new IntTools_Context;
  BOPTools_AlgoTools3D::PointInFace(shape, at, uv, context);
  gp_Vec normal;
  BRepGProp_Face(shape).Normal(uv.X(), uv.Y(), at, normal);
  face.at_P = point_of(at);
  face.normal_P = Point(normal.X(), normal.Y(), normal.Z()).normalized();
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  face.area_mm2 = properties.Mass();
  return face;
}

}  // namespace g31::parts
