#pragma once

#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/box.h"

namespace g31::parts {

enum class FaceSurface { Plane, Cylinder, Cone, Sphere, Torus, Other };

/// A face of a removed volume; product frame P, mm.
struct RemovedFace {
  FaceSurface surface = FaceSurface::Plane;
  /// Whether no material of the product is behind it: it lies on the stock's surface, or the volume
  /// goes on there as another one.
  bool is_open = false;
  Point at_P = Point::Zero();       ///< a point in its inside
  Point normal_P = Point::UnitZ();  ///< there, unit: out of the removed volume
  Point axis_at_P = Point::Zero();  ///< a point on the axis of a cylinder, cone or torus
  Point axis_P = Point::UnitZ();    ///< unit
  double radius_mm = 0.0;           ///< of a cylinder or sphere; of a torus that of its tube
  double area_mm2 = 0.0;            ///< > 0
  double facet_error_mm = 0.0;      ///< how far the product's facets are from it, > 0 of a mesh
  std::vector<Point> border_P;      ///< the ends of its edges, and points along curved ones
};

/// What is cut from the stock in one piece, down to a floor: all of its floors are at one height.
struct RemovedVolume {
  Box box_P;  ///< exact to 1e-6 mm
  double volume_mm3 = 0.0;
  std::vector<RemovedFace> faces;  ///< all round it
  /// Whether it is beside the product's box, seen from above, not divided any further: the stock is
  /// wider there.
  bool is_beside = false;
  double rounding_mm = 0.0;  ///< by how much coordinates of the meshes that it is from may be off
};

}  // namespace g31::parts
