#pragma once

#include <optional>
#include <vector>

#include "interpreter/path/path_block.h"

namespace g31::path {

/// How the compensation begins and ends at outside corners.
enum class StartUp {
  TypeA,  ///< straight to the point beside the start of the next block
  TypeB,  ///< around the corner, as in the middle of the path
};

/// How the tool centre gets round an outside corner in the middle of the path.
enum class OutsideCorner {
  Lines,         ///< the intersection up to a right turn of 90 degrees, else two lines more
  Arc,           ///< an arc about the corner, its radius the offset
  Intersection,  ///< the intersection up to kSharpestDeg, else an arc
};

/// A turn beyond this is too sharp for the intersection, degrees.
inline constexpr double kSharpestDeg = 100.0;

/// The points that the tool centre passes at a corner of the programmed path.  The block in front
/// of the corner ends at the first, the block behind it begins at the last, straight lines in
/// between.
using CornerPoints = std::vector<PlanePoint>;

/// The corner of two ways; the first ends where the second begins.
///
/// Offsets are mm, positive to the left of the direction of travel (G41 with a positive radius).
/// They have the same size; with opposite signs the tool changes the side there.
struct Corner {
  const PlaneWay& before;
  const PlaneWay& behind;
  double offset_before = 0.0;
  double offset_behind = 0.0;
  /// mm; of two points nearer to one another than this in both axes the second is left out.
  double minute_mm = 0.0;
  OutsideCorner outside = OutsideCorner::Lines;
};

/// The point beside the start or the end of a way, at a right angle to it.
PlanePoint beside_start(const PlaneWay& way, double offset);
PlanePoint beside_end(const PlaneWay& way, double offset);

/// Radius of an arc offset by `offset`: negative when the tool does not fit into it.
double offset_radius(const ArcShape& arc, const PlanePoint& p, double offset);

/// A corner in the middle of the compensated path.
///
/// Inside corners, and outside ones up to a right turn of 90 degrees: the intersection, of tangents
/// where an arc is outside.  Sharper outside corners: each way is extended by the radius and the
/// ends are joined.  No arc is put in, unless `outside` asks for it: then corner_arc is the way
/// from the first point to the second.
/// @returns nullopt when there is no intersection
/// Accuracy: kCornerErrorMm for radii up to 100 mm and arcs up to 1 m.
std::optional<CornerPoints> corner_points(const Corner& corner);

/// The arc that leads from the first point of a corner to the second; nullopt: straight lines do.
std::optional<ArcShape> corner_arc(const Corner& corner);

/// The corner at the end of the start-up block, which the tool leaves the programmed path with.
/// With TypeB and arcs at corners it ends on the tangent to that arc; empty when it begins within
/// it.
CornerPoints start_up_points(const Corner& corner, StartUp type);

/// The corner at the beginning of the cancel block.
CornerPoints cancel_points(const Corner& corner, StartUp type);

/// How far a corner point may stand off the exact one: nearly tangent arcs decide it.
inline constexpr double kCornerErrorMm = 2e-6;

}  // namespace g31::path
