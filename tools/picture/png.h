#pragma once

#include <string>
#include <string_view>

namespace g31::picture {

/// A picture as a PNG file.
/// @param pixels  rows from the top, three bytes (red, green, blue) a pixel
std::string png_of(int width, int height, std::string_view pixels);

}  // namespace g31::picture
