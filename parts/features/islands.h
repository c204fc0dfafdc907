#pragma once

#include <vector>

#include "parts/features/removed_volume.h"

namespace g31::parts {

/// The faces of a volume by what they go round.
struct FacesAround {
  using Faces = std::vector<const RemovedFace*>;
  Faces outer;  ///< its outline, and all that is level
  std::vector<Faces>
      islands;  ///< each the faces of what stands in it and touches its outline nowhere
};

/// Finds the islands of a volume: faces that hang together by the ends of their edges, level ones
/// left out.
FacesAround faces_around(const RemovedVolume& volume);

}  // namespace g31::parts
