#pragma once

#include <cstddef>
#include <optional>

#include "parts/geometry/mesh.h"

namespace g31::picture {

/// A mesh of fewer triangles for a picture: corners of the given one, in its order.
///
/// One that has no more than most_triangles comes back as it is.  Others are simplified by
/// meshoptimizer (quadric error) until they have so few, and on until they do not seem to have
/// edges that the given one has not: in steps, and what each of them folds is mended; nullopt where
/// that is not possible within the error, or where g31 was built without it: then there is no
/// honest picture of so few triangles.
/// @param most_error_mm  > 0, of each step, by its measure: the mean distance of a corner that was
///                       taken away from the planes of the facets that it stood for
std::optional<parts::Mesh> thinned(const parts::Mesh& mesh, std::size_t most_triangles,
                                   double most_error_mm);

/// Whether g31 was built with meshoptimizer.
bool can_thin();

}  // namespace g31::picture
