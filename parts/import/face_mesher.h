#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "parts/import/step_module.h"

// A file of the module g31_step.

namespace g31::parts {

/// Gives all faces of a shape triangles, those that it had are forgotten.
///
/// Corners are on the true surfaces, and no edge is farther from them than the sagitta.
/// Delabella's way (of 7.6) takes rounding for shape where all corners of a face but one lie on a
/// circle, as in a quarter of a disc: it leaves holes, never ends or breaks off with the process.
void mesh_faces(const TopoDS_Shape& shape, double sagitta_mm, FaceMesher mesher);

/// Whether the triangles of a face cover it once: their rim is that of its edges, and they turn one
/// way in the parameters of its surface.  A face that is nowhere wider than the sagitta may be
/// without.
bool is_meshed_whole(const TopoDS_Face& face, double sagitta_mm);

}  // namespace g31::parts
