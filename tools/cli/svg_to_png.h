#pragma once

#include <string>

#include "machine/base/result.h"

namespace g31::cli {

/// What draws SVG as pixels: a program of its own, Debian's librsvg2-bin.
inline constexpr const char* kSvgDrawer = "rsvg-convert";

/// Whether it is found along PATH.
bool has_svg_drawer();

struct PngFile {
  std::string bytes;
};

/// A drawing as a PNG file, by kSvgDrawer.  @returns why there is none
Result<PngFile, std::string> svg_to_png(const std::string& svg);

}  // namespace g31::cli
