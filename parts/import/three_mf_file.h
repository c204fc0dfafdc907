#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::parts {

/// Checks a 3MF file, a zip archive, before anything of it is read, and finds its unit of length.
///
/// Its size unpacked is judged by its directory before anything is unpacked; then each file is
/// unpacked and held against its checksum, and each model is seen to end.
/// @returns mm: what one unit of its models is; what is wrong, without the path
Result<double, std::string> unit_of_3mf(std::string_view bytes);

}  // namespace g31::parts
