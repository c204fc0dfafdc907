#include "parts/solids/described_face.h"

#include <algorithm>

#include <BOPTools_AlgoTools3D.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Face.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

namespace g31::parts {
namespace {

constexpr double kToleranceMm = 1e-6;

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

FaceDescriber::FaceDescriber(const TopoDS_Shape& product) : context_(new IntTools_Context) {
  for (TopExp_Explorer each(product, TopAbs_SOLID); each.More(); each.Next()) {
    solids_.push_back(std::make_unique<BRepClass3d_SolidClassifier>(each.Current()));
  }
  for (TopExp_Explorer each(product, TopAbs_FACE); each.More(); each.Next()) {
    ProductFace& added = faces_.emplace_back();
    added.face = TopoDS::Face(each.Current());
    BRepBndLib::Add(added.face, added.box);
    added.box.Enlarge(kToleranceMm);
  }
}

bool FaceDescriber::is_on_product(const Point& p_P) const {
  const gp_Pnt p(p_P.x(), p_P.y(), p_P.z());
  // Most points are: a face tells it quicker than the solid, which goes through all of its edges.
  const bool is_on_face = std::ranges::any_of(faces_, [&](const ProductFace& each) {
    return !each.box.IsOut(p) && context_->IsValidPointForFace(p, each.face, kToleranceMm);
  });
  return is_on_face || std::ranges::any_of(solids_, [&](const auto& solid) {
           solid->Perform(p, kToleranceMm);
           return solid->State() != TopAbs_OUT;
         });
}

RemovedFace FaceDescriber::described(const TopoDS_Face& shape) {
  RemovedFace face;
  take_surface(shape, face);
  take_border(shape, face);
  gp_Pnt at;
  gp_Pnt2d uv;
  BOPTools_AlgoTools3D::PointInFace(shape, at, uv, context_);
  gp_Vec normal;
  BRepGProp_Face(shape).Normal(uv.X(), uv.Y(), at, normal);
  face.at_P = point_of(at);
  face.normal_P = Point(normal.X(), normal.Y(), normal.Z()).normalized();
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  face.area_mm2 = properties.Mass();
  face.is_open = !is_on_product(face.at_P);
  return face;
}

}  // namespace g31::parts
