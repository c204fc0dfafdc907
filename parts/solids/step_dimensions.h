#pragma once

#include <optional>
#include <vector>

#include <STEPControl_Reader.hxx>
#include <TopoDS_Face.hxx>

// A file of the module g31_step; functions throw what Open CASCADE throws.

namespace g31::parts {

/// A dimension of a STEP file (AP242, ISO 10303-47): a size or a distance.
struct StepDimension {
  double nominal_mm = 0.0;
  std::optional<double> lower_mm;
  std::optional<double> upper_mm;
  std::vector<TopoDS_Face> faces;
};

/// The lengths among the dimensions of a file whose roots are transferred, with plus-minus
/// tolerances or limits; of a composite aspect the faces of its members.  Radii, angles and fits
/// are left out, and dimensions of no faces.
std::vector<StepDimension> dimensions_of(const STEPControl_Reader& reader);

}  // namespace g31::parts
