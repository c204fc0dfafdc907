#pragma once

#include <vector>

#include <TopoDS_Shape.hxx>

#include "parts/geometry/box.h"

namespace g31::testing {

/// A block between two corners.
TopoDS_Shape block(const parts::Box& box);

/// An upright cylinder from z_min to z_max.
TopoDS_Shape pin(const Point& foot, double diameter_mm, double height_mm);

/// The stock without the cuts.
TopoDS_Shape cut(const TopoDS_Shape& stock, const std::vector<TopoDS_Shape>& cuts);

/// The product of the inspection example: stock x 0 to 160, y 0 to 110, z -40 to 0, of which are
/// cut a slot along all of X, two slots open at -Y, a pocket, two blind holes and a pocket open at
/// +X and +Y.
TopoDS_Shape inspection_product();

}  // namespace g31::testing
