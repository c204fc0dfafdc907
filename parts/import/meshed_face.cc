#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "parts/import/face_mesher.h"

namespace g31::parts {
namespace {

/// Directed links between nodes, of which opposite ones cancel.
class NodeLinks {
 public:
  void add(int from, int to) {
    links_.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
  }

  /// Whether none is left over.
  bool cancel() {
    std::ranges::sort(links_, {}, &Link::ends);
    for (std::size_t i = 0; i < links_.size();) {
      int left = 0;
      const auto ends = links_[i].ends();
      for (; i < links_.size() && links_[i].ends() == ends; ++i) {
        left += ends.first == ends.second ? 0 : links_[i].times;
      }
      if (left != 0) {
        return false;
      }
    }
    return true;
  }

 private:
  struct Link {
    int low;
    int high;
    int times;

    [[nodiscard]] std::pair<int, int> ends() const { return {low, high}; }
  };
  std::vector<Link> links_;
};

using Nodes = std::array<int, 3>;

Nodes nodes_of(const Poly_Triangulation& triangles, int number) {
  Nodes nodes{};
  triangles.Triangle(number).Get(nodes[0], nodes[1], nodes[2]);
  return nodes;
}

/// Twice the area of a triangle in the parameters of the surface, negative where it turns the
/// wrong way.
double turn_of(const Poly_Triangulation& triangles, const Nodes& nodes) {
  const gp_XY first = triangles.UVNode(nodes[0]).XY();
  return (triangles.UVNode(nodes[1]).XY() - first) ^ (triangles.UVNode(nodes[2]).XY() - first);
}

double area_of(const Poly_Triangulation& triangles, const Nodes& nodes) {
  const gp_XYZ first = triangles.Node(nodes[0]).XYZ();
  return (triangles.Node(nodes[1]).XYZ() - first)
             .Crossed(triangles.Node(nodes[2]).XYZ() - first)
             .Modulus() /
         2.0;
}

using Polygon = Handle(Poly_PolygonOnTriangulation);

/// The edges of a face as they run around its triangles.
class FaceOutline {
 public:
  FaceOutline(const TopoDS_Face& face, Handle(Poly_Triangulation) triangles,
              TopLoc_Location location)
      // Triangles are those of the surface, whichever side of it is the face's.
      : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))),
        triangles_(std::move(triangles)),
        location_(std::move(location)) {
    for (TopExp_Explorer edges(face_, TopAbs_EDGE); edges.More(); edges.Next()) {
      add(TopoDS::Edge(edges.Current()));
    }
  }

  [[nodiscard]] bool has_all() const { return has_all_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] NodeLinks& links() { return links_; }

 private:
  void add(const TopoDS_Edge& edge) {
    const bool is_forward = edge.Orientation() == TopAbs_FORWARD;
    if (!is_forward && edge.Orientation() != TopAbs_REVERSED) {
      return;  // it lies within the face: triangles are on both its sides
    }
    const Polygon polygon = polygon_of(edge);
    if (polygon.IsNull()) {
      has_all_ = has_all_ && BRep_Tool::Degenerated(edge);
      return;
    }
    for (int i = 1; i < polygon->NbNodes(); ++i) {
      const int from = polygon->Node(i);
      const int to = polygon->Node(i + 1);
      length_ += triangles_->Node(from).Distance(triangles_->Node(to));
      // Against the sense of the triangles beside it.
      links_.add(is_forward ? to : from, is_forward ? from : to);
    }
  }

  [[nodiscard]] Polygon polygon_of(const TopoDS_Edge& edge) const {
    Polygon polygon = BRep_Tool::PolygonOnTriangulation(edge, triangles_, location_);
    if (polygon.IsNull() || !triangles_->HasUVNodes() || !BRep_Tool::IsClosed(edge, face_)) {
      return polygon;
    }
    // The seam of a round face has two, and Open CASCADE does not always give that of the side.
    const Polygon other =
        BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(edge.Reversed()), triangles_, location_);
    double first = 0.0;
    double last = 0.0;
    const auto curve = BRep_Tool::CurveOnSurface(edge, face_, first, last);
    if (other.IsNull() || curve.IsNull()) {
      return polygon;
    }
    const gp_Pnt2d begin = curve->Value(first);
    const auto off = [&](const Polygon& any) {
      return triangles_->UVNode(any->Node(1)).SquareDistance(begin);
    };
    return off(other) < off(polygon) ? other : polygon;
  }

  TopoDS_Face face_;
  Handle(Poly_Triangulation) triangles_;
  TopLoc_Location location_;
  NodeLinks links_;
  double length_ = 0.0;
  bool has_all_ = true;
};

/// Whether what is wrong about the triangles of a face is less than the sagitta everywhere.
bool is_sliver(const TopoDS_Face& face, double sagitta_mm) {
  GProp_GProps lengths;
  GProp_GProps areas;
  BRepGProp::LinearProperties(face, lengths);
  BRepGProp::SurfaceProperties(face, areas);
  return std::abs(areas.Mass()) <= sagitta_mm * lengths.Mass();
}

}  // namespace

bool is_meshed_whole(const TopoDS_Face& face, double sagitta_mm) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
  if (triangles.IsNull()) {
    return is_sliver(face, sagitta_mm);
  }
  FaceOutline outline(face, triangles, location);
  double turned_area = 0.0;
  for (int i = 1; i <= triangles->NbTriangles(); ++i) {
    const Nodes nodes = nodes_of(*triangles, i);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      outline.links().add(nodes[k], nodes[(k + 1) % nodes.size()]);
    }
    if (triangles->HasUVNodes() && turn_of(*triangles, nodes) < 0.0) {
      turned_area += area_of(*triangles, nodes);
    }
  }
  // Chords of edges that come nearer to each other than the sagitta may cross.
  const bool is_whole =
      outline.has_all() && outline.links().cancel() && turned_area <= sagitta_mm * outline.length();
  return is_whole || is_sliver(face, sagitta_mm);
}

}  // namespace g31::parts
