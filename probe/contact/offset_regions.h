#pragma once

#include <vector>

#include "parts/geometry/bvh.h"
#include "probe/contact/offset_surface.h"

namespace g31::probe {

/// A piece of the offset surface that is cut into patches when a ball first comes there: what
/// belongs to some triangles that lie together.
struct OffsetRegion {
  parts::Bvh::SlotRange triangles;
  Point side = Point::Zero();  ///< only what lies on this side of the triangles; 0: all of it
  parts::Box box;              ///< around it, mm
};

/// Whether much of the surface is hidden, so that looking for it is worth its while: most triangles
/// are smaller than the ball and bend away from others more sharply than it.
bool is_rough_and_fine(const OffsetSurface& surface);

/// The whole offset surface in regions: a ball that starts free and meets the mesh does so with its
/// centre in the box of one of them.
///
/// Where the mesh is a sheet without border that bends little, there is a region on either side of
/// it, as thin as its normals allow; elsewhere one around the triangles, larger by the radius.
std::vector<OffsetRegion> offset_regions(const OffsetSurface& surface);

}  // namespace g31::probe
