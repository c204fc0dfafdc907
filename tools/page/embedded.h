#pragma once

#include <string>
#include <string_view>

namespace g31::page {

/// A script element that holds JSON for the page's script: as it is, or, beyond a mebibyte,
/// compressed by gzip, in base64, with data-encoding="gzip".  The same text makes the same bytes.
std::string embedded(std::string_view id, std::string_view json);

}  // namespace g31::page
