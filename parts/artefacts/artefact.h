#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "parts/artefacts/part_setup.h"
#include "parts/geometry/mesh.h"
#include "parts/geometry/sphere.h"

namespace g31::parts {

/// What a number about a shape is.
enum class Quantity : std::uint8_t {
  Length,  ///< mm
  Angle,   ///< degrees
  Count,
};

/// "mm", "deg" or "none".
std::string_view unit_of(Quantity quantity);

/// One size of a shape, a row of shapes.def.
struct ShapeSize {
  std::string_view shape;
  std::string_view name;
  std::optional<double> default_value;  ///< none: what stands in for it (worked_out.h), see text
  Quantity quantity = Quantity::Length;
  std::string_view text;
};

/// One shape, a row of shapes.def.
struct Shape {
  std::string_view name;
  std::string_view text;
};

/// All shapes and all their sizes, in the order of shapes.def.
std::span<const Shape> shapes();
std::span<const ShapeSize> shape_sizes();

/// A number about a shape.
struct Measure {
  double value = 0.0;
  Quantity quantity = Quantity::Length;
};

/// What the part's shape measures: a size as it is given or as the shape has it, or what the
/// shape works out from its sizes (worked_out.h); nullopt: the shape has nothing of that name.
std::optional<Measure> size_of(const PartSetup& part, const std::string& name);

/// Makes the mesh of the part's `shape` with its `sizes`, in the part frame P.
///
/// Error: one line that names the part and says what is wrong: unknown shape or size (with the
/// nearest known name), a size that is not a positive number or beyond kLargestSizeMm, sizes that
/// do not fit each other.
Result<Mesh, std::string> make_artefact(const PartSetup& part);

/// The sphere that a shape is, in the part frame P; nullopt: its surface is that of its mesh.  The
/// facets of the mesh are tangent to it.  @pre make_artefact makes the part
std::optional<Sphere> exact_sphere(const PartSetup& part);

/// A kilometre: beyond it single precision has nothing left for the shape.
inline constexpr double kLargestSizeMm = 1e6;

}  // namespace g31::parts
