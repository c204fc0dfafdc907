#pragma once

#include <cstddef>

#include "parts/geometry/mesh.h"

namespace g31::picture {

/// Mends the folds that thinning leaves in a smooth surface: its flattest triangles stand askew on
/// it or lie over others, so that it seems to have edges.
///
/// Two triangles of the same corners go.  Where two bend against each other, the other diagonal of
/// their four corners takes the place of their edge, or one triangle that of the three about a
/// corner, if the surface bends less with it.  Corners stay where they are; edges with more than
/// two triangles stay as they are.
/// @param most_error_mm  > 0: no farther is the surface moved in one step
void mend_folds(parts::Mesh& mesh, double most_error_mm);

/// How many edges a mesh seems to have.
struct Folds {
  std::size_t seen = 0;  ///< as drawings show them
  std::size_t back = 0;  ///< of these, that lie all but back on themselves
};
Folds count_folds(const parts::Mesh& mesh);

/// Whether a mesh that stands for another one seems to have more than that.
inline bool has_more(const Folds& few, const Folds& whole) {
  return few.seen > whole.seen || few.back > whole.back;
}

}  // namespace g31::picture
