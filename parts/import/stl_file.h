#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Whether a file of this beginning (84 bytes, or all of a shorter one) and size is a binary STL:
/// its size fits its number of facets, or it does not begin like a text.
bool is_binary_stl(std::string_view beginning, std::uint64_t size);

/// Reads a binary STL, which stands at its beginning: 80 bytes, the number of facets, 50 bytes for
/// each.  Its normals and attributes count for nothing; corners in the same place are joined.  No
/// coordinate is looked at: they may be infinite, or no numbers (then never joined).
///
/// Error: without the path; the size is not what the number of facets needs, no facets, too many.
Result<Mesh, std::string> read_binary_stl(std::istream& file, std::uint64_t size,
                                          const GoesOn& goes_on = {});

/// Reads the text form: solid, facets, endsolid, and again.  Numbers become double as they stand;
/// how far they are rounded their digits say.
///
/// @param mm_per_unit  > 0: what the numbers count
/// Error: without the path, with the line: cut off, a word that does not belong there, a number
/// that is none.
Result<Mesh, std::string> read_text_stl(std::string_view text, double mm_per_unit,
                                        const GoesOn& goes_on = {});

}  // namespace g31::parts
