#pragma once

#include <string>
#include <string_view>

namespace g31::picture {

/// Bytes in the letters of RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

}  // namespace g31::picture
