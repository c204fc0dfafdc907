#pragma once

#include <TopoDS_Face.hxx>

#include "parts/features/removed_volume.h"

// A file of the module g31_step; functions throw what Open CASCADE throws.

namespace g31::parts {

/// A face as plain data.
/// @param is_open  what it is to the volume that it bounds
RemovedFace described(const TopoDS_Face& face, bool is_open);

}  // namespace g31::parts
