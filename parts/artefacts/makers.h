#pragma once

#include <map>
#include <string>

#include "machine/base/result.h"
#include "parts/artefacts/part_setup.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// The sizes of one shape by name, all of them; each a finite number > 0, or 0 for a rounding that
/// is none.
using Sizes = std::map<std::string, double>;

/// What makes the mesh of a shape in the part frame, or says which sizes do not fit each other.
/// shapes.def says what each size means and where the part's origin lies.
using Maker = Result<Mesh, std::string> (*)(const Sizes&);
/// The same of a shape with a known error.
using ProfiledMaker = Result<Mesh, std::string> (*)(const Sizes&, const ShapeProfile&);

// Round shapes: facets are tangent to the true surface at their middle, with facet middles on the
// axes (the reason stands in ring_gauge.h).
Result<Mesh, std::string> make_ring(const Sizes& sizes);
Result<Mesh, std::string> make_cylinder(const Sizes& sizes);
Result<Mesh, std::string> make_plug(const Sizes& sizes);
Result<Mesh, std::string> make_sphere(const Sizes& sizes);
Result<Mesh, std::string> make_prism(const Sizes& sizes);

// Shapes of plane faces; a pocket may have round corners.
Result<Mesh, std::string> make_block(const Sizes& sizes);
Result<Mesh, std::string> make_gauge_block(const Sizes& sizes);
Result<Mesh, std::string> make_pocket(const Sizes& sizes);
Result<Mesh, std::string> make_groove(const Sizes& sizes);
Result<Mesh, std::string> make_rib(const Sizes& sizes);
Result<Mesh, std::string> make_step(const Sizes& sizes);

// Long pieces with a known shape error, for what measures machines.
Result<Mesh, std::string> make_bed(const Sizes& sizes, const ShapeProfile& profile);
Result<Mesh, std::string> make_shaft(const Sizes& sizes, const ShapeProfile& profile);

}  // namespace g31::parts
