#pragma once

#include <string>
#include <string_view>

#include "tools/plot/growth.h"

namespace g31::page {

/// A script element that holds JSON for the page's script: as it is, or, beyond a mebibyte,
/// compressed by gzip, in base64, with data-encoding="gzip".  The same text makes the same bytes.
/// @param growth  told of it as it is compressed; may end the work
std::string embedded(std::string_view id, std::string_view json, const plot::Growth& growth = {});

}  // namespace g31::page
